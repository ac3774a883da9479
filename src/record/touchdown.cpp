// The class Touchdowns: each rank finds the first change of contact from either end of its lines, and the
// place from the nearby nodes (touchdown_place.hpp). Ranks combine their data of lines that the partition
// cuts.
#include "hawser/record/touchdown.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "hawser/base/mpi.hpp"
#include "hawser/geometry/surface.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/bed_touch.hpp"

namespace hawser::record {
namespace {
constexpr double kHeld = 1e-3;  // of the radius: an end held on the bed lies there up to round-off
}

Touchdowns::Touchdowns(MPI_Comm comm, const model::Case& c, const LocalMesh& local)
    : comm_(comm), bed_(c.environment.seabed), normal_(model::bed_normal(bed_)), local_(local) {
  if (!bed_.present) return;
  const Mesh& mesh = *local.mesh;
  const LineOwners owners = line_owners(local);
  cut_ = owners.cut.size();
  lines_ = owners.cut;
  lines_.insert(lines_.end(), owners.uncut.begin(), owners.uncut.end());
  slot_.assign(mesh.lines.size(), -1);
  for (size_t k = 0; k < lines_.size(); ++k) slot_[lines_[k]] = static_cast<int>(k);
  std::sort(lines_.begin(), lines_.end());
  std::vector<double> touching;  // by line type
  for (const model::LineType& t : c.line_types) touching.push_back(model::touching_height(c, t));
  heights_.resize(local.element_ghosts_end);
  for (size_t k = 0; k < heights_.size(); ++k) {
    const int global = local.global[k];
    const Node& n = mesh.node(global);
    if (n.body >= 0) continue;
    const LineSpan& span = mesh.lines[n.line];
    const int i = global - span.first_node;
    Height& h = heights_[k];
    h.end = i == 0 || i == span.nodes - 1;
    for (const int e : {i - 1, i})
      if (e >= 0 && e < span.elements) {
        const Element& element = mesh.element(span.first_element + e);
        h.touching = std::max(h.touching, touching[element.type]);
      }
  }
}

Touchdowns::Above Touchdowns::above(size_t n, const Kinematics& state) const {
  Above out{normal_.dot(state.x[n] + Vec3(0, 0, bed_.depth)), normal_};
  if (bed_.surface) {
    const auto near = bed_.surface->query(state.x[n], std::numeric_limits<double>::infinity());
    out = near ? Above{near->distance, near->normal} : Above{HUGE_VAL, normal_};
  }
  const Height& h = heights_[n];
  out.gap -= h.touching;
  if (h.end && out.gap > 0 && out.gap < kHeld * h.touching) out.gap = 0;
  return out;
}

// Sums or minimises the numbers of cut lines over the ranks; `numbers`: per line.
template <class T>
void Touchdowns::join(MPI_Op op, std::vector<T>& values, size_t numbers) const {
  if (cut_ == 0) return;
  auto cut = std::span(values).first(cut_ * numbers);
  all_reduce(comm_, op, cut);
}

Touchdowns::Changes Touchdowns::changes(const std::vector<double>& gap) const {
  Changes out{std::vector<int>(2 * lines_.size(), Changes::kNone), std::vector<double>(lines_.size(), 0)};
  for (const LocalElement& e : local_.elements) {
    if (!e.counted) continue;
    const Element& g = local_.element(e);
    const size_t l = slot_[g.line];
    const double a = gap[e.first];
    const double b = gap[e.second];
    if (lies(a) && lies(b)) out.laid[l] += g.length;
    if (lies(a) == lies(b)) continue;
    out.laid[l] += lies(a) ? zero_of_line(a, b, g.length) : zero_of_line(b, a, g.length);
    out.element[2 * l] = std::min(out.element[2 * l], e.global);
    out.element[2 * l + 1] = std::min(out.element[2 * l + 1], -e.global);
  }
  join(MPI_MIN, out.element, 2);
  join(MPI_SUM, out.laid, 1);
  return out;
}

std::vector<Touchdowns::Surrounding> Touchdowns::surroundings(const Changes& changes,
                                                              const std::vector<double>& gap,
                                                              const Kinematics& state) const {
  struct Sent {
    size_t change;
    int node;  // of its surrounding
    Gap gap;
  };
  std::vector<Sent> of_cut_lines;
  std::vector<Surrounding> out(changes.element.size());
  for (size_t k = 0; k < out.size(); ++k) {
    if (changes.element[k] == Changes::kNone) continue;
    const Element& e = local_.mesh->element(std::abs(changes.element[k]));
    const LineSpan& span = local_.mesh->lines[e.line];
    for (int i = 0; i < Surrounding::kNodes; ++i) {
      const int global = e.first + Surrounding::kFirst + i;
      if (global < span.first_node || global >= span.first_node + span.nodes) continue;
      const int n = local_.find(global);
      if (!local_.owns(n)) continue;
      const size_t node = n;
      const double slope =
          local_.rotates(n) ? above(node, state).normal.dot(state.q[node] * Vec3::UnitX()) : 0;
      out[k].gap[i] = {gap[node], slope, state.x[node]};
      if (k < 2 * cut_) of_cut_lines.push_back({k, i, out[k].gap[i]});
    }
  }
  if (cut_ == 0) return out;
  for (const Sent& s : gather_all(comm_, of_cut_lines)) out[s.change].gap[s.node] = s.gap;
  return out;
}

// Touchdown point, and the length on the bed [m] that linear interpolation of the gaps misses.
std::pair<TouchdownPoint, double> Touchdowns::point(int element, const Surrounding& around) const {
  const Mesh& mesh = *local_.mesh;
  const Element& e = mesh.element(element);
  const LineSpan& span = mesh.lines[e.line];
  const bool to_b = lies(around.gap[-Surrounding::kFirst].value);  // the node towards A lies
  const int last_lying = to_b ? e.first : e.second;
  const int sign = to_b ? 1 : -1;
  NodesAtChange n{};
  for (int i = 0; i < NodesAtChange::kNodes; ++i) {
    const int global = last_lying + sign * (i - 1);
    n.exists[i] = global >= span.first_node && global < span.first_node + span.nodes;
    if (!n.exists[i]) continue;
    n.inner[i] = global != span.first_node && global != span.first_node + span.nodes - 1;
    n.gap[i] = around.gap[global - e.first - Surrounding::kFirst];
    n.gap[i].slope *= sign;
    n.arc[i] = sign * mesh.node(global).arc;
    n.two_sided[i] = mesh.node(global).two_sided;
  }
  const double s = distance_to_touchdown(n, e.beam);
  const double arc = std::clamp(mesh.node(last_lying).arc + sign * s, 0.0, span.length);
  return {{arc, position_at(n, s)}, s - zero_of_line(n.gap[1].value, n.gap[2].value, n.arc[2] - n.arc[1])};
}

std::vector<Touchdown> Touchdowns::find(const Kinematics& state) const {
  std::vector<Touchdown> out;
  if (!bed_.present) return out;
  std::vector<double> gap(heights_.size());
  for (size_t n = 0; n < gap.size(); ++n)
    if (local_.node(n).body < 0) gap[n] = above(n, state).gap;
  const Changes changes = this->changes(gap);
  const std::vector<Surrounding> around = surroundings(changes, gap, state);
  for (const int line : lines_) {
    const size_t k = slot_[line];
    Touchdown& t = out.emplace_back();
    t.line = line;
    t.laid = changes.laid[k];
    const auto point_of = [&](size_t change) -> std::optional<TouchdownPoint> {
      if (changes.element[change] == Changes::kNone) return {};
      const auto [point, more] = this->point(std::abs(changes.element[change]), around[change]);
      t.laid += more;
      return point;
    };
    t.from_a = point_of(2 * k);
    const bool same = changes.element[2 * k + 1] == -changes.element[2 * k];
    t.from_b = same ? t.from_a : point_of(2 * k + 1);
    t.laid = std::clamp(t.laid, 0.0, local_.mesh->lines[line].length);
  }
  return out;
}

std::vector<Touchdown> Touchdowns::of_all_lines(const Kinematics& state) const {
  std::vector<Touchdown> local = find(state);
  std::erase_if(local, [this](const Touchdown& t) { return !owns_line(local_, t.line); });
  std::vector<Touchdown> out(local_.mesh->lines.size());
  for (size_t l = 0; l < out.size(); ++l) out[l].line = static_cast<int>(l);  // also without a seabed
  for (const Touchdown& t : gather_all(comm_, local)) out[t.line] = t;
  return out;
}

}  // namespace hawser::record
