// The class WaterErrors: flow force on elements compared with that on their parts, by group of lines.
#include "hawser/record/water_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

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
  for (const auto& [number, n] : mesh.own_nodes())
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
      water_(system.find<LinesInWater>()),
      group_(joined_lines(*mesh_.mesh)),
      groups_(group_.size()) {
  if (water_ && !water_->moving()) water_ = nullptr;
}

double WaterErrors::Group::bears() const {
  return std::max({kWarned * force, kAccurate * weight, kMatters * tension});
}

void WaterErrors::update_sampled(const Kinematics& at) {
  if (at.after_step() && ++steps_ < kSteps) return;
  steps_ = 0;
  update(at);
}

WaterErrors::Sums WaterErrors::sums(const Kinematics& at, int parts, const std::vector<bool>& groups) const {
  const size_t n = groups.size();
  std::vector<double> all(3 * n);
  std::vector<Where> where(n);
  for (const LinesInWater::WetElement& p : water_->pieces()) {
    const Element& e = mesh_.element(p.element);
    const size_t g = group_[e.line];
    if (!p.element.counted || !groups[g]) continue;
    const LinesInWater::FlowError f = water_->flow_error(at, p, parts);
    const Vec3 &a = at.x[p.element.first], &b = at.x[p.element.second], chord = (b - a).normalized();
    const double z = water_->above_still_water(0.5 * (a.z() + b.z()));
    const double weight = case_.line_types[e.type].mass_per_length * case_.environment.gravity -
                          (z < 0 ? p.section.buoyancy : 0);
    all[g] += f.error;
    all[n + g] += f.force;
    all[2 * n + g] += std::abs(weight) * p.section.length * chord.head<2>().norm();
    if (f.error <= where[g].error) continue;
    where[g] = {f.error,
                mesh_.mesh->node(e.first).arc + 0.5 * e.length,
                z,
                p.section.length,
                2 * p.section.radius,
                e.line,
                f.crossed};
  }
  all_reduce(comm_, MPI_SUM, all);
  const auto part = [&](size_t k) {
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(k * n);
    return std::vector<double>(from, from + static_cast<std::ptrdiff_t>(n));
  };
  return {part(0), part(1), part(2), std::move(where)};
}

// Necessary subdivision of the elements of some groups, by trial: errors fall with the square of the length
// only if the elements resolve the flow, and they may have missed it completely.
std::vector<int> WaterErrors::sufficient_parts(const Kinematics& at, std::vector<bool> groups) const {
  std::vector<int> sufficient(groups.size(), kMostParts);
  for (int parts = 2; parts < kMostParts && std::find(groups.begin(), groups.end(), true) != groups.end();
       parts *= 2) {
    const std::vector<double> error = sums(at, parts, groups).error;
    for (size_t g = 0; g < groups.size(); ++g)
      if (groups[g] && error[g] <= kAccurate * groups_[g].force) {
        sufficient[g] = parts;
        groups[g] = false;
      }
  }
  return sufficient;
}

void WaterErrors::update_tension(const Kinematics& at) {
  std::vector<LineTension> lines(group_.size());
  structure_.tensions(at, lines);
  std::vector<double> largest(group_.size());
  for (size_t l = 0; l < lines.size(); ++l)
    largest[group_[l]] = std::max(largest[group_[l]], lines[l].tension);
  all_reduce(comm_, MPI_MAX, largest);
  for (size_t g = 0; g < largest.size(); ++g) groups_[g].tension = std::max(groups_[g].tension, largest[g]);
}

void WaterErrors::update(const Kinematics& at) {
  if (!water_) return;
  const size_t n = groups_.size();
  update_tension(at);
  const Sums with_all = sums(at, 1, std::vector<bool>(n, true));
  std::vector<bool> exceeds(n);
  for (size_t i = 0; i < n; ++i) {
    Group& g = groups_[i];
    g.force = std::max(g.force, with_all.force[i]);
    g.weight = std::max(g.weight, with_all.weight[i]);
    exceeds[i] = with_all.error[i] > std::max(g.error, g.bears());
  }
  const std::vector<int> parts = sufficient_parts(at, exceeds);
  for (size_t i = 0; i < n; ++i)
    if (exceeds[i]) {
      Group& g = groups_[i];
      g.error = with_all.error[i];
      g.time = at.time;
      g.parts = parts[i];
      g.where = with_all.where[i];
    }
}

std::vector<Finding> WaterErrors::findings(const std::vector<io::SummaryRow>&, const Audit&) {
  std::vector<Finding> out;
  for (std::string& w : warnings()) out.push_back({std::move(w)});
  return out;
}

std::vector<std::string> WaterErrors::warnings() const {
  std::vector<Where> where;
  for (const Group& g : groups_) where.push_back(g.where);
  largest_of_ranks(comm_, where, [](const Where& w) { return w.error; });
  std::vector<std::pair<double, std::string>> found;  // largest fraction of the force first
  for (size_t i = 0; i < groups_.size(); ++i) {
    const Group& g = groups_[i];
    const Where& w = where[i];
    if (g.error <= g.bears() || !(w.error > 0)) continue;
    const auto joined = std::count(group_.begin(), group_.end(), group_[w.line]);
    // Morison's formula does not apply to waves shorter than the line's diameter.
    const double sufficient = std::max(w.length / g.parts, std::min(w.diameter, w.length));
    found.emplace_back(-g.error / g.force, advice::long_in_flow({.line = mesh_.mesh->lines[w.line].name,
                                                                 .length = w.length,
                                                                 .arc = w.arc,
                                                                 .z = w.z,
                                                                 .time = g.time,
                                                                 .crossed = w.crossed,
                                                                 .in_current = water_->has_current(),
                                                                 .in_waves = water_->has_waves(),
                                                                 .joined = joined,
                                                                 .force = g.force,
                                                                 .error = g.error,
                                                                 .recommended = sufficient}));
  }
  constexpr size_t kMost = 3;  // of a farm with equal lines
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> out;
  for (const auto& [order, text] : found)
    if (out.size() < kMost) out.push_back(text);
  if (found.size() > kMost) out.back() += advice::more_long_in_flow(found.size() - kMost);
  return out;
}

}  // namespace hawser::record
