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

// Constants of one element. Damping is proportional to stiffness: each stress is E (strain + beta rate).
struct BeamSection {
  double length = 0;        // m, unstretched
  double EA = 0;            // N
  double EI2 = 0, EI3 = 0;  // N m²
  double GJ = 0;            // N m²
  double GA = 0;            // N; 0: rigid in shear
  double beta = 0;          // s
  // Tension by strain, scaled so that its slope at zero is EA; null: linear. Damping uses EA.
  const ResponseCurve* tension = nullptr;
  // Bending moment by curvature, in the direction of the curvature. If EI2 = EI3 exceeds its slope at zero,
  // the difference is added linearly. null: linear. With a curve GA is ignored, and damping uses EI.
  const ResponseCurve* moment = nullptr;
  // Plastic bending with history, in place of `moment`; null: elastic. EI2, EI3, GA and damping as there.
  const PlasticBending* plastic = nullptr;
  // Derivative of the length by the force on the feeder (beam_feed), m/N, for an element whose length follows
  // that force.
  double length_by_force = 0;

  bool bends_by_law() const { return moment || plastic; }
};

// Points along an element with a history of plastic bending.
inline constexpr int kBendingPlaces = 3;

struct BeamReference {
  // Element axes in the material axes of its nodes (columns; first along the line), stress-free relative
  // rotation and chord strain: zero for a straight element without expansion.
  const Mat3* axes = nullptr;  // not owned; null: equal to the node axes
  Vec3 psi = Vec3::Zero();     // rad, in element axes
  double strain = 0;
  // Plastic history: PlasticBending::memory() numbers for each of kBendingPlaces; null: never bent.
  const double* set = nullptr;
};

struct BeamEnds {
  Vec3 x1, x2;                                // m
  Quat q1, q2;                                // material to space
  Vec3 v1 = Vec3::Zero(), v2 = Vec3::Zero();  // m/s, used with damping only
  Vec3 w1 = Vec3::Zero(), w2 = Vec3::Zero();  // rad/s, material
};

// Section forces for output: tension, and torsion and bending at both ends in element axes.
struct BeamStress {
  double tension = 0;        // N, mean over the element
  double shear = 0;          // N, magnitude of the shear force in the middle, from the change of the moment
  double strain_energy = 0;  // J
  double dissipation = 0;    // W
  Vec3 moment1, moment2;     // N m, (torsion, about 2, about 3)
  Vec3 curvature1, curvature2;  // 1/m, relative to the stress-free shape: twist, about 2, about 3
  // 1/m, residual curvature after elastic unloading (plastic bending), at the points nearest to the ends.
  double residual1 = 0, residual2 = 0;
};

// Internal force f on (x1, theta1, x2, theta2): forces in space axes, moments in material axes.
void beam_force(const BeamSection& s, const BeamReference& r, const BeamEnds& e, Vec12& f);

// Force and tangents by position and material rotation increments (K) and by velocity and material angular
// velocity (C; unchanged unless beta > 0). `convex` excludes compression from the geometric stiffness, for
// statics far from the solution.
void beam_tangent(const BeamSection& s, const BeamReference& r, const BeamEnds& e, bool convex, Vec12& f,
                  Mat12& K, Mat12* C);

BeamStress beam_stress(const BeamSection& s, const BeamReference& r, const BeamEnds& e);

// Force with which an element pulls material out of a feeder at one of its ends: minus the derivative of the
// strain energy by the unstretched length, the configurational force (Eshelby 1951). It is the tension plus
// M²/2EI of elastic bending; plastic bending contributes nothing. For elements without damping and with
// linear or plastic bending.
struct BeamFeed {
  double force = 0;     // N
  double slope = 0;     // N/m, derivative by the unstretched length: never positive
  double by_chord = 0;  // N/m, derivative by the distance of the ends
};
BeamFeed beam_feed(const BeamSection& s, const BeamReference& r, const BeamEnds& e);

// Contribution of bending to the strain of the chord, |x2 - x1|/L - 1, for any L.
double beam_bow(const BeamReference& r, const BeamEnds& e);

// Updates the plastic history `set`, with the layout of BeamReference::set, to the configuration `e`. Returns
// the energy dissipated, J.
double beam_bend(const BeamSection& s, const BeamReference& r, const BeamEnds& e, double* set);

// Stress-free reference of an element with the ends placed as in `e`, in node 1's material axes, for lines
// that are curved when stress-free.
BeamReference beam_reference(const BeamSection& s, const BeamEnds& e);

}  // namespace hawser
