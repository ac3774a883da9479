// The next time at which a step must end: of an output, a checkpoint, an event, or a jump of a prescribed
// velocity.
#include "hawser/record/output_times.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/model/body_motion.hpp"

namespace hawser::record {

double next_multiple(double t, double every) { return every * (std::floor(t / every + 1e-9) + 1); }

OutputTimes::OutputTimes(const model::Case& c)
    : every(c.output.every > 0 ? c.output.every : c.dynamics.duration / 100),
      checkpoint_every(c.output.checkpoint_every),
      jumps_(model::velocity_jumps(c.bodies)) {
  for (const model::Event& e : c.events)
    if (e.cause.kind == model::Cause::Kind::time) jumps_.push_back(e.cause.time);
  std::sort(jumps_.begin(), jumps_.end());
}

double OutputTimes::next(double t) const {
  const double stop = checkpoint_every > 0
                          ? std::min(next_multiple(t, every), next_multiple(t, checkpoint_every))
                          : next_multiple(t, every);
  const auto jump = std::upper_bound(jumps_.begin(), jumps_.end(), t + time_tolerance(t));
  return jump != jumps_.end() ? std::min(stop, *jump) : stop;
}

}  // namespace hawser::record
