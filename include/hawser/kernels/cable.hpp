// Cable element: a straight bar that carries tension only. Two forces: cable_pull at a state (statics,
// output), cable_mean over a time step, which keeps the energy.
#pragma once

#include "hawser/kernels/response_curve.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

struct CableSection {
  double length = 0;  // m, unstretched
  double EA = 0;      // N
  double beta = 0;    // s, stiffness-proportional damping of a taut element
  // Tension over strain, times EA over its slope at zero; null: linear. Damping stays that of EA.
  const ResponseCurve* tension = nullptr;
  double free_strain = 0;  // at which there is no tension: thermal expansion
  // Derivative of `length` by that of the chord: of what a winch that keeps to a tension pays out.
  double length_by_chord = 0;
  double length_rate = 0;  // m/s, rate of `length`: what is paid out does not stretch the material

  // Tension [N] of a strain, its slope and its energy a unit of length.
  ResponseCurve::Value axial(double strain) const {
    if (!tension) return {EA * strain, EA, 0.5 * EA * strain * strain};
    const double share = EA / tension->initial();
    const ResponseCurve::Value v = tension->at(strain);
    return {share * v.force, share * v.slope, share * v.energy};
  }
};

// Where the nodes are: nothing is copied. m, m/s.
struct CableEnds {
  const Vec3 &x1, &x2, &v1, &v2;
};

// What one end feels and minus what the other does, N, and its derivatives by x2 - x1 and v2 - v1.
struct CablePull {
  Vec3 force;
  Mat3 k, c;  // c is zero unless it is damped
};

// Where an element was when a step began, and how it stretched in the step before.
struct CableStart {
  Vec3 chord = Vec3::Zero();  // m
  double length = 0;          // m, of the chord
  double strain = 0;          // beyond the free strain; negative: slack
  double rest = 0;            // m, unstretched; that at the end of the step differs where line is paid out
  double stretch = 0;         // by which the taut part of the strain grew in the step before, see cable_loss
  // s, damping in this step: as much of that of the section as keeps the damper within the spring's tension
  // at the rate of strain of the step before; none of an element that is slack at the start.
  double beta = 0;
};

// What the integration makes of an element in a step.
struct CableStep {
  double h = 0;       // s
  double filter = 0;  // part of EA that resists changes of the elongation from step to step
};

struct CableStress {
  double tension = 0;        // N, never negative
  double strain_energy = 0;  // J
  double dissipation = 0;    // W
};

// T = EA (e + beta e'), e = l/L - 1 - free strain, for e > 0; the damper's part is never larger than the
// spring's. The force on the first end is -force, on the second force: residuals. `slack`: share of its axial
// stiffness that a slack element has in k.
Vec3 cable_pull(const CableSection& s, const CableEnds& e);
void cable_pull(const CableSection& s, const CableEnds& e, double slack, CablePull& out);

CableStress cable_stress(const CableSection& s, const CableEnds& e);

// The mean force of a step: the one whose work over the way of the ends is the change of strain energy, to
// the last bit, plus what the dampers take (Simo & Tarnow 1992, ZAMP 43; Gonzalez 1996, J. Nonlinear Sci. 6):
// docs/theory/time-integration.md#cables. It never pushes.
// stretch: of the step before, which took `last` [s]; 0: there was none.
CableStart cable_start(const CableSection& s, const Vec3& x1, const Vec3& x2, double stretch, double last);
Vec3 cable_mean(const CableSection& s, const CableStart& from, const CableStep& step, const Vec3& x1,
                const Vec3& x2);
// The same with its derivative by x2 - x1; c stays zero: dampers act by the change of position.
void cable_mean(const CableSection& s, const CableStart& from, const CableStep& step, const Vec3& x1,
                const Vec3& x2, CablePull& out);

// What became of a step that ended with x1 and x2.
struct CableLoss {
  double damped = 0;    // J, taken by the damping of the line type
  double filtered = 0;  // J, taken by the filter; negative where it gives back what it held
  double stretch = 0;   // for the start of the next step
  double fed = 0;       // J, work of what changed the unstretched length
};
CableLoss cable_loss(const CableSection& s, const CableStart& from, const CableStep& step, const Vec3& x1,
                     const Vec3& x2);

}  // namespace hawser
