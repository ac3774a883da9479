// The largest T (1 - cos alpha) of each line over the states looked at, and the sentence about it.
#include "hawser/app/sharp_turns.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hawser/base/gather.hpp"

namespace hawser::app {
namespace {

constexpr double kWarned = 0.1;  // of the largest tension
constexpr double kGood = 0.45;   // rad, from one element to the next: 1 - cos of it is about that share

}  // namespace

void SharpTurns::look(const Kinematics& at, std::span<const double> tension,
                      std::span<const double> normal_force) {
  for (size_t n = 0; n < static_cast<size_t>(mesh_.owned); ++n) {
    if (!(normal_force[n] > 0)) continue;
    const double turn = line_.turn(at, static_cast<int>(n));
    const double error = tension[n] * (1 - std::cos(turn));
    const Node& node = mesh_.mesh->nodes[static_cast<size_t>(mesh_.global[n])];
    Worst& w = worst_[static_cast<size_t>(node.line)];
    if (error > w.error) w = {error, turn, node.arc, at.time};
  }
}

std::string SharpTurns::warning(MPI_Comm comm, int line, const std::string& name,
                                double largest_tension) const {
  Worst w = worst_[static_cast<size_t>(line)];
  if (!broadcast_largest(comm, w.error, kWarned * largest_tension, w)) return {};
  return fmt::format(
      "line {} turns by {:.0f} degrees from one element to the next where it lies on a volume (arc length "
      "{:.4g} m, t = {:.4g} s), so that its tension there may be wrong by up to {:.2g} N, {:.0f} % of the "
      "largest: give it elements so short that it turns by no more than {:.0f} degrees; over a sharp edge "
      "that is less than half its radius",
      name, w.turn * 180 / M_PI, w.arc, w.time, w.error, 100 * w.error / largest_tension, kGood * 180 / M_PI);
}

}  // namespace hawser::app
