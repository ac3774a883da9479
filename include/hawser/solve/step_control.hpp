// Chooses the length of the next step. It uses neither PETSc nor MPI. All ranks make the same decisions,
// because all arguments are global numbers.
#pragma once

#include <limits>

namespace hawser {

struct StepSettings {
  double fixed = 0;            // s; > 0: fixed step, divided to meet stops, halved when it fails
  double first = 0.01;         // s, first automatic step
  double longest = 0.1;        // s
  double shortest = 1e-6;      // s
  double error_tolerance = 0;  // m, local error that steps aim at; up to twice is accepted; 0: not controlled
  int easy_iterations = 4;     // the step may increase after at most this many Newton iterations
  int hard_iterations = 8;     // it decreases after more than this many
  bool resolve_impacts = true;  // fixed steps, too, are shortened to what the terms allow
};

class StepControl {
 public:
  explicit StepControl(const StepSettings& settings);

  // Length of the step from t towards `stop` (an output time or the end), which is met exactly: the time to
  // it is divided into equal steps. They are not longer than the proposal nor, where terms limit steps, than
  // `allowed` [s].
  double next(double t, double stop, double allowed) const;
  // True if the limits of the terms apply.
  bool respects_term_limits() const { return s_.fixed <= 0 || s_.resolve_impacts; }
  // True if a step of h may be repeated with a shorter length because of a condition detected at its end.
  bool may_shorten(double h) const { return respects_term_limits() && !is_shortest(h); }
  bool is_shortest(double h) const { return h <= s_.shortest * (1 + 1e-9); }
  double shortest_length() const { return s_.shortest; }  // s
  // Called when accelerations have jumped: the next step is at most the first one of the settings.
  void reset_to_first_step();
  // Called at the start t of each step with the period [s] of the contact that an impact has hit in the last
  // step; infinite: no impact. Steps stay below a third of the period until the remaining vibration, which
  // determines the next impact, has decayed: for the time `decay` [s], at most twenty periods. From then on
  // the limit grows by the time that has passed.
  void limit_by_impact(double t, double period, double decay = std::numeric_limits<double>::infinity());
  // True if a converged step of h with the local error `error` [m] is accurate enough. A step of the shortest
  // length always is.
  bool accurate(double h, double error) const;

  void after_accepted_step(double h, int iterations, double error);
  // Why a trial was rejected: it is not a valid step (not solved, a missed contact, an impact that is not
  // resolved), or it is valid and its local error is too large.
  enum class Rejection { invalid, inaccurate };
  // A step of h was rejected. error: its local error, m, used if it is inaccurate. Returns false if the step
  // already was the shortest.
  bool after_rejected_step(double h, Rejection why, double error);

  double proposal() const { return proposal_; }
  int wait() const { return growth_wait_; }
  double impact_period() const { return impact_period_; }
  double resolved_until() const { return resolved_until_; }
  void restore(double proposal, int wait, double impact_period, double resolved_until) {
    proposal_ = proposal;
    growth_wait_ = wait;
    impact_period_ = impact_period;
    resolved_until_ = resolved_until;
  }

 private:
  double allowed_after_impact(double t) const;

  StepSettings s_;
  double proposal_ = 0;
  int growth_wait_ = 0;  // accepted steps before the step may grow again after a failure
  double impact_period_ = 0,
         resolved_until_ = 0;  // s: period of the contact of the last impact, and until when steps resolve it
};

}  // namespace hawser
