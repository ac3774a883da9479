// How long a step may be beside and in a contact, so that an impact that matters is followed and its force
// makes no energy to speak of. No MPI: sums over the ranks are the caller's. See docs/theory/contact.md,
// "Steps", and docs/decisions/006-step-control.md.
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
  // s, shortest period of the contacts with an impact now: steps resolve what it sets in motion for some
  // time.
  double period = std::numeric_limits<double>::infinity();
};

// A point that approaches a surface: its gap to where forces begin (m, negative: beyond), its closing speed
// (m/s) and its acceleration along the normal (m/s², positive: away).
struct Approach {
  double gap = 0, closing = 0, acceleration = 0;
  bool last = true;  // in touch: no other place of the same contact is deeper, so that it ends with this one
};

// The impact of a mass on the spring of a contact: at present, or possible before the step ends.
class ImpactEvent {
 public:
  int line = 0, other = -1;  // the line with the impact; the other line, if there is one

  // J: kinetic energy of the mass along the normal plus that of the spring away from its balance. Steps that
  // resolve the impact make or lose no more than this.
  double energy() const { return energy_; }
  // J, at stake in a step of h [s]: energy() where the step is too long to resolve the impact, else 0.
  double unresolved(double h) const { return h > resolved_ ? energy_ : 0; }
  // J: the trapezoidal rule loses this in a step of h across the first touch, or makes it in one across the
  // end of the contact.
  double crossed(double h) const;
  // s, of what is in touch; infinite: of what is not.
  double period() const;

 private:
  friend std::optional<ImpactEvent> impact_event(double inverse_frequency, double significant_depth,
                                                 double mass, const Approach& at);
  double inverse_frequency_ = 0, energy_ = 0;  // s, J
  double resolved_ = 0;                        // s
  double crossing_ = 0;                        // s, until the touch or the end; infinite: none
  double half_ = 0;                            // N/m, half the stiffness
  Approach at_;
};

// inverse_frequency: s, sqrt(m/k) of the contact, its period over 2 pi. significant_depth: m; there is an
// impact where inertia takes the mass deeper than this, by speed or by acceleration. mass: kg.
std::optional<ImpactEvent> impact_event(double inverse_frequency, double significant_depth, double mass,
                                        const Approach& at);
// Whether an impact is possible at no more than this speed [m/s] and acceleration [m/s²] in any direction.
bool may_impact(double inverse_frequency, double significant_depth, double speed, double acceleration);

// Whether a step of h [s] is short enough for a contact of this inverse frequency [s] that its energy error
// is accepted where the contact begins or ends in it: at most half of the steps that resolve an impact.
bool resolves_contact(double inverse_frequency, double h);

// A contact that began or ended within a step that is too long for it, so that the step gained or lost
// energy. The start of the step did not show it: a wave along the line brought it there or took it off.
struct UnresolvedImpact {
  int line = 0, other = -1;  // that meets or leaves the other, if that is a line
  double energy = 0;         // J, made or lost
};
// Impacts that the end of a converged step shows and its start did not.
struct UnresolvedImpacts {
  std::vector<UnresolvedImpact> list;
  bool too_deep = false;  // something went deeper in it than a step is trusted with
};
// J, the error of the trapezoidal rule in the work of a contact that began or ended within a step: the rule
// takes the force for one that rises or falls over the whole path. path: m, along the normal; force: N, and
// potential: J, of the spring at the end of the step where it touches. 0 where speed [m/s] times inverse
// frequency presses in by less than significant_depth [m].
double crossing_error(double inverse_frequency, double significant_depth, double force, double potential,
                      double path, double speed);

// What terms find: impacts of what this rank counts, and a length [s] that steps keep to in any case.
struct ImpactEvents {
  double longest = std::numeric_limits<double>::infinity();
  double most =
      std::numeric_limits<double>::infinity();  // s, no step is longer: longer limits need not be added
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

// J by line: the energy error that impacts may have in a step: kErrorOfStep of the line's energy, times the
// number of lines whose impacts have more. `lines` are those of all ranks.
constexpr double kErrorOfStep = 2e-5;
std::vector<double> energy_tolerance(std::span<const LineMotion> lines);

// The longest step [s] after one of `last` [s] that lets the energy held in A, which grows with the square of
// the step, grow by no more than its tolerance: it would come out as motion. Twice the last one in any case,
// as each step damps what the next would make. stored: as LineMotion, of accelerations; by line, of all
// ranks.
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
