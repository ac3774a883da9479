// The class Clearances: smallest distance of two lines by bounding-box trees, and of a line from a surface
// with nearest elements first; then the minimum over all ranks.
#include "hawser/record/clearances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "hawser/base/mpi.hpp"
#include "hawser/kernels/contact_intervals.hpp"

namespace hawser::record {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kResolution = 1e-3;  // of the radii: places on bent lines nearer in distance are one

}  // namespace

Clearances::Clearances(const Subject& subject)
    : comm_(subject.comm()),
      case_(subject.model),
      mesh_(subject.local()),
      surfaces_(subject.surfaces),
      cache_(case_.output.clearances.size()) {}

void Clearances::declare(Declarations& to) {
  for (const model::Clearance& k : case_.output.clearances) {
    io::ResultSeries s{k.name, {{"clearance", "m", 1}, {"arc_length", "m", 1}}};
    if (k.volume.empty())
      s.columns.push_back({"other_arc_length", "m", 1});
    else
      s.columns.push_back({"point", "m", 3});
    to.contents.series.push_back(std::move(s));
  }
}

double Clearances::arc(int element, double xi) const {
  return arc_at(*mesh_.mesh, mesh_.mesh->element(element), xi);
}

// Elements of a line counted by this rank.
std::vector<Clearances::Shaped> Clearances::local_shapes(int line, const Kinematics& state) const {
  std::vector<Shaped> out;
  for (const LocalElement& local : mesh_.elements) {
    const Element& e = mesh_.element(local);
    if (e.line != line || !local.counted) continue;
    const size_t i = local.first;
    const size_t j = local.second;
    const double radius = 0.5 * case_.line_types[e.type].contact_diameter;
    out.push_back({local.global, radius,
                   e.beam ? BezierAxis::beam(state.x[i], state.q[i] * Vec3::UnitX(), state.x[j],
                                             state.q[j] * Vec3::UnitX(), e.length)
                          : BezierAxis::straight(state.x[i], state.x[j])});
  }
  std::sort(out.begin(), out.end(), [](const Shaped& a, const Shaped& b) { return a.element < b.element; });
  return out;
}

Clearances::Tree::Tree(std::vector<Shaped> shapes) : elements(std::move(shapes)) {
  std::vector<Box> each;
  for (const Shaped& e : elements) {
    each.push_back(e.axis.box());
    radius = std::max(radius, e.radius);
  }
  boxes = BoxTree(each, {}, 1);
}

// Gathers a line on all ranks: a step of a line costs far more than sending its position.
Clearances::Tree Clearances::of_all_ranks(const Tree& local) const {
  if (ranks_of(comm_) == 1) return local;
  std::vector<Shaped> elements = gather_all(comm_, local.elements);
  std::sort(elements.begin(), elements.end(),
            [](const Shaped& a, const Shaped& b) { return a.element < b.element; });
  return Tree(std::move(elements));
}

Clearances::Best Clearances::to_line(const Tree& a, const Tree& b) const {
  Best best;
  best.clearance = kFar;
  if (a.boxes.empty() || b.boxes.empty()) return best;
  const auto p = a.boxes.nodes();
  const auto q = b.boxes.nodes();
  struct Pair {
    size_t a, b;
    double lower_bound;
  };
  const auto make = [&](size_t i, size_t j) {
    return Pair{i, j, distance(p[i].box, q[j].box) - a.radius - b.radius};
  };
  const auto second = [](std::span<const BoxTree::Node> nodes, size_t parent) {
    return static_cast<size_t>(nodes[parent + 1].next);
  };
  std::vector<Pair> stack{make(0, 0)};
  while (!stack.empty()) {
    const auto [i, j, lower_bound] = stack.back();
    stack.pop_back();
    if (!(lower_bound < best.clearance)) continue;
    if (p[i].count == 1 && q[j].count == 1) {
      const Shaped& x = a.elements[a.boxes.below(p[i]).front()];
      const Shaped& y = b.elements[b.boxes.below(q[j]).front()];
      const double radii = x.radius + y.radius;
      const auto near = nearest_of(x.axis, y.axis, best.clearance + radii, kResolution * radii);
      if (!near) continue;
      best.clearance = near->distance - radii;
      best.arc = arc(x.element, near->xi);
      best.other_place = Vec3(arc(y.element, near->eta), 0, 0);
      continue;
    }
    std::array<Pair, 2> next = p[i].count >= q[j].count
                                   ? std::array<Pair, 2>{make(i + 1, j), make(second(p, i), j)}
                                   : std::array<Pair, 2>{make(i, j + 1), make(i, second(q, j))};
    if (next[0].lower_bound < next[1].lower_bound)
      std::swap(next[0], next[1]);  // the nearer pair is processed first
    for (const Pair& n : next)
      if (n.lower_bound < best.clearance) stack.push_back(n);
  }
  return best;
}

Clearances::Best Clearances::to_volume(const std::vector<Shaped>& elements, const Surface& surface,
                                       const io::BodyPose& pose, std::vector<Cache>& cache) const {
  Best best;
  best.clearance = kFar;
  cache.resize(elements.size());
  const Box box = surface.bounds();
  const Quat back = pose.rotation.conjugate();
  std::vector<BezierAxis> axes;
  std::vector<std::pair<double, size_t>> order;  // lower bound of the clearance, element
  for (size_t i = 0; i < elements.size(); ++i) {
    BezierAxis& axis = axes.emplace_back(elements[i].axis);
    double moved = 0;
    for (size_t k = 0; k < 4; ++k) {
      axis.b[k] = back * (axis.b[k] - pose.position);
      if (cache[i].known) moved = std::max(moved, (axis.b[k] - cache[i].axis.b[k]).norm());
    }
    double lower_bound = cache[i].known ? cache[i].lower_bound - moved : -kFar;
    if (const double outside = distance(box, axis.box()); outside > 0)
      lower_bound = std::max(lower_bound, outside);
    order.emplace_back(lower_bound - elements[i].radius, i);
  }
  std::sort(order.begin(), order.end());
  int hint = -1;
  for (const auto& [lower_bound, i] : order) {
    if (!(lower_bound < best.clearance)) break;
    const Shaped& e = elements[i];
    const auto field = [&](const Vec3& y, double within, Vec3& normal) -> std::optional<double> {
      const auto p = surface.query(y, within, hint);
      if (!p) return std::nullopt;
      hint = p->triangle;
      normal = p->normal;
      return p->distance;
    };
    const double length = mesh_.mesh->element(e.element).length;
    const double within = best.clearance + e.radius;
    const auto near = nearest_to(field, axes[i], within, contact_levels(length, e.radius));
    // The search excludes everything up to one piece less.
    const double piece = axes[i].slope_bound() / (1 << contact_levels(length, e.radius));
    const double nothing_below = near ? near->distance : within;
    cache[i] = {axes[i], nothing_below - piece, std::isfinite(nothing_below)};
    if (!near) continue;
    best.clearance = near->distance - e.radius;
    best.arc = arc(e.element, near->xi);
    const auto p = surface.query(axes[i].point(near->xi), near->distance + e.radius, hint);
    if (p) best.other_place = pose.position + pose.rotation * p->point;
  }
  return best;
}

void Clearances::rows(const Snapshot& s, Rows& to) {
  const auto& requested = case_.output.clearances;
  if (requested.empty()) return;
  std::vector<Best> nearest;
  std::map<int, Tree> local, global;  // of lines, of this rank and of all; each is made once
  const auto tree_of = [&](int line) -> const Tree& {
    const auto [t, fresh] = local.try_emplace(line);
    if (fresh) t->second = Tree(local_shapes(line, s.at));
    return t->second;
  };
  for (size_t k = 0; k < requested.size(); ++k) {
    const model::Clearance& w = requested[k];
    const int line = case_.line_index(w.line);
    if (w.volume.empty()) {
      const int other = case_.line_index(w.other_line);
      if (!global.count(other)) global[other] = of_all_ranks(tree_of(other));
      nearest.push_back(to_line(tree_of(line), global[other]));
      continue;
    }
    size_t v = 0;
    while (case_.volumes[v].name != w.volume) ++v;
    const int body = case_.body_index(case_.volumes[v].body);
    const io::BodyPose pose = body < 0 ? io::BodyPose{} : s.poses()[body];
    nearest.push_back(to_volume(tree_of(line).elements, *surfaces_[v], pose, cache_[k]));
  }
  largest_of_ranks(comm_, nearest, [](const Best& b) { return -b.clearance; });
  const int rank = rank_of(comm_);
  for (size_t k = 0; k < nearest.size(); ++k) {
    if (rank != 0) {
      to.add({});
      continue;
    }
    const Best& n = nearest[k];
    std::vector<double> row{n.clearance, n.arc, n.other_place.x()};
    if (!requested[k].volume.empty()) row.insert(row.end(), {n.other_place.y(), n.other_place.z()});
    // No facet of the volume faces this direction.
    if (!std::isfinite(n.clearance)) std::fill(row.begin(), row.end(), std::nan(""));
    to.add(std::move(row));
  }
}

}  // namespace hawser::record
