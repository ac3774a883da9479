#include "hawser/kernels/impact.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

constexpr double kSteps = 6;     // in a period
constexpr double kShort = 0.02;  // of such a step: nearer than that is there

// Time until something `away` [m], which comes at `speed` [m/s, > 0] and is pushed back by `acceleration`
// [m/s²], is there; infinite: it turns before.
double until_touch(double away, double speed, double acceleration) {
  const double root = speed * speed - 2 * acceleration * away;
  if (root < 0) return std::numeric_limits<double>::infinity();
  return 2 * away / (speed + std::sqrt(root));
}

// Time until what is `deep` in and leaves at `speed` is out. The contact pushes at the start of that step and
// no more at its end: the trapezoid sees half of it.
double until_out(double deep, double speed, double acceleration) {
  return until_touch(deep, speed, -0.5 * acceleration);
}

// Towards something that is `until` away: so far, or half way where a step does not reach it but two do.
double towards(double until, double step) {
  if (until < kShort * step || until >= 2 * step) return step;
  return until <= step ? until : 0.5 * until;
}

}  // namespace

StepLimit impact_limit(double slowness, double seen, const Approach& at) {
  StepLimit limit;
  const double by_speed = slowness * std::abs(at.closing),
               by_acceleration = slowness * slowness * std::abs(at.acceleration);
  if (!(std::hypot(by_speed, by_acceleration) > seen)) return limit;
  const double step = 2 * M_PI / kSteps * slowness;
  if (at.gap < 0) {
    const bool leaves = at.last && at.closing < 0;
    limit.longest = leaves ? towards(until_out(-at.gap, -at.closing, at.acceleration), step) : step;
    limit.period = 2 * M_PI * slowness;
    return limit;
  }
  if (at.closing > 0) {
    // Accelerations change on the way.
    const double touch = std::min(until_touch(at.gap, at.closing, at.acceleration), 2 * at.gap / at.closing);
    limit.longest = touch < step ? towards(touch, step) : touch;
  }
  // Not in touch, but shaking as fast as the contact would.
  if (by_acceleration > seen && !(at.closing > 0)) limit.longest = step;
  return limit;
}

}  // namespace hawser
