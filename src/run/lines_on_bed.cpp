// Lengths of lines on the seabed between touchdown points; lines that differ only in position are reported
// together. Lines below the water.
#include "hawser/run/lines_on_bed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "hawser/advice/statics.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/model/summary.hpp"
#include "hawser/record/touchdown.hpp"
#include "hawser/terms/bed_contact.hpp"

namespace hawser::run {

std::vector<std::string> lines_on_bed(const model::Case& c, const System& system, const Kinematics& state) {
  std::vector<std::string> out;
  const auto* bed = system.find<BedContact>();
  if (!bed) return out;
  constexpr size_t kShown = 20;
  std::vector<double> sums;  // by line
  for (const BedContact::OnBed& l : bed->on_bed(state))
    sums.insert(sums.end(), {l.friction_length, l.sticking, l.friction_tension});
  all_reduce(system.comm(), MPI_SUM, sums);
  // Between touchdown points, as in the results.
  const std::vector<record::Touchdown> down =
      record::Touchdowns(system.comm(), c, system.mesh()).of_all_lines(state);
  if (rank_of(system.comm()) != 0) return out;
  // Lines that differ only in position are reported together.
  std::map<std::pair<bool, std::string>, std::pair<std::vector<std::string>, std::vector<advice::OnBed>>>
      like;
  std::vector<decltype(like)::const_iterator> in_order;
  for (size_t l = 0; l < down.size(); ++l) {
    if (!(down[l].laid > 0)) continue;
    const bool friction = sums[3 * l] > 0;
    const auto [at, is_new] = like.try_emplace({friction, model::description_of(c, c.lines[l])});
    if (is_new) in_order.push_back(at);
    at->second.first.push_back(system.mesh().mesh->line_names[l]);
    at->second.second.push_back({down[l].laid, friction, std::abs(sums[3 * l + 2]), sums[3 * l + 1]});
  }
  size_t more = 0;
  for (const auto& group : in_order) {
    const auto& [names, values] = group->second;
    if (out.size() == kShown)
      more += names.size();
    else
      out.push_back(advice::lie_on_bed(names, values));
  }
  if (more > 0) out.push_back(advice::more_lines_on_bed(more));
  return out;
}

std::string lines_below_water(const model::Case& c, const System& system, const Kinematics& state) {
  constexpr double kBelow = 0.01;  // of the depth; anchors may be that far below the mean bed
  const model::Water& water = c.environment.water;
  if (c.environment.seabed.present || !water.present || !(water.depth > 0)) return {};
  const LocalMesh& mesh = system.mesh();
  std::set<int> lines;     // of this rank, below the bottom
  double deepest = 0;      // m
  double with_anchor = 0;  // 1: an anchor is below the bottom
  for (int n = 0; n < mesh.owned; ++n) {
    const Node& node = mesh.node(n);
    const double below = water.surface - water.depth - state.x[static_cast<size_t>(n)].z();
    if (node.line >= std::ssize(mesh.mesh->lines) || !(below > kBelow * water.depth)) continue;
    lines.insert(node.line);
    deepest = std::max(deepest, below);
    for (const LineEnd end : kLineEnds)
      if (mesh.mesh->lines[node.line].end_node(end) == mesh.global[static_cast<size_t>(n)] &&
          c.lines[static_cast<size_t>(node.line)].end(end).kind == model::EndKind::anchor)
        with_anchor = 1;
  }
  const std::vector<int> all = gather_all(system.comm(), std::vector<int>(lines.begin(), lines.end()));
  std::array<double, 2> largest{deepest, with_anchor};
  all_reduce(system.comm(), MPI_MAX, largest);
  std::vector<std::string> names;
  for (const int line : std::set<int>(all.begin(), all.end()))
    if (const std::string name = mesh.mesh->line_names[line]; names.empty() || names.back() != name)
      names.push_back(name);  // once for all parts of a line that events cut
  return names.empty() ? "" : advice::lie_below_water(names, largest[0], water.depth, largest[1] > 0);
}

}  // namespace hawser::run
