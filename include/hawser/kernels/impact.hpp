// Limits of the step length near and during contact: steps resolve each significant impact, so that contact
// forces neither create nor lose significant energy. The caller sums over the ranks. See
// docs/theory/contact.md, "Steps", and docs/decisions/006-step-control.md.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "hawser/math/function_ref.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

// The limit of the next step.
struct StepLimit {
  double longest = std::numeric_limits<double>::infinity();  // s
  // s, shortest period of the contacts with a current impact. For some time after it steps resolve the motion
  // that the impact causes.
  double period = std::numeric_limits<double>::infinity();
  // s, time until the vibrations of these contacts have decayed to the energy tolerance, at most
  // kPeriodsAfterImpact periods.
  double decay = std::numeric_limits<double>::infinity();
};

// Steps resolve the vibration that an impact leaves for at most this number of its periods.
constexpr double kPeriodsAfterImpact = 20;

// A point that approaches a surface.
struct Approach {
  double gap = 0;           // m, distance to where the contact force begins; negative: in contact
  double closing = 0;       // m/s, speed towards the surface
  double acceleration = 0;  // m/s², along the normal; positive: away from the surface
  bool last = true;         // for a point in contact: it is the deepest one, so contact ends when it leaves
  double damping = 0;       // damping ratio of its vibration in contact and after it, the smaller one
};

// Impact of a mass on a contact spring that takes place now or may take place before the step ends.
class ImpactEvent {
 public:
  int line = 0, other = -1;  // line with the impact; the other line, -1: none

  // Kinetic energy of the mass along the normal plus the energy of the spring above that of its equilibrium,
  // J: the largest energy error of steps that do not resolve the impact.
  double energy() const { return energy_; }
  // Possible energy error of a step of h [s], J: energy() if it is too long to resolve the impact, else 0.
  double unresolved(double h) const { return h > resolved_ ? energy_ : 0; }
  // Energy that the trapezoidal rule loses in a step of h [s] if contact begins, or creates if it ends, J.
  double crossed(double h) const;
  // Period of the mass on the spring, s; infinite if it is not in contact.
  double period() const;
  bool damped() const { return approach_.damping > 0; }
  // Energy of the vibration after a time [s] without further impacts, J; 0 if it is not in contact now.
  double energy_after(double time) const;

 private:
  friend std::optional<ImpactEvent> impact_event(double inverse_frequency, double significant_depth,
                                                 double mass, const Approach& approach);
  double inverse_frequency_ = 0, energy_ = 0;  // s, J
  double resolved_ = 0;                        // s
  double crossing_ = 0;                        // s, until the contact begins or ends; infinite: neither
  double half_stiffness_ = 0;                  // N/m, half the stiffness
  Approach approach_;
};

// inverse_frequency: sqrt(m/k) of the contact, s, its period over 2 pi. significant_depth: m; it is an impact
// if speed or acceleration drives the mass deeper than this. mass: kg.
std::optional<ImpactEvent> impact_event(double inverse_frequency, double significant_depth, double mass,
                                        const Approach& approach);
// True if an impact is possible at speeds [m/s] and accelerations [m/s²] up to these, in any direction.
bool may_impact(double inverse_frequency, double significant_depth, double speed, double acceleration);

// True if a step of h [s] is short enough for a contact of this inverse frequency [s] that its energy error
// at the beginning or end of contact is accepted: at most a quarter of the steps that resolve an impact.
bool resolves_contact(double inverse_frequency, double h);

// A contact that began or ended within a step too long to resolve it, so that energy was created or lost. It
// was not predictable at the start of the step: a wave along the line caused it.
struct UnresolvedImpact {
  int line = 0, other = -1;  // line in contact; the other line, -1: none
  double energy = 0;         // J, created or lost
};
// Impacts found at the end of a converged step that were not predicted at its start.
struct UnresolvedImpacts {
  std::vector<UnresolvedImpact> list;
  bool too_fast = false;  // a penetration or tension increased in the step by more than allowed
};
// Error of the trapezoidal rule in the work of a contact that began or ended within a step, J: the rule
// assumes that the force varies over the whole path. path: along the normal, m; force [N] and potential [J]:
// of the spring at the end of the step with contact. 0 if speed [m/s] times inverse frequency is less than
// significant_depth [m].
double crossing_error(double inverse_frequency, double significant_depth, double force, double potential,
                      double path, double speed);

// Report of the force terms: the impacts that this rank counts, and an additional limit of the step.
struct ImpactEvents {
  double longest = std::numeric_limits<double>::infinity();  // s, limit independent of impacts
  // s, longest step under consideration: impacts that only limit longer ones need not be added.
  double max_step = std::numeric_limits<double>::infinity();
  std::vector<ImpactEvent> list;

  void limit(double h) {
    if (h < longest) longest = h;
  }
  void add(const std::optional<ImpactEvent>& s, int line, int other = -1) {
    if (!s) return;
    list.push_back(*s);
    list.back().line = line;
    list.back().other = other;
  }
};

// Motion of the masses of a line: kg, kg m/s, J. energy() [J] is the kinetic energy about the mean velocity
// plus that of the line's impacts.
struct LineMotion {
  double mass = 0;
  Vec3 momentum = Vec3::Zero();
  double kinetic = 0, impact_energy = 0;

  void add(double m, const Vec3& velocity) {
    mass += m;
    momentum += m * velocity;
    kinetic += 0.5 * m * velocity.squaredNorm();
  }
  double energy() const;
  // True if its impacts matter beside its energy.
  bool has_impacts() const;
};

// Sums the numbers over all ranks, in place.
using Sum = FunctionRef<void(std::span<double>)>;

// State of generalized-alpha in addition to the motion: algorithmic accelerations A, m/s², which store the
// energy factor/2 h² A.M A (docs/theory/time-integration.md, "Cables").
struct StoredMotion {
  std::span<const Vec3> accelerations;  // of the nodes
  double factor = 0;
};

// Energy error of impacts allowed in a step, by line, J: kErrorOfStep of the line's energy times the number
// of lines of the model that have impacts.
constexpr double kErrorOfStep = 2e-5;
std::vector<double> energy_tolerance(std::span<const LineMotion> lines, int lines_with_impacts);

// Longest step [s] after one of `last` [s] for which the energy stored in A grows by no more than the
// tolerance. That energy is proportional to the square of the step and would be released as motion. At least
// twice `last`, because each step damps what the next one would add. stored: by line, its LineMotion
// with the accelerations A in place of the velocities.
double growth_limited_step(std::span<const LineMotion> stored, std::span<const double> energy_tolerance,
                           double factor, double last);

// True if the total error of all ranks is within the tolerance. Collective.
bool within_tolerance(std::span<const UnresolvedImpact> impacts, std::span<const double> energy_tolerance,
                      Sum sum);

// Longest step, at most `max_step` [s], in which the impacts of all ranks together stay within the energy
// tolerance, and period and decay of the significant ones. Collective.
StepLimit impact_limited_step(std::span<const ImpactEvent> impacts, std::span<const double> energy_tolerance,
                              double max_step, Sum sum);

}  // namespace hawser
