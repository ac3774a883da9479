// Starts of lines that begin or end in the soil, or over a bed that is no plane.
#include <algorithm>
#include <cmath>

#include "hawser/geometry/surface.hpp"
#include "hawser/model/bed.hpp"
#include "line_start.hpp"

namespace hawser {
namespace {

// Where `length` [m] of line that goes straight from `from`, in the soil, comes out of it on the way to `to`.
Vec3 exit_of_soil(const model::Seabed& bed, const Vec3& from, const Vec3& to, double length) {
  Vec3 way(to.x() - from.x(), to.y() - from.y(), 0);
  way = way.norm() > 0 ? Vec3(way.normalized()) : Vec3::UnitX();
  Vec3 x = from;
  double low = 0, high = length;
  for (int i = 0; i < 60; ++i) {
    const double off = 0.5 * (low + high);
    x = Vec3(from.x() + off * way.x(), from.y() + off * way.y(), x.z());
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

}  // namespace

LineStart line_start_from_soil(const model::Case& c, const model::Line& line, const Bodies& bodies,
                               const Mesh& mesh, const LineSpan& span) {
  const double near = 1e-9 * span.length;
  const auto arc = [&](int i) { return mesh.nodes[static_cast<size_t>(span.first_node + i)].arc; };
  int first = 0, last = span.nodes - 1;  // of what is not buried
  for (const model::Buried& b : line.buried) {
    if (b.from <= near)
      while (first + 1 < span.nodes && arc(first + 1) <= b.to + near) ++first;
    else
      while (last > 0 && arc(last - 1) >= b.from - near) --last;
  }
  const model::Seabed& bed = c.environment.seabed;
  const Vec3 xa = start_pose(c, bodies, line.end_a).to_space(line.end_a.at),
             xb = start_pose(c, bodies, line.end_b).to_space(line.end_b.at);
  model::Line rest = line;
  rest.buried.clear();
  Mesh part = mesh;
  LineSpan between = span;
  const double from = arc(first), to = arc(last);
  const auto anchor = [](const Vec3& at) {
    model::End e;
    e.kind = model::EndKind::anchor, e.at = at;
    return e;
  };
  if (first > 0) rest.end_a = anchor(exit_of_soil(bed, xa, xb, from));
  if (last < span.nodes - 1) rest.end_b = anchor(exit_of_soil(bed, xb, xa, span.length - to));
  rest.sections.clear();
  double start = 0;
  for (model::Section s : line.sections) {
    const double in = std::min(start + s.length, to) - std::max(start, from);
    start += s.length;
    s.length = in;
    if (in > near) rest.sections.push_back(s);
  }
  const auto outside = [&](const auto& p) { return p.at < from || p.at > to; };
  std::erase_if(rest.masses, outside), std::erase_if(rest.point_loads, outside);
  std::erase_if(rest.loads, [&](const auto& q) { return q.to >= 0 && q.to <= from; });
  for (auto& m : rest.masses) m.at -= from;
  for (auto& row : rest.temperature_change) row.first -= from;
  for (auto& p : rest.point_loads) p.at -= from;
  for (auto& q : rest.loads) q.from = std::max(0.0, q.from - from), q.to = q.to < 0 ? q.to : q.to - from;
  for (int i = first; i <= last; ++i) part.nodes[static_cast<size_t>(span.first_node + i)].arc -= from;
  between.first_node += first, between.nodes = last - first + 1;
  between.first_element += first, between.elements = last - first;
  between.length = to - from;
  LineStart free = line_start(c, rest, bodies, part, between);
  lift(bed, free);
  LineStart out;
  for (int i = 0; i < span.nodes; ++i) {
    const auto straight = [&](const Vec3& a, const Vec3& b, double share) {
      out.x.push_back(a + share * (b - a));
      out.tangent.push_back((b - a).normalized());
    };
    if (i < first) {
      straight(xa, rest.end_a.at, arc(i) / from);
    } else if (i > last) {
      straight(rest.end_b.at, xb, (arc(i) - to) / (span.length - to));
    } else {
      const size_t k = static_cast<size_t>(i - first);
      out.x.push_back(free.x[k]), out.tangent.push_back(free.tangent[k]);
    }
  }
  return out;
}

void lift(const model::Seabed& bed, LineStart& s) {
  if (!bed.surface) return;
  std::vector<bool> moved(s.x.size(), false);
  for (size_t i = 1; i + 1 < s.x.size(); ++i)
    if (const auto p = bed.surface->query(s.x[i], 0); p && p->distance < 0)
      s.x[i] = p->point, moved[i] = true;
  for (size_t i = 1; i + 1 < s.x.size(); ++i)
    if (moved[i - 1] || moved[i] || moved[i + 1]) s.tangent[i] = (s.x[i + 1] - s.x[i - 1]).normalized();
}

}  // namespace hawser
