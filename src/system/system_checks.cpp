// The class System: checks of states that solve the equations but are not valid results.
#include <algorithm>

#include "hawser/base/mpi.hpp"
#include "hawser/system/system.hpp"

namespace hawser {
namespace {
constexpr double kMaxRoundOffRatio = 0.01;  // largest ratio of round-off to tension
constexpr double kSure = 1e-3;              // this ratio for the EA that the message recommends
}  // namespace

Overstretch System::overstretch(const Kinematics& state) const {
  Overstretch worst;
  for (const HasAxialStiffness* t : listed<HasAxialStiffness>())
    if (const Overstretch o = t->overstretched(state); o.beyond > worst.beyond) worst = o;
  return worst;
}

std::optional<advice::Overstretched> System::overstretched(const Kinematics& state) const {
  Overstretch worst = overstretch(state);
  if (!broadcast_largest(comm_, worst.beyond, 0, worst)) return std::nullopt;
  return advice::Overstretched{.place = mesh_.mesh->place(worst.node),
                               .strain = worst.strain,
                               .limit = worst.limit,
                               .tension = worst.tension,
                               .EA = worst.EA};
}

std::vector<LineTension> System::line_tensions(const Kinematics& state) const {
  std::vector<LineTension> all(mesh_.mesh->lines.size());
  for (const HasAxialStiffness* t : listed<HasAxialStiffness>()) t->tensions(state, all);
  MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(3 * all.size()), MPI_DOUBLE, MPI_MAX, comm_);
  return all;
}

// Without dead loads the tension may be zero to round-off.
std::optional<advice::LostInRounding> System::lost_in_rounding(const Kinematics& state) const {
  const double load = dead_load();
  if (load == 0) return std::nullopt;
  const std::vector<LineTension> lines = line_tensions(state);
  for (size_t l = 0; l < lines.size(); ++l) {
    const LineTension& t = lines[l];
    const double ratio = t.round_off / std::max(t.tension, load);
    if (ratio <= kMaxRoundOffRatio) continue;
    return advice::LostInRounding{mesh_.mesh->line_names[l], ratio, t.EA, t.EA * kSure / ratio};
  }
  return std::nullopt;
}

}  // namespace hawser
