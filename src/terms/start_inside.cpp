// Searches the start shape for intervals of lines inside volumes, and for nodes that a volume separates from
// the straight path between the ends of their line.
#include "hawser/terms/start_inside.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "hawser/mesh/arc.hpp"
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

std::vector<Inside> inside_volumes(const LocalMesh& mesh, const Kinematics& state, const Bodies& bodies,
                                   const std::vector<ContactVolume>& volumes,
                                   const std::vector<double>& radius, const Feeders* feeders) {
  constexpr int kSamples = 32;  // per interval, to find the deepest point
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
      const auto point = [&](double xi) { return pose.to_body(shape.point(xi)); };
      // Twice the resolution of contact, because an interval inside a thin plate is short.
      const auto intervals =
          contact_intervals(axis_distance(surface, pose, shape), {shape.slope_bound(), 0, shape.bend_bound()},
                            contact_levels(ends.length, radius[i]) + 1);
      const auto rise = [&](double xi) {
        const auto p = surface.query(point(xi), radius[i]);
        const Vec3 slope = shape.slope(xi);
        return p && slope.norm() > 0 ? std::abs((pose.rotation * p->normal).dot(slope)) / slope.norm() : 1;
      };
      const LineSpan& span = mesh.mesh->lines[g.line];
      const int feed_point = fed ? static_cast<int>(fed->line_end) : -1;
      const auto is_end = [&](int end) {
        return feed_point == end ||
               (end ? g.second == span.first_node + span.nodes - 1 : g.first == span.first_node);
      };
      const auto arc = [&](double xi) {
        if (xi == feed_point) return feed_point ? span.length : 0;
        return arc_at(*mesh.mesh, g, xi);
      };
      const auto add = [&](double from, double to) {
        Inside s;
        s.rise_from = rise(from);
        s.rise_to = rise(to);
        s.line = g.line;
        s.volume = static_cast<int>(v);
        s.from = arc(from);
        s.to = arc(to);
        s.at = s.from;
        s.place = shape.point(from);
        for (int k = 0; k <= kSamples; ++k) {
          const double xi = from + (to - from) * k / kSamples;
          const auto p = surface.query(point(xi), 0);
          if (p && -p->distance > s.depth) {
            s.depth = -p->distance;
            s.at = arc(xi);
            s.place = shape.point(xi);
          }
        }
        out.push_back(s);
      };
      for (const ContactInterval& s : intervals) add(s.from, s.to);
      // Ends of the line at the surface.
      for (const int end : {0, 1}) {
        if (!is_end(end)) continue;
        const auto p = surface.query(point(end), 0.5 * radius[i]);
        if (p && p->distance >= 0) add(end, end);
      }
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
