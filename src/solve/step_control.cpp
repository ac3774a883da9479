// The class StepControl: length of the next step from Newton iterations, local error, failures and impacts.
// The time to the next output is divided into equal steps. Acceptance is decided in step_decision.cpp.
#include "hawser/solve/step_control.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/kernels/impact.hpp"

namespace hawser {
namespace {
// Factors on the step: docs/decisions/006-step-control.md.
constexpr double kSafety = 0.9, kGrow = 1.5, kShrink = 0.25;
constexpr double kShrinkIfHard = 0.7;        // after many iterations
constexpr double kShrinkIfInvalid = 0.5;     // after a step that was not solved or not valid
constexpr double kShrinkIfInaccurate = 0.8;  // at least, after an inaccurate step
constexpr double kAcceptedError = 2;         // of the tolerance that the length of the step aims at
constexpr int kPatience = 5;
// After an impact, steps are at most kPartOfPeriod of the period of its contact until the vibration has
// decayed, for at most kPeriodsAfterImpact periods. From then on the limit is that length plus the time since
// then, so that steps at the limit double from one to the next: the contact still vibrates faster than such
// steps resolve, and a step that is many times as long as the last one would add energy to that vibration.
constexpr double kPartOfPeriod = 1.0 / 3;

// The local error is proportional to the cube of the step: h_new = kSafety h (tolerance/error)^(1/3)
// (docs/theory/time-integration.md), here between kShrink h and largest h.
double factor_by_error(double tolerance, double error, double largest) {
  return std::clamp(kSafety * std::cbrt(tolerance / error), kShrink, largest);
}
}  // namespace

StepControl::StepControl(const StepSettings& settings) : s_(settings) {
  const double limit = s_.fixed > 0 ? s_.fixed : s_.longest;
  s_.shortest = std::min(s_.shortest, limit);
  proposal_ = s_.fixed > 0 ? s_.fixed : std::clamp(s_.first, s_.shortest, s_.longest);
}

double StepControl::next(double t, double stop, double allowed) const {
  double proposal = proposal_;
  if (respects_term_limits()) {
    if (impact_period_ > 0) allowed = std::min(allowed, allowed_after_impact(t));
    proposal = std::max(std::min(proposal_, allowed), s_.shortest);
  }
  const double n = std::ceil((stop - t) / proposal - 1e-6);
  return (stop - t) / std::max(n, 1.0);
}

// Longest step from t after the last impact, s. Beyond resolved_until_ it grows by the time since then.
double StepControl::allowed_after_impact(double t) const {
  return kPartOfPeriod * impact_period_ + std::max(t - resolved_until_, 0.0);
}

// Until the limit by the last impact allows steps of kPartOfPeriod times `period`, a softer contact (longer
// period) does not replace that impact. A vibration that decays sooner does not end the time of an earlier
// one.
void StepControl::limit_by_impact(double t, double period, double decay) {
  if (!std::isfinite(period) ||
      (impact_period_ > 0 && kPartOfPeriod * period > allowed_after_impact(t) * (1 + 1e-9)))
    return;
  impact_period_ = period;
  const double longest = kPeriodsAfterImpact * period;
  resolved_until_ = std::max(t + std::min(decay, longest), std::min(resolved_until_, t + longest));
}

void StepControl::reset_to_first_step() {
  if (respects_term_limits()) proposal_ = std::max(std::min(proposal_, s_.first), s_.shortest);
  growth_wait_ = 0;
}

bool StepControl::accurate(double h, double error) const {
  if (s_.fixed > 0 || s_.error_tolerance <= 0 || is_shortest(h)) return true;
  return error <= kAcceptedError * s_.error_tolerance;
}

void StepControl::after_accepted_step(double h, int iterations, double error) {
  const bool fixed = s_.fixed > 0;
  const bool may_grow = growth_wait_ == 0;
  const double limit = fixed ? s_.fixed : s_.longest;
  if (!may_grow) --growth_wait_;
  double factor = 1;
  if (may_grow && fixed) factor = 2;  // back to the user's step
  if (!fixed) {
    if (may_grow && iterations <= s_.easy_iterations) factor = kGrow;
    if (iterations > s_.hard_iterations) factor = kShrinkIfHard;
    if (s_.error_tolerance > 0 && error > 0) factor = factor_by_error(s_.error_tolerance, error, factor);
  }
  // A step that was shortened to end at an output must not shorten the proposal.
  const double from = factor >= 1 ? std::max(h, proposal_) : h;
  proposal_ = std::clamp(from * factor, s_.shortest, limit);
}

bool StepControl::after_rejected_step(double h, Rejection why, double error) {
  if (is_shortest(h)) return false;
  double factor = kShrinkIfInvalid;
  if (why == Rejection::inaccurate && s_.error_tolerance > 0)
    factor = factor_by_error(s_.error_tolerance, error, kShrinkIfInaccurate);
  proposal_ = std::max(h * factor, s_.shortest);
  growth_wait_ = why == Rejection::invalid ? kPatience : 1;
  return true;
}

}  // namespace hawser
