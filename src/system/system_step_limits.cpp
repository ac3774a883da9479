// The class System: step limits by impacts, and the verdict of the terms on a trial, including whether it
// resolved its impacts.
#include <algorithm>
#include <utility>

#include "hawser/advice/steps.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/system/system.hpp"
#include "logged.hpp"

namespace hawser {

void System::sum(std::span<double> values) const { all_reduce(comm_, MPI_SUM, values); }

namespace {
std::span<double> numbers_of(std::span<LineMotion> lines) {
  static_assert(sizeof(LineMotion) == 6 * sizeof(double));
  return {reinterpret_cast<double*>(lines.data()), 6 * lines.size()};
}
}  // namespace

// This rank's part of the motion of the masses of each line in the state, without its impacts. The second
// half of the result is the same with algorithmic accelerations as velocities.
std::vector<LineMotion> System::motions(const Kinematics& state, const StoredMotion& stored) const {
  std::vector<LineMotion> lines(2 * lines_);
  Kinematics accelerations = state;
  accelerations.v = stored.accelerations;
  for (const MovesMasses* t : listed<MovesMasses>()) {
    t->motion(state, std::span(lines).first(lines_));
    t->motion(accelerations, std::span(lines).last(lines_));
  }
  return lines;
}

StepLimit System::longest_step(const Kinematics& committed, const StoredMotion& stored, double max_step) {
  ImpactEvents impacts;
  impacts.max_step = max_step;
  {
    const Logged logged(limit_event_);
    for (LimitsSteps* t : listed<LimitsSteps>()) t->limit_step(committed, impacts);
  }
  const std::vector<LineMotion> local_motions = motions(committed, stored);
  // The tolerance is also set without impacts, because unpredicted impacts found at the end of the step are
  // compared with it.
  const auto growth_limit = [&](std::span<LineMotion> lines) {
    energy_tolerance_ = energy_tolerance(lines.first(lines_));
    return growth_limited_step(lines.last(lines_), energy_tolerance_, stored.factor, committed.last_step());
  };
  std::vector<LineMotion> lines = local_motions;
  sum_cut_lines({numbers_of(std::span(lines).first(lines_)), numbers_of(std::span(lines).last(lines_))});
  // Without impacts and cut lines this is the only reduction.
  double minima[] = {impacts.longest, growth_limit(lines), impacts.list.empty() ? 1.0 : 0.0};
  all_reduce(comm_, MPI_MIN, minima);
  const auto [longest_by_terms, longest_by_growth, no_impacts] = minima;
  StepLimit limit;
  limit.longest = std::min(longest_by_terms, longest_by_growth);
  if (no_impacts > 0) return limit;

  lines = local_motions;
  for (const ImpactEvent& s : impacts.list) {
    lines[s.line].impact_energy += s.energy();
    if (s.other >= 0) lines[s.other].impact_energy += s.energy();
  }
  sum(numbers_of(lines));
  limit.longest = std::min(longest_by_terms, growth_limit(lines));
  all_reduce(comm_, MPI_MIN, limit.longest);
  const StepLimit impact_limited =
      impact_limited_step(impacts.list, energy_tolerance_, std::min(max_step, limit.longest),
                          [this](std::span<double> values) { sum(values); });
  limit.longest = std::min(limit.longest, impact_limited.longest);
  limit.period = impact_limited.period;
  return limit;
}

Verdict System::check_step(const Kinematics& trial, bool impacts, RankMax together) {
  Verdict worst;
  for (const LimitsSteps* t : listed<LimitsSteps>())
    if (Verdict v = t->check_step(trial); v.kind > worst.kind) worst = std::move(v);
  UnresolvedImpacts unresolved_impacts;
  if (impacts) {
    const Logged logged(limit_event_);
    for (LimitsSteps* t : listed<LimitsSteps>()) t->unresolved(trial, unresolved_impacts);
  }
  // A single reduction for all quantities of a trial, unless a rank has an unresolved impact.
  double severity = static_cast<double>(worst.kind);
  double too_deep = unresolved_impacts.too_deep ? 1 : 0, any_impact = unresolved_impacts.list.empty() ? 0 : 1;
  for (double* number : {&severity, &too_deep, &any_impact}) together.add(*number);
  together.reduce(comm_);
  const auto kind = static_cast<Verdict::Kind>(severity);
  if (kind != Verdict::Kind::accept) {
    if (kind != worst.kind) worst.because = {};
    worst.kind = kind;
    return worst;
  }
  const Verdict not_resolved{Verdict::Kind::shorter, advice::ImpactNotResolved{}};
  if (too_deep > 0) return not_resolved;
  if (any_impact == 0) return {};
  all_reduce(comm_, MPI_MAX, energy_tolerance_);  // also of lines of other ranks
  const auto over_ranks = [this](std::span<double> values) { sum(values); };
  return within_tolerance(unresolved_impacts.list, energy_tolerance_, over_ranks) ? Verdict{} : not_resolved;
}

}  // namespace hawser
