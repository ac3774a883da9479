// The class SharedPlaces: length without contact along two branches from a shared place.
#include "hawser/terms/shared_places.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/base/mpi.hpp"
#include "hawser/math/ordered.hpp"
#include "hawser/math/segment.hpp"

namespace hawser {
namespace {

// Contact is excluded up to kFree times the length at which the branches are first apart. There, straight
// lines have a distance of kFree times the sum of their radii.
constexpr int kFree = 2;
// Steps per sum of the radii.
constexpr int kSteps = 4;
// In sums of the radii. Lines that overlap from one shared place to the next, but nowhere by more than
// kPressed, lie side by side and are pressed together by contact. Lines with a gap of more than kClear are
// clearly apart.
constexpr double kPressed = 0.1, kClear = 0.5;

}  // namespace

// The gap between two branches at equal lengths along them, m; negative: overlap.
struct SharedPlaces::Gaps {
  const BranchPath &one, &other;
  double step = 0;

  double at(int k) const {
    return std::min(distance_from(one, other, k * step), distance_from(other, one, k * step));
  }

  static size_t segment(const BranchPath& path, double s) {
    const auto after = std::upper_bound(path.s.begin(), path.s.end(), s) - path.s.begin();
    return static_cast<size_t>(std::clamp<std::ptrdiff_t>(after - 1, 0, std::ssize(path.s) - 2));
  }

  static double distance(const BranchPath& path, size_t i, const Vec3& p) {
    return std::sqrt(squared_distance_to_segment(p, path.x[i], path.x[i + 1])) - path.radius[i];
  }

  // Smallest gap between the place s of a path and the other path. The search starts at equal length and
  // stops at a local minimum.
  static double distance_from(const BranchPath& path, const BranchPath& other, double s) {
    const size_t i = segment(path, s);
    const double span = path.s[i + 1] - path.s[i];
    const double t = span > 0 ? (s - path.s[i]) / span : 0;
    const Vec3 p = path.x[i] + std::min(t, 1.0) * (path.x[i + 1] - path.x[i]);
    const size_t last = other.s.size() - 2;
    size_t j = segment(other, s);
    double smallest = distance(other, j, p);
    for (const bool forward : {false, true})
      while (forward ? j < last : j > 0) {
        const size_t next = forward ? j + 1 : j - 1;
        const double d = distance(other, next, p);
        if (d > smallest) break;
        smallest = d;
        j = next;
      }
    return smallest - path.radius[i];
  }
};

SharedPlaces::SharedPlaces(MPI_Comm comm, const LocalMesh& mesh, ContactRadii radii,
                           std::vector<SharedPlace> places, std::vector<int> first_part)
    : comm_(comm), mesh_(mesh), radii_(std::move(radii)), first_part_(std::move(first_part)) {
  const std::vector<LineSpan>& lines = mesh.mesh->lines;
  offset_.assign(first_part_.size(), 0);
  for (size_t l = 1; l < first_part_.size(); ++l)
    if (first_part_[l] == first_part_[l - 1]) offset_[l] = offset_[l - 1] + lines[l - 1].length;
  const auto first_radius = [&](const Branch& s) {
    const Node& n = mesh.mesh->node(s.node);
    const LineSpan& line = lines[n.line];
    return radii_.of(mesh.mesh->element(
        std::min(line.first_element + s.node - line.first_node, line.first_element + line.elements - 1)));
  };
  const auto length = [&](const Branch& s) {
    const std::vector<int> all = nodes_to(s, HUGE_VAL);
    return std::abs(arc(all.back()) - arc(all.front()));
  };
  for (const SharedPlace& p : places) {
    PlaceState& place = places_.emplace_back();
    place.branches = p;
    place.step = (first_radius(p.one) + first_radius(p.other)) / kSteps;
    place.limit = std::min(length(p.one), length(p.other));
    const int a = mesh.mesh->node(p.one.node).line;
    const int b = mesh.mesh->node(p.other.node).line;
    if (first_part_of(a) == first_part_of(b)) {
      const double distance = arc(p.other.node) - arc(p.one.node);
      const bool facing = distance * p.one.direction > 0 && distance * p.other.direction < 0;
      place.limit = std::min(place.limit, (facing ? 0.5 : 1) * std::abs(distance));
    }
    between_[ordered(first_part_of(a), first_part_of(b))].push_back(static_cast<int>(places_.size()) - 1);
  }
}

double SharedPlaces::diameter(int k) const { return kSteps * places_[k].step; }

const std::vector<int>& SharedPlaces::between(int line, int other) const {
  static const std::vector<int> none;
  if (between_.empty()) return none;
  const auto at = between_.find(ordered(first_part_of(line), first_part_of(other)));
  return at == between_.end() ? none : at->second;
}

// Arc length of a node along the given line, m.
double SharedPlaces::arc(int node) const {
  const Node& n = mesh_.mesh->node(node);
  return (offset_.empty() ? 0 : offset_[n.line]) + n.arc;
}

// First and last node of a line outside feeders.
std::array<int, 2> SharedPlaces::nodes_outside_feeders(int line) const {
  const LineSpan& l = mesh_.mesh->lines[line];
  const std::array<int, 2> inside = inside_.empty() ? std::array{0, 0} : inside_[line];
  return {l.first_node + inside[0], l.first_node + l.nodes - 1 - inside[1]};
}

// Start of a branch, m along the given line.
double SharedPlaces::start_arc(const Branch& branch) const {
  const auto [first, last] = nodes_outside_feeders(mesh_.mesh->node(branch.node).line);
  return arc(std::clamp(branch.node, first, last));
}

std::optional<std::array<double, 2>> SharedPlaces::along(const Branch& branch, int element) const {
  const Element& e = mesh_.mesh->element(element);
  if (first_part_of(e.line) != first_part_of(mesh_.mesh->node(branch.node).line)) return std::nullopt;
  const double from = start_arc(branch);
  const double a = branch.direction * (arc(e.first) - from);
  const double b = branch.direction * (arc(e.second) - from);
  if (std::min(a, b) < -1e-6 * e.length) return std::nullopt;
  return std::array{a, b};
}

void SharedPlaces::clip(int element, int second, std::array<double, 2>& range,
                        std::array<double, 2>& second_range) const {
  if (places_.empty()) return;
  const Mesh& mesh = *mesh_.mesh;
  for (const int k : between(mesh.element(element).line, mesh.element(second).line))
    for (const bool swapped : {false, true}) {
      const auto one = along(place(k).one, swapped ? second : element);
      const auto other = along(place(k).other, swapped ? element : second);
      if (!one || !other) continue;
      const double length = free_length(k);
      if (std::min((*one)[0], (*one)[1]) >= length || std::min((*other)[0], (*other)[1]) >= length) continue;
      const auto clip_range = [length](const std::array<double, 2>& d, std::array<double, 2>& clipped) {
        const double xi = std::clamp((length - d[0]) / (d[1] - d[0]), 0.0, 1.0);
        if (d[1] > d[0])
          clipped[0] = std::max(clipped[0], xi);
        else
          clipped[1] = std::min(clipped[1], xi);
      };
      clip_range(*one, swapped ? second_range : range);
      clip_range(*other, swapped ? range : second_range);
    }
}

// Nodes of a branch, outwards, up to and including the first one at `reach` [m] or beyond.
std::vector<int> SharedPlaces::nodes_to(const Branch& branch, double reach) const {
  const int given = first_part_of(mesh_.mesh->node(branch.node).line);
  const auto [first, last] = nodes_outside_feeders(mesh_.mesh->node(branch.node).line);
  const double from = start_arc(branch);
  std::vector<int> out;
  for (int n = std::clamp(branch.node, first, last); n >= 0 && n < mesh_.mesh->line_nodes();
       n += branch.direction) {
    const int line = mesh_.mesh->node(n).line;
    if (first_part_of(line) != given) break;
    const auto [a, b] = nodes_outside_feeders(line);
    if (n < a || n > b) break;
    out.push_back(n);
    if (out.size() > 1 && std::abs(arc(n) - from) >= reach) break;
  }
  return out;
}

// Positions of mesh nodes, from the ranks that own them.
std::vector<Vec3> SharedPlaces::gather(const std::vector<int>& nodes, const Kinematics& state) const {
  std::vector<Vec3> out(nodes.size(), Vec3::Zero());
  std::vector<double> local;
  const bool alone = ranks_of(comm_) == 1;
  for (size_t i = 0; i < nodes.size(); ++i) {
    const int n = mesh_.find(nodes[i]);
    if (!mesh_.owns(n)) continue;
    out[i] = state.x[n];
    if (!alone) local.insert(local.end(), {static_cast<double>(i), out[i].x(), out[i].y(), out[i].z()});
  }
  if (alone) return out;
  const std::vector<double> all = gather_all(comm_, local);
  for (size_t i = 0; i < all.size(); i += 4)
    out[static_cast<size_t>(all[i])] = Vec3(all[i + 1], all[i + 2], all[i + 3]);
  return out;
}

SharedPlaces::BranchPath SharedPlaces::branch_path(const Branch& branch, const std::vector<int>& nodes,
                                                   const std::vector<Vec3>& x) const {
  BranchPath out;
  out.x = x;
  const double from = start_arc(branch);
  for (size_t i = 0; i < nodes.size(); ++i) {
    out.s.push_back(std::abs(arc(nodes[i]) - from));
    const Node& n = mesh_.mesh->node(nodes[i]);
    const LineSpan& line = mesh_.mesh->lines[n.line];
    const int element = line.first_element + nodes[i] - line.first_node - (branch.direction < 0 ? 1 : 0);
    const int nearest = std::clamp(element, line.first_element, line.first_element + line.elements - 1);
    out.radius.push_back(radii_.of(mesh_.mesh->element(nearest)));
  }
  return out;
}

void SharedPlaces::forget() {
  for (PlaceState& p : places_) p.free_steps = kUnknown;
  agreed_ = false;
}

void SharedPlaces::restore(const Kept& kept) {
  if (kept.place < 0 || kept.place >= size() || kept.steps < kUnknown)
    throw std::invalid_argument("a record of places that lines share does not fit");
  places_[kept.place].free_steps = kept.steps;
}

void SharedPlaces::update(const Kinematics& state, bool in_statics) {
  if (!std::exchange(agreed_, true) && !places_.empty()) {
    std::vector<int> steps;
    for (const PlaceState& p : places_) steps.push_back(p.free_steps);
    all_reduce(comm_, MPI_MAX, steps);
    for (size_t k = 0; k < places_.size(); ++k) places_[k].free_steps = steps[k];
  }
  std::vector<std::array<std::vector<int>, 2>> nodes(places_.size());
  std::vector<int> all;
  for (size_t k = 0; k < places_.size(); ++k) {
    const PlaceState& p = places_[k];
    if (!in_statics && p.free_steps == 0) continue;  // permanently apart: in motion the length only shrinks
    const double reach =
        p.free_steps == kUnknown ? p.limit : std::min(p.limit, (kFree * (p.free_steps + 1) + 1) * p.step);
    nodes[k] = {nodes_to(p.branches.one, reach), nodes_to(p.branches.other, reach)};
    for (const std::vector<int>& ends_nodes : nodes[k])
      all.insert(all.end(), ends_nodes.begin(), ends_nodes.end());
  }
  if (all.empty()) return;  // the same on every rank
  const std::vector<Vec3> x = gather(all, state);
  auto next = x.begin();
  for (size_t k = 0; k < places_.size(); ++k) {
    std::array<BranchPath, 2> paths;
    for (const size_t side : {0, 1}) {
      const std::vector<int>& branch_nodes = nodes[k][side];
      const SharedPlace& place = places_[k].branches;
      paths[side] = branch_path(side == 0 ? place.one : place.other, branch_nodes,
                                {next, next + std::ssize(branch_nodes)});
      next += std::ssize(branch_nodes);
    }
    if (nodes[k][0].size() > 1 && nodes[k][1].size() > 1) update(places_[k], paths[0], paths[1], in_statics);
  }
}

// All lengths are numbers of steps along the branches. If the branches overlap from the place up to
// `first`, the length without contact is at most kFree * first.
void SharedPlaces::update(PlaceState& p, const BranchPath& one, const BranchPath& other,
                          bool in_statics) const {
  const Gaps gaps{one, other, p.step};
  const int reach = static_cast<int>(std::min({p.limit, one.s.back(), other.s.back(),
                                               (kFree * (std::max(p.free_steps, 0) + 1) + 1) * p.step}) /
                                     p.step);
  const int limit_steps = static_cast<int>(p.limit / p.step);
  const bool unknown = p.free_steps == kUnknown;
  const int known_to = unknown ? limit_steps : std::min(limit_steps, reach);
  const auto overlaps = [&](int k) { return gaps.at(k) < 0; };
  // Length up to which the branches, first apart at `first`, stay apart, at most kFree * first.
  const auto free_to = [&](int first) {
    const int end = std::min(kFree * first, known_to);
    int k = first;
    while (k < end && !overlaps(k)) ++k;
    return k;
  };
  if (unknown) {
    double nearest = 0;
    int first = 0;
    for (; first < limit_steps; ++first) {
      const double gap = gaps.at(first);
      if (gap >= 0) break;
      nearest = std::min(nearest, gap);
    }
    const int a = mesh_.mesh->node(p.branches.one.node).line;
    const int b = mesh_.mesh->node(p.branches.other.node).line;
    const bool side_by_side =
        first == limit_steps && first_part_of(a) != first_part_of(b) && nearest > -kPressed * kSteps * p.step;
    p.free_steps = side_by_side ? 0 : first == limit_steps ? limit_steps : free_to(first);
  } else if (!overlaps(p.free_steps)) {
    int first = p.free_steps;
    while (first > 0 && !overlaps(first - 1)) --first;
    const int proposed = free_to(first);
    if (proposed < p.free_steps || in_statics) p.free_steps = proposed;
  } else if (in_statics) {
    // The branches overlap where they were clearly apart. Contact cannot have pressed them together there,
    // so the length without contact grows.
    int first = p.free_steps;
    while (first < known_to && overlaps(first)) ++first;
    if (first <= p.clear_steps) p.free_steps = first == limit_steps ? limit_steps : free_to(first);
  }
  if (!in_statics) return;
  const int end = std::min(limit_steps, kFree * (p.free_steps + 1) + 1);
  p.clear_steps = p.free_steps;
  while (p.clear_steps < std::min(end, known_to) && gaps.at(p.clear_steps) > kClear * kSteps * p.step)
    ++p.clear_steps;
  if (p.clear_steps >= known_to) p.clear_steps = limit_steps;
}

}  // namespace hawser
