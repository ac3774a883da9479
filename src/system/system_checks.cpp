// The class System: checks of states that solve the equations and are still no valid results.
#include <fmt/format.h>

#include <algorithm>

#include "hawser/base/gather.hpp"
#include "hawser/system/system.hpp"

namespace hawser {
namespace {
constexpr double kRoundOffShare = 0.01;  // largest ratio of round-off to tension
constexpr double kSure = 1e-3;           // this ratio for the EA that the message recommends
}  // namespace

std::string System::overstretched(const Kinematics& at) const {
  Overstretch worst;
  for (const CarriesTension* t : carry_tension_)
    if (const Overstretch o = t->overstretched(at); o.beyond > worst.beyond) worst = o;
  if (!broadcast_largest(comm_, worst.beyond, 0, worst)) return {};
  return fmt::format(
      "{}, is {} by {:.3g} % by {:.3g} N on an EA of {:.3g} N, and {:g} % is more than any line of such an "
      "EA bears",
      mesh_.mesh->place(worst.node), worst.strain > 0 ? "stretched" : "pressed together",
      100 * std::abs(worst.strain), std::abs(worst.tension), worst.EA, 100 * std::abs(worst.most));
}

// Without dead loads the tension may be zero, and then nothing but round-off.
std::string System::lost_in_rounding(const Kinematics& at) const {
  const double load = dead_load();
  if (load == 0) return {};
  std::vector<LineTension> lines(mesh_.mesh->lines.size());
  for (const CarriesTension* t : carry_tension_) t->tensions(at, lines);
  MPI_Allreduce(MPI_IN_PLACE, lines.data(), static_cast<int>(3 * lines.size()), MPI_DOUBLE, MPI_MAX, comm_);
  for (size_t l = 0; l < lines.size(); ++l) {
    const LineTension& t = lines[l];
    const double share = t.round_off / std::max(t.tension, load);
    if (share <= kRoundOffShare) continue;
    return fmt::format(
        "the tension of line {} is known to within {:.2g} % only, so large is rounding beside an EA of "
        "{:.3g} N; an EA of {:.0e} N is equivalent to one that does not stretch",
        mesh_.mesh->lines[l].name, 100 * share, t.EA, t.EA * kSure / share);
  }
  return {};
}

}  // namespace hawser
