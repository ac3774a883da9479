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

std::vector<int> united(std::span<const int> a, std::span<const int> b) {
  std::vector<int> out;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

// The impacts with indices of `tolerance` in place of the numbers of lines.
template <class Impact>
std::vector<Impact> at_places(std::vector<Impact> impacts, const PerLine<double>& tolerance) {
  for (Impact& s : impacts)
    for (int* line : {&s.line, &s.other})
      if (*line >= 0) *line = static_cast<int>(tolerance.place(*line));
  return impacts;
}
}  // namespace

System::Motions System::motions(const Kinematics& state, const StoredMotion& stored) const {
  Motions out(lines_);
  Kinematics accelerations = state;
  accelerations.v = stored.accelerations;
  for (const MovesMasses* t : listed<MovesMasses>()) {
    t->motion(state, out.moving);
    t->motion(accelerations, out.stored);
  }
  return out;
}

void System::sum_lines(std::span<const int> lines, Motions& motions, std::span<double> more) const {
  constexpr size_t kNumbers = 6;
  static_assert(sizeof(LineMotion) == kNumbers * sizeof(double));
  std::vector<double> sums;
  const auto each = [&](const auto& visit) {
    for (PerLine<LineMotion>* of_lines : {&motions.moving, &motions.stored})
      for (const int l : lines) visit({reinterpret_cast<double*>(&(*of_lines)[l]), kNumbers});
    visit(more);
  };
  each([&](std::span<double> numbers) { sums.insert(sums.end(), numbers.begin(), numbers.end()); });
  sum(sums);
  auto from = sums.begin();
  each([&](std::span<double> numbers) {
    std::copy_n(from, numbers.size(), numbers.begin());
    from += std::ssize(numbers);
  });
}

StepLimit System::longest_step(const Kinematics& committed, const StoredMotion& stored, double max_step) {
  ImpactEvents impacts;
  impacts.max_step = max_step;
  {
    const Logged logged(limit_event_);
    for (LimitsSteps* t : listed<LimitsSteps>()) t->limit_step(committed, impacts);
  }
  // The tolerance is also set without impacts, because unpredicted impacts found at the end of the step are
  // compared with it.
  const auto growth_limit = [&](const Motions& motions, int lines_with_impacts) {
    const std::span<const int> lines = motions.moving.lines();
    energy_tolerance_ = PerLine<double>({lines.begin(), lines.end()});
    const auto tolerance = energy_tolerance(motions.moving.values(), lines_with_impacts);
    std::copy(tolerance.begin(), tolerance.end(), energy_tolerance_.values().begin());
    return growth_limited_step(motions.stored.values(), tolerance, stored.factor, committed.last_step());
  };
  const Motions local = motions(committed, stored);
  Motions without_impacts = local;
  if (!cut_.empty()) sum_lines(cut_, without_impacts);
  // Without impacts and cut lines this is the only reduction.
  const std::vector<int> elsewhere = lines_elsewhere(impacts.list, local_lines_);
  double minima[] = {impacts.longest, growth_limit(without_impacts, 0), impacts.list.empty() ? 1.0 : 0.0,
                     elsewhere.empty() ? 1.0 : 0.0};
  all_reduce(comm_, MPI_MIN, minima);
  const auto [longest_by_terms, longest_by_growth, no_impacts, none_elsewhere] = minima;
  StepLimit limit;
  limit.longest = std::min(longest_by_terms, longest_by_growth);
  if (no_impacts > 0) return limit;

  // Lines that several ranks have: those that the partition cuts, and those with an impact on another rank.
  std::vector<int> shared = cut_;
  std::vector<int> lines = lines_;
  if (none_elsewhere == 0) {
    const std::vector<int> others = of_all_ranks(comm_, elsewhere);
    shared = united(cut_, others);
    lines = united(lines_, others);
  }
  Motions all(lines);
  for (const int l : lines_) {
    all.moving[l] = local.moving[l];
    all.stored[l] = local.stored[l];
  }
  for (const ImpactEvent& s : impacts.list) {
    all.moving[s.line].impact_energy += s.energy();
    if (s.other >= 0) all.moving[s.other].impact_energy += s.energy();
  }
  double with_impacts = 0;  // number of lines
  for (const int l : local_lines_)
    if (!std::binary_search(shared.begin(), shared.end(), l)) with_impacts += all.moving[l].has_impacts();
  sum_lines(shared, all, {&with_impacts, 1});
  for (const int l : shared) with_impacts += all.moving[l].has_impacts();
  limit.longest = std::min(longest_by_terms, growth_limit(all, static_cast<int>(with_impacts)));
  all_reduce(comm_, MPI_MIN, limit.longest);
  const StepLimit impact_limited = impact_limited_step(
      at_places(std::move(impacts.list), energy_tolerance_), energy_tolerance_.values(),
      std::min(max_step, limit.longest), [this](std::span<double> values) { sum(values); });
  limit.longest = std::min(limit.longest, impact_limited.longest);
  limit.period = impact_limited.period;
  limit.decay = impact_limited.decay;
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
  double too_fast = unresolved_impacts.too_fast ? 1 : 0;
  double any_impact = unresolved_impacts.list.empty() ? 0 : 1;
  const std::vector<int> elsewhere = lines_elsewhere(unresolved_impacts.list, local_lines_);
  double any_elsewhere = elsewhere.empty() ? 0 : 1;
  for (double* number : {&severity, &too_fast, &any_impact, &any_elsewhere}) together.add(*number);
  together.reduce(comm_);
  const auto kind = static_cast<Verdict::Kind>(severity);
  if (kind != Verdict::Kind::accept) {
    if (kind != worst.kind) worst.because = {};
    worst.kind = kind;
    return worst;
  }
  const Verdict not_resolved{Verdict::Kind::shorter, advice::ImpactNotResolved{}};
  if (too_fast > 0) return not_resolved;
  if (any_impact == 0) return {};
  if (any_elsewhere > 0) {
    const std::vector<int> lines = of_all_ranks(comm_, elsewhere);
    std::vector<double> tolerance;
    for (const int l : lines) tolerance.push_back(energy_tolerance_.has(l) ? energy_tolerance_[l] : 0.0);
    all_reduce(comm_, MPI_MAX, tolerance);
    PerLine<double> more(united(energy_tolerance_.lines(), lines));
    for (const int l : energy_tolerance_.lines()) more[l] = energy_tolerance_[l];
    for (size_t i = 0; i < lines.size(); ++i) more[lines[i]] = tolerance[i];
    energy_tolerance_ = std::move(more);
  }
  const auto over_ranks = [this](std::span<double> values) { sum(values); };
  const auto list = at_places(std::move(unresolved_impacts.list), energy_tolerance_);
  return within_tolerance(list, energy_tolerance_.values(), over_ranks) ? Verdict{} : not_resolved;
}

}  // namespace hawser
