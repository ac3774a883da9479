// Cable element: a straight bar that carries tension only. It has two forces: cable_force at a state
// (statics, output), and cable_mean_force over a time step, which conserves energy.
#pragma once

#include "hawser/kernels/response_curve.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

struct CableSection {
  double length = 0;  // m, unstretched
  double EA = 0;      // N
  double beta = 0;    // s, stiffness-proportional damping of a taut element
  // Tension by strain, scaled so that its slope at zero strain is EA; null: linear. Damping uses EA.
  const ResponseCurve* tension = nullptr;
  double free_strain = 0;  // strain without tension (thermal expansion)
  // Derivative of `length` by the length of the chord. It is not 0 at a winch that keeps a tension.
  double length_by_chord = 0;
  double length_rate = 0;  // m/s, rate of `length`; paid-out line does not strain the material

  // Strain beyond the free strain of an element with a chord [m], of this unstretched length or another [m].
  // The difference of lengths has less round-off than l/L - 1.
  double strain(double chord) const { return strain(chord, length); }
  double strain(double chord, double unstretched_length) const {
    return (chord - unstretched_length) / unstretched_length - free_strain;
  }
  // Tension [N] at a strain, its slope, and the strain energy per length [N].
  ResponseCurve::Value axial(double strain) const {
    if (!tension) return {EA * strain, EA, 0.5 * EA * strain * strain};
    const double factor = EA / tension->initial();
    const ResponseCurve::Value v = tension->at(strain);
    return {factor * v.force, factor * v.slope, factor * v.energy};
  }
};

// References to positions [m] and velocities [m/s] of the ends; nothing is copied.
struct CableEnds {
  const Vec3 &x1, &x2, &v1, &v2;
};

// `force` = T t [N], t pointing from node 1 to node 2 (for cable_mean_force: T times the mean chord over
// the mean length). It enters the residual (internal minus external) as -force at node 1 and +force at
// node 2. k and c are its derivatives by x2 - x1 and v2 - v1.
struct CableForce {
  Vec3 force;
  Mat3 k, c;  // c is zero unless the element is damped
};

// State of an element at the start of a step, and the change of its strain in the step before.
struct CableStart {
  Vec3 chord = Vec3::Zero();      // m
  double length = 0;              // m, of the chord
  double strain = 0;              // beyond the free strain; negative: slack
  double unstretched_length = 0;  // m; at the end of the step it differs where line is paid out
  double strain_increment = 0;    // of the taut part of the strain in the step before, see cable_step_result
  // s, damping in this step: that of the section, reduced so that at the strain rate of the step before the
  // damper does not exceed the spring's tension. 0 if the element is slack at the start.
  double beta = 0;
};

// Values of the time integration for an element in a step.
struct CableStep {
  double h = 0;       // s
  double filter = 0;  // chi, part of EA that resists changes of the elongation from step to step
};

struct CableStress {
  double tension = 0;        // N, never negative
  double strain_energy = 0;  // J
  double dissipation = 0;    // W
};

// T = EA (e + beta e'), e = (l - L)/L - free strain, for e > 0. The damper's part is limited in magnitude to
// the spring's. `force` is T t as in CableForce. `slack`: fraction of the axial stiffness in k of slack
// elements.
Vec3 cable_force(const CableSection& section, const CableEnds& e);
void cable_force(const CableSection& section, const CableEnds& e, double slack, CableForce& out);

CableStress cable_stress(const CableSection& section, const CableEnds& e);

// The mean force of a step, with the sign of CableForce: its work over the displacement of the ends is the
// change of strain energy, to rounding, plus the energy taken by damper and filter (Simo & Tarnow 1992,
// ZAMP 43; Gonzalez 1996, J. Nonlinear Sci. 6): docs/theory/time-integration.md#cables. It is never
// compressive.
// strain_increment: change of the taut part of the strain in the step before, which took previous_h [s]; both
// are 0 where there was none. If the step to come takes h < previous_h, the caller multiplies
// strain_increment of the result by h/previous_h before the functions below.
CableStart cable_start(const CableSection& section, const Vec3& x1, const Vec3& x2, double strain_increment,
                       double previous_h);
Vec3 cable_mean_force(const CableSection& section, const CableStart& start, const CableStep& step,
                      const Vec3& x1, const Vec3& x2);
// The same with its derivative by x2 - x1. c is zero: in a step dampers act through the change of position.
void cable_mean_force(const CableSection& section, const CableStart& start, const CableStep& step,
                      const Vec3& x1, const Vec3& x2, CableForce& out);

// Energies of a step that ended with x1 and x2, and the strain that the next step needs.
struct CableStepResult {
  double damped = 0;            // J, lost to the damping of the line type
  double filtered = 0;          // J, lost to the filter; negative where the filter returns energy
  double strain_increment = 0;  // for cable_start of the next step
  double fed = 0;               // J, work of the feeder that changed the unstretched length
};
CableStepResult cable_step_result(const CableSection& section, const CableStart& start, const CableStep& step,
                                  const Vec3& x1, const Vec3& x2);

}  // namespace hawser
