// The class System: step limits by impacts, and the verdict of the terms on a trial, including whether it
// resolved its impacts.
#include <algorithm>
#include <iterator>
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

// Lines of impacts of which this rank owns no nodes.
template <class Impact>
std::vector<int> lines_elsewhere(const std::vector<Impact>& impacts, const std::vector<int>& local_lines) {
  std::vector<int> out;
  for (const Impact& s : impacts)
    for (const int line : {s.line, s.other})
      if (line >= 0 && !std::binary_search(local_lines.begin(), local_lines.end(), line)) out.push_back(line);
  return out;
}

// Lines that any rank lists, ascending. Collective.
std::vector<int> of_all_ranks(MPI_Comm comm, const std::vector<int>& lines) {
  std::vector<int> out = gather_all(comm, lines);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
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
  const auto growth_limit = [&](std::span<LineMotion> lines, int lines_with_impacts) {
    energy_tolerance_ = energy_tolerance(lines.first(lines_), lines_with_impacts);
    return growth_limited_step(lines.last(lines_), energy_tolerance_, stored.factor, committed.last_step());
  };
  std::vector<LineMotion> lines = local_motions;
  sum_cut_lines({numbers_of(std::span(lines).first(lines_)), numbers_of(std::span(lines).last(lines_))});
  // Without impacts and cut lines this is the only reduction.
  const std::vector<int> elsewhere = lines_elsewhere(impacts.list, local_lines_);
  double minima[] = {impacts.longest, growth_limit(lines, 0), impacts.list.empty() ? 1.0 : 0.0,
                     elsewhere.empty() ? 1.0 : 0.0};
  all_reduce(comm_, MPI_MIN, minima);
  const auto [longest_by_terms, longest_by_growth, no_impacts, none_elsewhere] = minima;
  StepLimit limit;
  limit.longest = std::min(longest_by_terms, longest_by_growth);
  if (no_impacts > 0) return limit;

  lines = local_motions;
  for (const ImpactEvent& s : impacts.list) {
    lines[s.line].impact_energy += s.energy();
    if (s.other >= 0) lines[s.other].impact_energy += s.energy();
  }
  // Lines that several ranks have: those that the partition cuts, and those with an impact on another rank.
  std::vector<int> shared = cut_;
  if (none_elsewhere == 0) {
    const std::vector<int> others = of_all_ranks(comm_, elsewhere);
    shared.clear();
    std::set_union(cut_.begin(), cut_.end(), others.begin(), others.end(), std::back_inserter(shared));
  }
  double with_impacts = 0;  // number of lines
  for (const int l : local_lines_)
    if (!std::binary_search(shared.begin(), shared.end(), l)) with_impacts += lines[l].has_impacts();
  sum_lines(shared, {numbers_of(std::span(lines).first(lines_)), numbers_of(std::span(lines).last(lines_))},
            {&with_impacts, 1});
  for (const int l : shared) with_impacts += lines[l].has_impacts();
  limit.longest = std::min(longest_by_terms, growth_limit(lines, static_cast<int>(with_impacts)));
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
  const std::vector<int> elsewhere = lines_elsewhere(unresolved_impacts.list, local_lines_);
  double any_elsewhere = elsewhere.empty() ? 0 : 1;
  for (double* number : {&severity, &too_deep, &any_impact, &any_elsewhere}) together.add(*number);
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
  if (any_elsewhere > 0) {
    const std::vector<int> lines = of_all_ranks(comm_, elsewhere);
    std::vector<double> tolerance;
    for (const int l : lines) tolerance.push_back(energy_tolerance_[l]);
    all_reduce(comm_, MPI_MAX, tolerance);  // 0 on ranks that do not know it
    for (size_t i = 0; i < lines.size(); ++i) energy_tolerance_[lines[i]] = tolerance[i];
  }
  const auto over_ranks = [this](std::span<double> values) { sum(values); };
  return within_tolerance(unresolved_impacts.list, energy_tolerance_, over_ranks) ? Verdict{} : not_resolved;
}

}  // namespace hawser
