// The part of System that follows impacts: how long a step may be by what strikes, and whether one that was
// taken shows what nobody foresaw.
#include <algorithm>

#include "hawser/system/system.hpp"
#include "logged.hpp"

namespace hawser {

void System::sum(std::span<double> values) const {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM, comm_);
}

// J by line. strikes: of this rank.
std::vector<double> System::bearable_energies(const Kinematics& at,
                                              const std::vector<ImpactEvent>& strikes) const {
  std::vector<LineMotion> lines(sums_ / 2);
  for (const MovesMasses* t : move_masses_) t->motion(at, lines);
  for (const ImpactEvent& s : strikes) {
    lines[static_cast<size_t>(s.line)].striking += s.energy();
    if (s.other >= 0) lines[static_cast<size_t>(s.other)].striking += s.energy();
  }
  static_assert(sizeof(LineMotion) == 6 * sizeof(double));
  sum({reinterpret_cast<double*>(lines.data()), 6 * lines.size()});
  return bearable(lines);
}

StepLimit System::longest_step(const Kinematics& committed, double most) {
  ImpactEvents strikes;
  strikes.most = most;
  {
    const Logged logged(limit_event_);
    for (const LimitsSteps* t : limit_steps_) t->limit_step(committed, strikes);
  }
  double both[2] = {strikes.longest, strikes.list.empty() ? 1.0 : 0.0};
  MPI_Allreduce(MPI_IN_PLACE, both, 2, MPI_DOUBLE, MPI_MIN, comm_);
  StepLimit limit;
  limit.longest = both[0];
  // Also where nothing strikes yet: what comes unforeseen is judged by this step's energies, not by those of
  // whenever something struck.
  bearable_ = bearable_energies(committed, strikes.list);
  for (LimitsSteps* t : limit_steps_) t->bear(bearable_);
  if (both[1] > 0) return limit;
  const StepLimit struck = bounded_step(strikes.list, bearable_, std::min(most, limit.longest),
                                        [this](std::span<double> values) { sum(values); });
  limit.longest = std::min(limit.longest, struck.longest);
  limit.period = struck.period;
  return limit;
}

bool System::foreseen(const Kinematics& trial) {
  Unforeseen found;
  {
    const Logged logged(limit_event_);
    for (LimitsSteps* t : limit_steps_) t->unforeseen(trial, found);
  }
  int any[2] = {found.too_deep, !found.partings.empty()};
  MPI_Allreduce(MPI_IN_PLACE, any, 2, MPI_INT, MPI_MAX, comm_);
  if (any[0]) return false;
  return !any[1] ||
         bearable_partings(found.partings, bearable_, [this](std::span<double> values) { sum(values); });
}

}  // namespace hawser
