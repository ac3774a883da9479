// The class System: limits of a step by impacts, whether a step resolved its impacts, and the verdict of the
// terms on a trial.
#include <algorithm>
#include <utility>

#include "hawser/base/gather.hpp"
#include "hawser/system/system.hpp"
#include "logged.hpp"

namespace hawser {

void System::sum(std::span<double> values) const { all_reduce(comm_, MPI_SUM, values); }

// Motion of the masses of each line in the state, with the energy of its impacts. The second half of the
// result is the same with algorithmic accelerations as velocities. impacts: of this rank. of_all: of lines of
// other ranks as well.
std::vector<LineMotion> System::motions(const Kinematics& at, const StoredMotion& stored,
                                        const std::vector<ImpactEvent>& impacts, bool of_all) const {
  const size_t n = lines_;
  std::vector<LineMotion> lines(2 * n);
  Kinematics accelerations = at;
  accelerations.v = stored.accelerations;
  for (const MovesMasses* t : move_masses_) {
    t->motion(at, std::span(lines).first(n));
    t->motion(accelerations, std::span(lines).last(n));
  }
  for (const ImpactEvent& s : impacts) {
    lines[s.line].impact_energy += s.energy();
    if (s.other >= 0) lines[s.other].impact_energy += s.energy();
  }
  static_assert(sizeof(LineMotion) == 6 * sizeof(double));
  const std::span<double> numbers(reinterpret_cast<double*>(lines.data()), 6 * lines.size());
  if (of_all)
    sum(numbers);
  else
    sum_cut_lines({numbers.first(6 * n), numbers.last(6 * n)});
  return lines;
}

StepLimit System::longest_step(const Kinematics& committed, const StoredMotion& stored, double most) {
  ImpactEvents impacts;
  impacts.most = most;
  {
    const Logged logged(limit_event_);
    for (const LimitsSteps* t : limit_steps_) t->limit_step(committed, impacts);
  }
  double both[2] = {impacts.longest, impacts.list.empty() ? 1.0 : 0.0};
  all_reduce(comm_, MPI_MIN, both);
  StepLimit limit;
  limit.longest = both[0];
  // The tolerance is also set if there is no impact yet: impacts that only the end of the step shows are
  // compared with it.
  const bool no_impact = both[1] > 0;
  const std::vector<LineMotion> lines = motions(committed, stored, impacts.list, !no_impact);
  const size_t n = lines_;
  energy_tolerance_ = energy_tolerance(std::span(lines).first(n));
  limit.longest = std::min(limit.longest, growth_limited_step(std::span(lines).last(n), energy_tolerance_,
                                                              stored.share, committed.step));
  all_reduce(comm_, MPI_MIN, limit.longest);
  if (no_impact) return limit;
  const StepLimit impact_limited =
      impact_limited_step(impacts.list, energy_tolerance_, std::min(most, limit.longest),
                          [this](std::span<double> values) { sum(values); });
  limit.longest = std::min(limit.longest, impact_limited.longest);
  limit.period = impact_limited.period;
  return limit;
}

bool System::resolves_impacts(const Kinematics& trial) {
  UnresolvedImpacts found;
  {
    const Logged logged(limit_event_);
    for (LimitsSteps* t : limit_steps_) t->unresolved(trial, found);
  }
  int any[2] = {found.too_deep, !found.list.empty()};
  all_reduce(comm_, MPI_MAX, any);
  if (any[0]) return false;
  if (!any[1]) return true;
  all_reduce(comm_, MPI_MAX, energy_tolerance_);  // of lines of other ranks as well
  return within_tolerance(found.list, energy_tolerance_, [this](std::span<double> values) { sum(values); });
}

Verdict System::check_step(const Kinematics& trial) const {
  Verdict worst;
  for (const LimitsSteps* t : limit_steps_)
    if (Verdict v = t->check_step(trial); v.kind > worst.kind) worst = std::move(v);
  int kind = static_cast<int>(worst.kind);
  all_reduce(comm_, MPI_MAX, kind);
  if (kind == static_cast<int>(Verdict::Kind::accept)) return {};
  if (kind != static_cast<int>(worst.kind)) worst.because = {};
  worst.kind = static_cast<Verdict::Kind>(kind);
  return worst;
}

}  // namespace hawser
