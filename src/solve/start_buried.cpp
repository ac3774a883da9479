// Start shapes of lines that begin or end in the soil or in a feeder, and lifting onto a measured bed.
#include <algorithm>
#include <cmath>

#include "hawser/geometry/surface.hpp"
#include "hawser/mesh/fed_start.hpp"
#include "hawser/model/bed.hpp"
#include "start_line.hpp"

namespace hawser {
namespace {

// The point where a line leaves the soil if `length` [m] of it is straight from `from`, in the soil, in the
// direction of `to`.
Vec3 exit_of_soil(const model::Seabed& bed, const Vec3& from, const Vec3& to, double length) {
  Vec3 direction(to.x() - from.x(), to.y() - from.y(), 0);
  direction = direction.norm() > 0 ? Vec3(direction.normalized()) : Vec3::UnitX();
  Vec3 x = from;
  double low = 0;
  double high = length;
  for (int i = 0; i < 60; ++i) {
    const double off = 0.5 * (low + high);
    x = Vec3(from.x() + off * direction.x(), from.y() + off * direction.y(), x.z());
    for (int k = 0; k < 20; ++k) {  // straight up or down to the bed
      const double height = model::height_above_bed(bed, x);
      if (!std::isfinite(height)) break;
      x.z() -= height;
      if (std::abs(height) < 1e-12 * length) break;
    }
    ((x - from).norm() < length ? low : high) = off;
  }
  return x;
}

// A line with separate numbers of its nodes and elements, from 0.
struct LineAlone {
  std::vector<Node> nodes;
  std::vector<Element> elements;
};

LineAlone alone(const Mesh& mesh, const LineSpan& span) {
  LineAlone out;
  for (int n = 0; n < span.nodes; ++n) out.nodes.push_back(mesh.node(span.first_node + n));
  for (int e = 0; e < span.elements; ++e) out.elements.push_back(mesh.element(span.first_element + e));
  return out;
}

// Moves the held node to the arc length at which the element between it and the free node has this length.
void at_feed_point(LineAlone& line, int held, int free, double length) {
  line.elements[std::min(held, free)].length = length;
  line.nodes[held].arc = line.nodes[free].arc + (held < free ? -length : length);
}

// The nodes from `first` to `last` of a line, as a line of its own with the same ends.
struct LineStretch {
  model::Line line;
  Mesh mesh;
  LineSpan span;
};

LineStretch stretch_of(const model::Line& line, const LineAlone& mesh, double length, int first, int last) {
  const double near = 1e-9 * length;
  const auto arc = [&](int i) { return mesh.nodes[i].arc; };
  LineStretch out{line, {}, {}};
  model::Line& part = out.line;
  const double from = arc(first);
  const double to = arc(last);
  part.sections.clear();
  double start = 0;
  for (model::Section s : line.sections) {
    const double inside = std::min(start + s.length, to) - std::max(start, from);
    start += s.length;
    s.length = inside;
    if (inside > near) part.sections.push_back(s);
  }
  const auto outside = [&](const auto& p) { return p.at < from || p.at > to; };
  std::erase_if(part.masses, outside);
  std::erase_if(part.point_loads, outside);
  std::erase_if(part.loads, [&](const auto& q) { return q.to >= 0 && q.to <= from; });
  for (auto& m : part.masses) m.at -= from;
  for (auto& row : part.temperature_change) row.first -= from;
  for (auto& p : part.point_loads) p.at -= from;
  for (auto& q : part.loads) {
    q.from = std::max(0.0, q.from - from);
    q.to = q.to < 0 ? q.to : q.to - from;
  }
  for (int i = first; i <= last; ++i) {
    Node n = mesh.nodes[i];
    n.arc -= from;
    out.mesh.add(n);
  }
  for (int i = first; i < last; ++i) {
    Element e = mesh.elements[i];
    e.first = i - first;
    e.second = e.first + 1;
    out.mesh.add(e);
  }
  out.span.nodes = last - first + 1;
  out.span.elements = last - first;
  out.span.length = to - from;
  return out;
}

}  // namespace

// The nodes inside a feeder are at its feed point; the rest starts as a separate line.
LineStart line_start_fed(const model::Case& c, const model::Line& line, const Bodies& bodies,
                         const Mesh& mesh, const LineSpan& span) {
  FedStart a, b;
  if (line.end_a.feed) a = fed_start(mesh, span, LineEnd::A, line.end_a.feed->stock);
  if (line.end_b.feed) b = fed_start(mesh, span, LineEnd::B, line.end_b.feed->stock);
  const int first = a.inside;
  const int last = span.nodes - 1 - b.inside;
  LineAlone outside = alone(mesh, span);
  if (line.end_a.feed) at_feed_point(outside, first, first + 1, a.length);
  if (line.end_b.feed) at_feed_point(outside, last, last - 1, b.length);
  const LineStretch stretch = stretch_of(line, outside, span.length, first, last);
  LineStart free = line_start(c, stretch.line, bodies, stretch.mesh, stretch.span);
  const auto clamp = [&](const model::End& e, Vec3& tangent) {
    if (e.feed && e.clamped && e.direction)
      tangent = start_pose(c, bodies, e).rotation * e.direction->normalized();
  };
  clamp(line.end_a, free.tangent.front());
  clamp(line.end_b, free.tangent.back());
  LineStart out;
  for (int i = 0; i < span.nodes; ++i) {
    const size_t k = std::clamp(i, first, last) - first;
    out.x.push_back(free.x[k]);
    out.tangent.push_back(free.tangent[k]);
  }
  return out;
}

LineStart line_start_from_soil(const model::Case& c, const model::Line& line, const Bodies& bodies,
                               const Mesh& mesh, const LineSpan& span) {
  const double near = 1e-9 * span.length;
  const auto arc = [&](int i) { return mesh.node(span.first_node + i).arc; };
  // First and last node that is not buried.
  int first = 0;
  int last = span.nodes - 1;
  for (const model::Buried& b : line.buried) {
    if (b.from <= near)
      while (first + 1 < span.nodes && arc(first + 1) <= b.to + near) ++first;
    else
      while (last > 0 && arc(last - 1) >= b.from - near) --last;
  }
  const model::Seabed& bed = c.environment.seabed;
  const Vec3 xa = start_pose(c, bodies, line.end_a).to_space(line.end_a.at);
  const Vec3 xb = start_pose(c, bodies, line.end_b).to_space(line.end_b.at);
  LineStretch stretch = stretch_of(line, alone(mesh, span), span.length, first, last);
  const double from = arc(first);
  const double to = arc(last);
  stretch.line.buried.clear();
  const auto anchor = [](const Vec3& at) {
    model::End e;
    e.kind = model::EndKind::anchor;
    e.at = at;
    return e;
  };
  if (first > 0) stretch.line.end_a = anchor(exit_of_soil(bed, xa, xb, from));
  if (last < span.nodes - 1) stretch.line.end_b = anchor(exit_of_soil(bed, xb, xa, span.length - to));
  LineStart free = line_start(c, stretch.line, bodies, stretch.mesh, stretch.span);
  lift(bed, free);
  LineStart out;
  for (int i = 0; i < span.nodes; ++i) {
    const auto straight = [&](const Vec3& a, const Vec3& b, double fraction) {
      out.x.push_back(a + fraction * (b - a));
      out.tangent.push_back((b - a).normalized());
    };
    if (i < first) {
      straight(xa, stretch.line.end_a.at, arc(i) / from);
    } else if (i > last) {
      straight(stretch.line.end_b.at, xb, (arc(i) - to) / (span.length - to));
    } else {
      const size_t k = i - first;
      out.x.push_back(free.x[k]);
      out.tangent.push_back(free.tangent[k]);
    }
  }
  return out;
}

void lift(const model::Seabed& bed, LineStart& s) {
  if (!bed.surface) return;
  std::vector<bool> moved(s.x.size(), false);
  for (size_t i = 1; i + 1 < s.x.size(); ++i)
    if (const auto p = bed.surface->query(s.x[i], 0); p && p->distance < 0) {
      s.x[i] = p->point;
      moved[i] = true;
    }
  for (size_t i = 1; i + 1 < s.x.size(); ++i)
    if (moved[i - 1] || moved[i] || moved[i + 1]) s.tangent[i] = (s.x[i + 1] - s.x[i - 1]).normalized();
}

}  // namespace hawser
