// The class WaterErrors: flow force on elements compared with that on their parts, by group of lines.
#include "hawser/record/water_errors.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "hawser/advice/long_elements.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/disjoint_sets.hpp"
#include "hawser/terms/lines_in_water.hpp"

namespace hawser::record {
namespace {

constexpr double kWarned = 0.02;    // of the largest flow force
constexpr double kAccurate = 0.01;  // error of the recommended element length; fraction of the weight
constexpr double kMatters = 1e-4;   // of the largest tension, whose direction it changes by as many rad
constexpr int kMostParts = 64;      // largest subdivision tried
// Steps between evaluations in motion. An evaluation computes waves at three points of each element, a step
// at one; this adds a sixteenth of the cost of waves. A prime number avoids resonance with the wave period.
constexpr int kSteps = 47;

// The first line of those that joints hold together, of each line.
std::vector<int> joined_lines(const Mesh& mesh) {
  DisjointSets joined(mesh.lines.size());
  for (const auto& [number, n] : mesh.special_nodes())
    for (const int to : {n.pinned_to, n.tied_to})
      if (n.body < 0 && to >= 0 && mesh.node(to).body < 0) joined.unite(n.line, mesh.node(to).line);
  return joined.smallest_of_all();
}

}  // namespace

WaterErrors::WaterErrors(const model::Case& c, const System& system)
    : comm_(system.comm()),
      case_(c),
      mesh_(system.mesh()),
      structure_(*system.find<HasAxialStiffness>()),
      water_(system.find<LinesInWater>()) {
  if (water_ && !water_->moving()) water_ = nullptr;
  const std::vector<int> first = joined_lines(*mesh_.mesh);
  constexpr int kNone = -1, kSeveral = -2;
  std::vector<int> rank(first.size(), kNone);  // that has the whole group, by its first line
  for (size_t l = 0; l < first.size(); ++l) {
    const LineSpan& span = mesh_.mesh->lines[l];
    const bool cut = !mesh_.owner.whole(span.first_node, span.nodes);
    const int of_line = cut ? kSeveral : mesh_.owner[span.first_node];
    int& of_group = rank[first[l]];
    of_group = of_group == kNone || of_group == of_line ? of_line : kSeveral;
  }
  std::vector<int> group(first.size(), -1);
  for (const int rank_of_group : {kSeveral, rank_of(comm_)}) {
    shared_ = groups_.size();
    for (size_t l = 0; l < first.size(); ++l) {
      if (rank[first[l]] != rank_of_group) continue;
      if (first[l] == static_cast<int>(l)) {
        group[l] = static_cast<int>(groups_.size());
        groups_.emplace_back().first = first[l];
      }
      group[l] = group[first[l]];
      ++groups_[group[l]].lines;
    }
  }
  for (const int g : group) group_.push_back(g);
}

double WaterErrors::Group::negligible_error() const {
  return std::max({kWarned * force, kAccurate * weight, kMatters * tension});
}

void WaterErrors::update_sampled(const Kinematics& state) {
  if (state.ends_step() && ++steps_ < kSteps) return;
  steps_ = 0;
  update(state);
}

WaterErrors::Sums WaterErrors::sums(const Kinematics& state, int parts,
                                    const std::vector<bool>& groups) const {
  const size_t n = groups.size();
  Sums out{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n), std::vector<Where>(n)};
  for (const LinesInWater::WetElement& p : water_->pieces()) {
    const Element& e = mesh_.element(p.element);
    const size_t g = group_[e.line];
    if (!p.element.counted || !groups[g]) continue;
    const LinesInWater::FlowError f = water_->flow_error(state, p, parts);
    const Vec3& a = state.x[p.element.first];
    const Vec3& b = state.x[p.element.second];
    const Vec3 chord = (b - a).normalized();
    const double z = water_->above_still_water(0.5 * (a.z() + b.z()));
    const double weight = case_.line_types[e.type].mass_per_length * case_.environment.gravity -
                          (z < 0 ? p.section.buoyancy : 0);
    out.error[g] += f.error;
    out.force[g] += f.force;
    out.weight[g] += std::abs(weight) * p.section.length * chord.head<2>().norm();
    if (f.error <= out.where[g].error) continue;
    out.where[g] = {f.error,
                    mesh_.mesh->node(e.first).arc + 0.5 * e.length,
                    z,
                    p.section.length,
                    2 * p.section.radius,
                    e.line,
                    f.crossed};
  }
  const auto shared_end = groups.begin() + static_cast<std::ptrdiff_t>(shared_);
  if (std::find(groups.begin(), shared_end, true) == shared_end) return out;
  std::vector<double> shared;
  for (const auto* sum : {&out.error, &out.force, &out.weight})
    shared.insert(shared.end(), sum->begin(), sum->begin() + static_cast<std::ptrdiff_t>(shared_));
  all_reduce(comm_, MPI_SUM, shared);
  auto from = shared.begin();
  for (auto* sum : {&out.error, &out.force, &out.weight}) {
    std::copy_n(from, shared_, sum->begin());
    from += static_cast<std::ptrdiff_t>(shared_);
  }
  return out;
}

// Necessary subdivision of the elements of some groups, by trial: errors fall with the square of the length
// only if the elements resolve the flow, and they may have missed it completely. Groups that ranks share are
// tried by all of them at the same time, because they have the same sums.
std::vector<int> WaterErrors::sufficient_parts(const Kinematics& state, std::vector<bool> groups) const {
  std::vector<int> sufficient(groups.size(), kMostParts);
  for (int parts = 2; parts < kMostParts && std::find(groups.begin(), groups.end(), true) != groups.end();
       parts *= 2) {
    const std::vector<double> error = sums(state, parts, groups).error;
    for (size_t g = 0; g < groups.size(); ++g)
      if (groups[g] && error[g] <= kAccurate * groups_[g].force) {
        sufficient[g] = parts;
        groups[g] = false;
      }
  }
  return sufficient;
}

void WaterErrors::update_tension(const Kinematics& state) {
  std::vector<LineTension> lines(group_.size());
  structure_.tensions(state, lines);
  std::vector<double> largest(groups_.size());
  for (size_t l = 0; l < lines.size(); ++l)
    if (group_[l] >= 0) largest[group_[l]] = std::max(largest[group_[l]], lines[l].tension);
  if (shared_ > 0) {
    auto shared = std::span(largest).first(shared_);
    all_reduce(comm_, MPI_MAX, shared);
  }
  for (size_t g = 0; g < largest.size(); ++g) groups_[g].tension = std::max(groups_[g].tension, largest[g]);
}

void WaterErrors::update(const Kinematics& state) {
  if (!water_) return;
  const size_t n = groups_.size();
  update_tension(state);
  const Sums with_all = sums(state, 1, std::vector<bool>(n, true));
  std::vector<bool> exceeds(n);
  for (size_t i = 0; i < n; ++i) {
    Group& g = groups_[i];
    g.force = std::max(g.force, with_all.force[i]);
    g.weight = std::max(g.weight, with_all.weight[i]);
    exceeds[i] = with_all.error[i] > std::max(g.error, g.negligible_error());
  }
  const std::vector<int> parts = sufficient_parts(state, exceeds);
  for (size_t i = 0; i < n; ++i)
    if (exceeds[i]) {
      Group& g = groups_[i];
      g.error = with_all.error[i];
      g.time = state.time;
      g.parts = parts[i];
      g.where = with_all.where[i];
    }
}

std::vector<Warning> WaterErrors::warnings(const std::vector<io::SummaryRow>&) {
  std::vector<Warning> out;
  for (std::string& w : warnings()) out.push_back({std::move(w)});
  if (rank_of(comm_) != 0) out.clear();
  return out;
}

std::string WaterErrors::warning(const Group& g, const Where& w) const {
  // Morison's formula does not apply to waves shorter than the line's diameter.
  const double sufficient = std::max(w.length / g.parts, std::min(w.diameter, w.length));
  return advice::long_in_flow({.line = mesh_.mesh->line_names[w.line],
                               .length = w.length,
                               .arc = w.arc,
                               .z = w.z,
                               .time = g.time,
                               .crossed = w.crossed,
                               .in_current = water_->has_current(),
                               .in_waves = water_->has_waves(),
                               .joined = g.lines,
                               .force = g.force,
                               .error = g.error,
                               .recommended = sufficient});
}

std::vector<std::string> WaterErrors::warnings() const {
  std::vector<Where> where;
  for (const Group& g : groups_) where.push_back(g.where);
  std::vector<Where> shared(where.begin(), where.begin() + static_cast<std::ptrdiff_t>(shared_));
  if (shared_ > 0) largest_of_ranks(comm_, shared, [](const Where& w) { return w.error; });
  std::copy(shared.begin(), shared.end(), where.begin());
  struct Found {
    double fraction = 0;  // of the force
    int first = 0;        // line of the group
    size_t group = 0;     // on its rank
  };
  const auto largest_first = [](std::vector<Found>& elements) {
    std::sort(elements.begin(), elements.end(), [](const Found& a, const Found& b) {
      return std::tie(b.fraction, a.first) < std::tie(a.fraction, b.first);
    });
  };
  std::vector<Found> local;
  for (size_t i = rank_of(comm_) == 0 ? 0 : shared_; i < groups_.size(); ++i) {
    const Group& g = groups_[i];
    if (g.error <= g.negligible_error() || !(where[i].error > 0)) continue;
    local.push_back({g.error / g.force, g.first, i});
  }
  largest_first(local);
  int count = static_cast<int>(local.size());
  all_reduce(comm_, MPI_SUM, count);
  constexpr size_t kMost = 3;  // of a farm with equal lines
  local.resize(std::min(local.size(), kMost));
  std::vector<Found> all = gather_all(comm_, local);
  largest_first(all);
  all.resize(std::min(all.size(), kMost));
  std::vector<std::string> out;
  for (const Found& f : all) {
    const bool on_this_rank =
        std::any_of(local.begin(), local.end(), [&](const Found& m) { return m.first == f.first; });
    out.push_back(first_text(comm_, on_this_rank ? warning(groups_[f.group], where[f.group]) : ""));
  }
  if (count > static_cast<int>(kMost))
    out.back() += advice::more_long_in_flow(static_cast<size_t>(count) - kMost);
  return out;
}

}  // namespace hawser::record
