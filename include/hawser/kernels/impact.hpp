// Limits of the step length near a contact and in it: steps resolve each impact that matters, so that contact
// forces neither make nor lose significant energy. The caller sums over the ranks. See
// docs/theory/contact.md, "Steps", and docs/decisions/006-step-control.md.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

// The limit of the next step.
struct StepLimit {
  double longest = std::numeric_limits<double>::infinity();  // s
  // s, shortest period of the contacts that have an impact now. For some time after it steps resolve the
  // motion that the impact causes.
  double period = std::numeric_limits<double>::infinity();
};

// A point that approaches a surface.
struct Approach {
  double gap = 0;           // m, to where the contact force begins; negative: in contact
  double closing = 0;       // m/s, speed towards the surface
  double acceleration = 0;  // m/s², along the normal; positive: away from the surface
  bool last = true;  // of a point in contact: it is the deepest one, so the contact ends where it leaves
};

// The impact of a mass on a contact spring, which takes place now or may take place before the step ends.
class ImpactEvent {
 public:
  int line = 0, other = -1;  // the line with the impact; the other line, if there is one

  // J: kinetic energy of the mass along the normal plus the energy of the spring above that of its
  // equilibrium. Steps that do not resolve the impact make or lose no more than this.
  double energy() const { return energy_; }
  // J, that a step of h [s] may make or lose: energy() if the step is too long to resolve the impact, else 0.
  double unresolved(double h) const { return h > resolved_ ? energy_ : 0; }
  // J: the trapezoidal rule loses this energy in a step of h [s] in which the contact begins, and makes it in
  // a step in which the contact ends.
  double crossed(double h) const;
  // s, of the mass on the spring; infinite where it is not in contact.
  double period() const;

 private:
  friend std::optional<ImpactEvent> impact_event(double inverse_frequency, double significant_depth,
                                                 double mass, const Approach& at);
  double inverse_frequency_ = 0, energy_ = 0;  // s, J
  double resolved_ = 0;                        // s
  double crossing_ = 0;  // s, until the contact begins or ends; infinite: it does neither
  double half_ = 0;      // N/m, half the stiffness
  Approach at_;
};

// inverse_frequency: s, sqrt(m/k) of the contact, its period over 2 pi. significant_depth: m; it is an impact
// if speed or acceleration takes the mass deeper than this. mass: kg.
std::optional<ImpactEvent> impact_event(double inverse_frequency, double significant_depth, double mass,
                                        const Approach& at);
// Whether an impact is possible at no more than this speed [m/s] and acceleration [m/s²] in any direction.
bool may_impact(double inverse_frequency, double significant_depth, double speed, double acceleration);

// Whether a step of h [s] is short enough for a contact of this inverse frequency [s] that its energy error
// is accepted where the contact begins or ends in it: at most half of the steps that resolve an impact.
bool resolves_contact(double inverse_frequency, double h);

// A contact that began or ended within a step that was too long to resolve it, so that the step made or lost
// energy. At the start of the step it could not be predicted: a wave along the line caused it.
struct UnresolvedImpact {
  int line = 0, other = -1;  // the line in contact; the other line, if there is one
  double energy = 0;         // J, made or lost
};
// Impacts that are found at the end of a converged step and were not predicted at its start.
struct UnresolvedImpacts {
  std::vector<UnresolvedImpact> list;
  bool too_deep = false;  // a penetration grew in the step by more than is allowed
};
// J, the error of the trapezoidal rule in the work of a contact that began or ended within a step: the rule
// assumes that the force changes over the whole path. path: m, along the normal; force [N] and potential [J]:
// of the spring at that end of the step where there is contact. 0 if speed [m/s] times inverse frequency is
// less than significant_depth [m].
double crossing_error(double inverse_frequency, double significant_depth, double force, double potential,
                      double path, double speed);

// What force terms report: the impacts that this rank counts, and a limit of the step beside them.
struct ImpactEvents {
  double longest = std::numeric_limits<double>::infinity();  // s, limit of the step whatever the impacts are
  // s, the longest step that is considered: impacts that only limit longer ones need not be added.
  double most = std::numeric_limits<double>::infinity();
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

// The motion of the masses of a line: kg, kg m/s, J. energy() [J] is the kinetic energy about the mean
// velocity plus that of the line's impacts.
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
};

// Sums the numbers over all ranks, in place.
using Sum = std::function<void(std::span<double>)>;

// What generalized-alpha carries from step to step beside the motion: algorithmic accelerations A, m/s², in
// which it holds the energy share/2 h² A.M A (docs/theory/time-integration.md, "Cables").
struct StoredMotion {
  std::span<const Vec3> accelerations;  // of the nodes
  double share = 0;
};

// J, for each line the energy error of impacts that is allowed in a step: kErrorOfStep of the line's energy
// times the number of lines of which the impacts have more than that. `lines` are summed over all ranks.
constexpr double kErrorOfStep = 2e-5;
std::vector<double> energy_tolerance(std::span<const LineMotion> lines);

// The longest step [s] after one of `last` [s] for which the energy stored in A grows by no more than the
// tolerance; that energy is proportional to the square of the step and would be released as motion. At least
// twice `last`, because each step damps what the next one would add. stored: by line, the sums of LineMotion
// over all ranks with the accelerations A in place of the velocities.
double growth_limited_step(std::span<const LineMotion> stored, std::span<const double> energy_tolerance,
                           double share, double last);

// Whether the sum of the errors of all ranks is within the tolerance. Collective.
bool within_tolerance(std::span<const UnresolvedImpact> impacts, std::span<const double> energy_tolerance,
                      const Sum& sum);

// The longest step of at most `most` [s] in which impacts, of all ranks, together stay within the
// energy tolerance, and the period of those that matter. Collective.
StepLimit impact_limited_step(std::span<const ImpactEvent> impacts, std::span<const double> energy_tolerance,
                              double most, const Sum& sum);

}  // namespace hawser
