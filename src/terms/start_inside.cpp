// Searches the start shape for intervals of lines inside volumes, and for nodes that a volume separates from
// the straight path between the ends of their line.
#include "hawser/terms/start_inside.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "hawser/terms/axis_distance.hpp"
#include "hawser/terms/element_axis.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser {

void join(std::vector<Inside>& intervals, const Mesh& mesh) {
  std::sort(intervals.begin(), intervals.end(), [](const Inside& a, const Inside& b) {
    return std::tie(a.line, a.volume, a.from, a.to) < std::tie(b.line, b.volume, b.from, b.to);
  });
  std::vector<Inside> out;
  for (const Inside& s : intervals) {
    const double rounding = 1e-9 * mesh.lines[s.line].length;
    if (out.empty() || out.back().line != s.line || out.back().volume != s.volume ||
        s.from > out.back().to + rounding) {
      out.push_back(s);
      continue;
    }
    Inside& o = out.back();
    if (s.to > o.to) {
      o.to = s.to;
      o.rise_to = s.rise_to;
    }
    if (s.depth > o.depth) {
      o.depth = s.depth;
      o.at = s.at;
      o.place = s.place;
    }
  }
  intervals = std::move(out);
}

namespace {

// An element of a line beside a volume.
struct ElementBeside {
  const Mesh& mesh;
  const Element& element;
  const FedLine* fed;  // null: its line is not fed
  const AxisShape& shape;
  const Surface& surface;
  const RigidPose& pose;
  double radius = 0;  // m

  std::optional<SurfacePoint> query(double xi, double within) const {
    return surface.query(pose.to_body(shape.point(xi)), within);
  }
  // End (0 or 1) of the element at the feed point; -1: none.
  int feed_point() const { return fed ? static_cast<int>(fed->line_end) : -1; }
  bool is_line_end(int end) const {
    const LineSpan& span = mesh.lines[element.line];
    return feed_point() == end ||
           (end ? element.second == span.first_node + span.nodes - 1 : element.first == span.first_node);
  }
  // Arc length, m.
  double arc(double xi) const {
    if (xi == feed_point()) return feed_point() ? mesh.lines[element.line].length : 0;
    return arc_at(mesh, element, xi);
  }
  // Slope of the axis relative to the surface, m/m.
  double rise(double xi) const {
    const auto p = query(xi, radius);
    const Vec3 slope = shape.slope(xi);
    return p && slope.norm() > 0 ? std::abs((pose.rotation * p->normal).dot(slope)) / slope.norm() : 1;
  }
};

Inside inside_of(const ElementBeside& e, int volume, double from, double to) {
  constexpr int kSamples = 32;  // to find the deepest point
  Inside s;
  s.rise_from = e.rise(from);
  s.rise_to = e.rise(to);
  s.line = e.element.line;
  s.volume = volume;
  s.from = e.arc(from);
  s.to = e.arc(to);
  s.at = s.from;
  s.place = e.shape.point(from);
  for (int k = 0; k <= kSamples; ++k) {
    const double xi = from + (to - from) * k / kSamples;
    const auto p = e.query(xi, 0);
    if (p && -p->distance > s.depth) {
      s.depth = -p->distance;
      s.at = e.arc(xi);
      s.place = e.shape.point(xi);
    }
  }
  return s;
}

void add_intervals(const ElementBeside& e, double length, int volume, std::vector<Inside>& out) {
  // Twice the resolution of contact, because an interval inside a thin plate is short.
  const auto intervals = contact_intervals(axis_distance(e.surface, e.pose, e.shape),
                                           {e.shape.slope_bound(), 0, e.shape.bend_bound()},
                                           contact_levels(length, e.radius) + 1);
  for (const ContactInterval& s : intervals) out.push_back(inside_of(e, volume, s.from, s.to));
  // Ends of the line at the surface.
  for (const int end : {0, 1}) {
    if (!e.is_line_end(end)) continue;
    const auto p = e.query(end, 0.5 * e.radius);
    if (p && p->distance >= 0) out.push_back(inside_of(e, volume, end, end));
  }
}

}  // namespace

std::vector<Inside> inside_volumes(const LocalMesh& mesh, const Kinematics& state, const Bodies& bodies,
                                   const std::vector<ContactVolume>& volumes,
                                   const std::vector<double>& radius, const Feeders* feeders) {
  std::vector<Inside> out;
  for (size_t v = 0; v < volumes.size(); ++v) {
    if (volumes[v].off) continue;
    const Surface& surface = *volumes[v].surface;
    const Box box = surface.bounds();
    const RigidPose pose = bodies.pose(volumes[v].body, state);
    for (size_t i = 0; i < mesh.elements.size(); ++i) {
      const LocalElement& e = mesh.elements[i];
      if (!e.counted || !(radius[i] > 0)) continue;
      const Element& g = mesh.element(e);
      AxisEnds ends = element_axis(state, g, e.first, e.second);
      const FedLine* fed = feeders ? feeders->find(e.global) : nullptr;
      if (feeders && feeders->idle(e.global)) continue;
      if (fed) ends.length = fed->predicted;
      const AxisShape shape(ends);
      if (distance(box, pose.to_body(shape.point(0.5))) > 0.5 * shape.slope_bound() + radius[i]) continue;
      add_intervals({*mesh.mesh, g, fed, shape, surface, pose, radius[i]}, ends.length, static_cast<int>(v),
                    out);
    }
  }
  join(out, *mesh.mesh);
  return out;
}

std::vector<OnWrongSide> nodes_on_wrong_side(const LocalMesh& mesh, const Kinematics& state,
                                             const Bodies& bodies, const std::vector<ContactVolume>& volumes,
                                             const ExpectedPlace& expected_place) {
  std::vector<OnWrongSide> out;
  for (size_t v = 0; v < volumes.size(); ++v) {
    if (volumes[v].off) continue;
    const Surface& surface = *volumes[v].surface;
    const Box box = surface.bounds();
    const RigidPose pose = bodies.pose(volumes[v].body, state);
    for (int n = 0; n < mesh.owned; ++n) {
      const Node& node = mesh.node(n);
      if (node.body >= 0) continue;
      const Vec3 x = state.x[n];
      const std::optional<Vec3> expected = expected_place(node, v, x);
      if (!expected) continue;
      const Vec3 from = pose.to_body(x);
      const Vec3 to = pose.to_body(*expected);
      Box path;
      path.add(from);
      path.add(to);
      const double length = (to - from).norm();
      if (!path.overlaps(box) || !(length > 0)) continue;
      const auto away = [&](const Vec3& y) {
        const auto p = surface.query(y, length);
        return p ? p->distance : length;
      };
      const double first = away(from);
      const double min_step = 1e-3 * length;
      if (!(first > 0) || !(away(to) > 0)) continue;
      for (double s = first; s < length;) {
        const double d = away(from + s / length * (to - from));
        if (d < 0) {
          out.push_back({node.line, static_cast<int>(v), node.arc, s, x});
          break;
        }
        s += std::max(d, min_step);
      }
    }
  }
  return out;
}

}  // namespace hawser
