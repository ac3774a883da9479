// Co-rotational 3D beam element with an exact tangent, free of singularity through any number of turns.
//
// Lineage: Crisfield (1990), "A consistent co-rotational formulation for non-linear, three-dimensional
// beam-elements", CMAME 81: small-strain beam in a frame that follows the chord and the mean nodal rotation,
// force and tangent by consistent variation. Here the frame is Rm = Q1 exp(psi/2), exp(psi) = Q1' Q2, and the
// local element is a potential W(y, psi) of the chord y = Rm'(x2 - x1) and the relative rotation psi, in
// Argyris' natural modes (Argyris et al. 1979, CMAME 17-18):
//   eps = |y|/L - 1 + (a2^2 + a3^2)/10 + (psi2^2 + psi3^2)/24     axial strain of the cubic deflection
//   a2 = 2 y2/(|y| + y1), a3 = 2 y3/(|y| + y1)                     antisymmetric bending
//   W = EA L eps^2/2 + 6 EI3/(L(1+P3)) a2^2 + 6 EI2/(L(1+P2)) a3^2 + (GJ psi1^2 + EI2 psi2^2 + EI3
//   psi3^2)/(2L)
// with P = 12 EI/(GA L^2) for shear. The derivation is in docs/theory/beam.md.
#pragma once

#include "hawser/kernels/plastic_bending.hpp"
#include "hawser/kernels/response_curve.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

// Constants of one element. Stiffness-proportional damping: every stress is E (strain + beta strain rate).
struct BeamSection {
  double length = 0;        // m, unstretched
  double EA = 0;            // N
  double EI2 = 0, EI3 = 0;  // N m²
  double GJ = 0;            // N m²
  double GA = 0;            // N; 0: rigid in shear
  double beta = 0;          // s
  // Tension over strain, times EA over its slope at zero; null: linear. Damping stays that of EA.
  const ResponseCurve* tension = nullptr;
  // Bending moment over curvature, in the direction of the curvature, and on top of it what EI2 = EI3 is
  // above its slope at zero, linear; null: linear. GA is ignored then, and damping stays that of EI.
  const ResponseCurve* moment = nullptr;
  // Bending that yields and remembers, instead; null: elastic. The same of EI2, EI3, GA and damping.
  const PlasticBending* plastic = nullptr;
  // Of an element whose length follows the force that a feeder feels of it (beam_feed): the derivative of the
  // length by that force, m/N.
  double length_by_force = 0;

  bool bends_by_law() const { return moment || plastic; }
};

// Places along an element at which it remembers how it was bent.
inline constexpr int kBendingPlaces = 3;

struct BeamReference {
  // Element axes in the material axes of its nodes (columns; first along the line) and the stress-free
  // relative rotation and chord strain: zero for a straight element that has not expanded.
  const Mat3* axes = nullptr;  // not owned; null: they are the same
  Vec3 psi = Vec3::Zero();     // rad, in element axes
  double strain = 0;
  // Of plastic bending: PlasticBending::memory() numbers for each of kBendingPlaces; null: never bent.
  const double* set = nullptr;
};

struct BeamEnds {
  Vec3 x1, x2;                                // m
  Quat q1, q2;                                // material to space
  Vec3 v1 = Vec3::Zero(), v2 = Vec3::Zero();  // m/s, used with damping only
  Vec3 w1 = Vec3::Zero(), w2 = Vec3::Zero();  // rad/s, material
};

// What an engineer reads off the element: tension and, at both ends, torsion and bending in element axes.
struct BeamStress {
  double tension = 0;           // N, mean over the element
  double shear = 0;             // N, size of the shear force in its middle: the change of the moment
  double strain_energy = 0;     // J
  double dissipation = 0;       // W
  Vec3 moment1, moment2;        // N m, (torsion, about 2, about 3)
  Vec3 curvature1, curvature2;  // 1/m, (twist, about 2, about 3), from the stress-free shape
  // 1/m, that stays where a section is unloaded elastically; of plastic bending, nearest to the ends.
  double residual1 = 0, residual2 = 0;
};

// Internal force f on (x1, theta1, x2, theta2): forces in space axes, moments in material axes.
void beam_force(const BeamSection& s, const BeamReference& r, const BeamEnds& e, Vec12& f);

// Force and tangents by position and material rotation increments (K) and by velocity and
// material angular velocity (C; left untouched unless beta > 0). `convex` drops compression from the
// geometric stiffness, for statics far from the solution.
void beam_tangent(const BeamSection& s, const BeamReference& r, const BeamEnds& e, bool convex, Vec12& f,
                  Mat12& K, Mat12* C);

BeamStress beam_stress(const BeamSection& s, const BeamReference& r, const BeamEnds& e);

// The force with which an element pulls material out of a feeder at one of its ends: minus the derivative of
// the strain energy by the unstretched length, the configurational force (Eshelby 1951). That is the tension
// and M²/2EI of what is bent; of what bends plastically the tension alone. Of elements without damping, whose
// bending is linear or plastic.
struct BeamFeed {
  double force = 0;     // N
  double slope = 0;     // N/m, its derivative by the unstretched length: never positive
  double by_chord = 0;  // N/m, by the distance of the ends
};
BeamFeed beam_feed(const BeamSection& s, const BeamReference& r, const BeamEnds& e);

// What bending adds to the strain of the chord, |x2 - x1|/L - 1, of any L.
double beam_bow(const BeamReference& r, const BeamEnds& e);

// Of plastic bending: makes `set`, laid out as BeamReference::set, what the element remembers when it has
// come to where `e` has it. What was dissipated on the way, J.
double beam_bend(const BeamSection& s, const BeamReference& r, const BeamEnds& e, double* set);

// The stress-free reference of an element whose ends are placed as in `e`, with node 1's material axes; for
// lines that are curved when free of stress.
BeamReference beam_reference(const BeamSection& s, const BeamEnds& e);

}  // namespace hawser
