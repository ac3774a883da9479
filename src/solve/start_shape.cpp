#include "hawser/solve/start_shape.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "flexible_start.hpp"
#include "hawser/base/error.hpp"
#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/catenary.hpp"
#include "hawser/kernels/catenary_on_bed.hpp"
#include "hawser/kernels/motion.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/solve/start_slack.hpp"
#include "hawser/terms/rigid_bodies.hpp"
#include "start_free_end.hpp"

namespace hawser {
namespace {

struct Shape {
  std::vector<Vec3> x, tangent;  // one a node
  std::vector<Quat> q;           // where known, else empty
};

RigidPose frame(const model::Case& c, const Bodies& bodies, const model::End& e) {
  return e.kind == model::EndKind::body ? bodies.pose(c.body_index(e.body), 0) : RigidPose{};
}

std::vector<CatenarySection> catenary_sections(const model::Case& c, const model::Line& line) {
  const model::Water& water = c.environment.water;
  double total = 0;
  for (const auto& s : line.sections) total += s.length;
  std::vector<CatenarySection> out;
  double from = 0;
  for (const auto& s : line.sections) {
    const auto& t = c.line_type(s.type);
    CatenarySection k;
    k.length = s.length;
    k.EA = t.EA;
    k.free_strain = model::thermal_strain(t, line, from, from + s.length);
    k.load = Vec3(0, 0, buoyancy(c, t) - c.environment.gravity * t.mass_per_length);
    for (const auto& l : line.loads) {
      if (l.ramp > 0) continue;  // not there yet at t = 0
      const double end = l.to < 0 ? total : l.to;
      const double overlap = std::min(from + s.length, end) - std::max(from, l.from);
      if (overlap > 0) k.load += overlap / s.length * l.per_length;
    }
    from += s.length;
    // Point masses and forces act at the end of the section they are in: a start shape need not be exact.
    const auto here = [&](double at) { return at > from - s.length && at <= from; };
    for (const auto& m : line.masses)
      if (here(m.at))
        k.end_load +=
            Vec3(0, 0, (water.present ? water.density * m.volume : 0) - m.mass) * c.environment.gravity;
    for (const auto& p : line.point_loads)
      if (here(p.at) && p.ramp == 0) k.end_load += p.force;
    out.push_back(k);
  }
  return out;
}

Shape from_catenary(const CatenaryShape& shape, const Mesh& mesh, const LineSpan& span) {
  Shape out;
  const double most = std::max(shape.tension_a().norm(), shape.tension_b().norm());
  for (int n = span.first_node; n < span.first_node + span.nodes; ++n) {
    const double s = mesh.nodes[static_cast<size_t>(n)].arc;
    out.x.push_back(shape.position(s));
    const Vec3 t = shape.tension(s);
    // At a free end the tension is nothing but round-off, and points anywhere.
    out.tangent.push_back(t.norm() > 1e-9 * most ? Vec3(t.normalized()) : Vec3::Zero());
  }
  return out;
}

// What is under a bed that is no plane is put on it: the start of statics, not its answer.
void lift(const model::Seabed& bed, Shape& s) {
  if (!bed.surface) return;
  std::vector<bool> moved(s.x.size(), false);
  for (size_t i = 1; i + 1 < s.x.size(); ++i)
    if (const auto p = bed.surface->query(s.x[i], 0); p && p->distance < 0)
      s.x[i] = p->point, moved[i] = true;
  for (size_t i = 1; i + 1 < s.x.size(); ++i)
    if (moved[i - 1] || moved[i] || moved[i + 1]) s.tangent[i] = (s.x[i + 1] - s.x[i - 1]).normalized();
}

// From B to A; a load at a joint goes to the section that ends there now.
std::vector<CatenarySection> backwards(std::vector<CatenarySection> sections) {
  std::reverse(sections.begin(), sections.end());
  for (size_t i = 0; i + 1 < sections.size(); ++i) sections[i].end_load = sections[i + 1].end_load;
  if (!sections.empty()) sections.back().end_load.setZero();
  return sections;
}

// A line from an end on the bed to one above it: part of it may lie. Nothing when there is no such shape.
std::optional<Shape> on_bed(const model::Case& c, const Vec3& xa, const Vec3& xb,
                            std::vector<CatenarySection> sections, const Mesh& mesh, const LineSpan& span) {
  const model::Seabed& bed = c.environment.seabed;
  if (!bed.present) return {};
  const double near = 1e-3 * std::abs(bed.depth);
  const bool a = std::abs(model::height_above_bed(bed, xa)) < near,
             b = std::abs(model::height_above_bed(bed, xb)) < near;
  if (a == b) return {};
  if (b) sections = backwards(std::move(sections));
  const auto found =
      catenary_on_bed(a ? xa : xb, a ? xb : xa, sections, bed.as_laid ? bed.friction.axial : 0);
  if (!found) return {};
  Shape out;
  for (int n = span.first_node; n < span.first_node + span.nodes; ++n) {
    const double s = mesh.nodes[static_cast<size_t>(n)].arc, from = a ? s : span.length - s;
    const double h = 1e-6 * span.length, low = std::max(0.0, from - h),
                 high = std::min(span.length, from + h);
    out.x.push_back(found->position(from));
    // Of the shape, not of the tension: what lies without tension has a direction too.
    const Vec3 t = found->position(high) - found->position(low);
    out.tangent.push_back((a ? t : Vec3(-t)).normalized());
  }
  return out;
}

// Nodes at equal fractions of the polyline's length; a straight line is a polyline of two points.
Shape along(const std::vector<Vec3>& points, const Mesh& mesh, const LineSpan& span) {
  std::vector<double> at{0};
  for (size_t i = 1; i < points.size(); ++i) at.push_back(at.back() + (points[i] - points[i - 1]).norm());
  Shape out;
  for (int n = span.first_node; n < span.first_node + span.nodes; ++n) {
    const double s = mesh.nodes[static_cast<size_t>(n)].arc / span.length * at.back();
    size_t i = 1;
    while (i + 1 < points.size() && s > at[i]) ++i;
    const double z = (s - at[i - 1]) / (at[i] - at[i - 1]);
    out.x.push_back(points[i - 1] + z * (points[i] - points[i - 1]));
    out.tangent.push_back((points[i] - points[i - 1]).normalized());
  }
  return out;
}

// As another run left it, by share of the length; ends that are held elsewhere now take the line along, in
// proportion to how near it is.
Shape as_left(const model::LeftShape& left, const std::optional<Vec3>& xa, const std::optional<Vec3>& xb,
              const Mesh& mesh, const LineSpan& span) {
  const SplineMotion spline(left.arc, left.position);
  const double there = left.arc.back();
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
  if (xa) a = *xa - left.position.front();
  if (xb) b = *xb - left.position.back();
  if (!xa) a = b;
  if (!xb) b = a;
  Shape out;
  for (int n = span.first_node; n < span.first_node + span.nodes; ++n) {
    const double share = mesh.nodes[static_cast<size_t>(n)].arc / span.length, s = share * there;
    const VectorMotion at = spline.at(s);
    out.x.push_back(at.value + (1 - share) * a + share * b);
    if (left.rotation.empty()) {
      out.tangent.push_back(at.rate.normalized());
      continue;
    }
    const auto above = std::upper_bound(left.arc.begin() + 1, left.arc.end() - 1, s);
    const size_t j = static_cast<size_t>(above - left.arc.begin());
    const double z = std::clamp((s - left.arc[j - 1]) / (left.arc[j] - left.arc[j - 1]), 0.0, 1.0);
    out.q.push_back(left.rotation[j - 1].slerp(z, left.rotation[j]));
    out.tangent.push_back(out.q.back() * Vec3::UnitX());
  }
  return out;
}

// Tangents where the shape has none (a slack end): from the neighbours' positions.
void mend(Shape& s) {
  for (size_t i = 0; i < s.x.size(); ++i) {
    if (s.tangent[i].norm() > 0) continue;
    const Vec3 d = s.x[std::min(i + 1, s.x.size() - 1)] - s.x[i > 0 ? i - 1 : 0];
    s.tangent[i] = d.norm() > 0 ? Vec3(d.normalized()) : Vec3::UnitX();
  }
}

// Places alone; mend() makes the tangents.
Shape through(std::vector<Vec3> x) {
  Shape out;
  out.tangent.assign(x.size(), Vec3::Zero());
  out.x = std::move(x);
  return out;
}

// Whether all of the line sinks (or floats), and is longer than the way to the bed (or the surface), along it
// and back: then its middle lies there without tension, and no balance says where.
bool lies_slack(const model::Case& c, const std::vector<CatenarySection>& sections, const Shape& s,
                double length, bool& floats) {
  const model::Seabed& bed = c.environment.seabed;
  const auto all = [&](double sign) {
    return std::all_of(sections.begin(), sections.end(), [sign](const CatenarySection& k) {
      return sign * k.load.z() > 0 && sign * k.end_load.z() >= 0;
    });
  };
  floats = c.environment.water.present && all(1);
  if (!floats && (!bed.present || bed.surface || !all(-1))) return false;
  const auto off = [&](const Vec3& x) {
    return std::abs(floats ? x.z() - c.environment.water.surface : model::height_above_bed(bed, x));
  };
  const Vec3 &from = s.x.front(), &to = s.x.back();
  return length > std::hypot(to.x() - from.x(), to.y() - from.y()) + off(from) + off(to);
}

// What a catenary has under the bed, or a floating line's above the surface, lies in an arc instead. Returns
// whether it was so.
bool lay(const model::Case& c, const std::vector<CatenarySection>& sections, const Mesh& mesh,
         const LineSpan& span, Shape& s) {
  bool floats = false;
  std::vector<double> arc{0};  // as long as it is without tension
  for (int e = span.first_element; e < span.first_element + span.elements; ++e) {
    const Element& g = mesh.elements[static_cast<size_t>(e)];
    arc.push_back(arc.back() + (1 + g.free_strain) * g.length);
  }
  if (!lies_slack(c, sections, s, arc.back(), floats)) return false;
  if (!lay_slack(c.environment, floats, arc, s.x)) return false;
  for (Vec3& t : s.tangent) t.setZero();  // mend() makes them
  return true;
}

HeldEnd held_end(const model::Case& c, const Bodies& bodies, const model::Line& line) {
  const bool a = line.end_a.kind != model::EndKind::free;
  const model::End& e = a ? line.end_a : line.end_b;
  const RigidPose pose = frame(c, bodies, e);
  HeldEnd out;
  out.at = pose.to_space(e.at);
  if (e.direction) out.direction = pose.rotation * (a ? *e.direction : Vec3(-*e.direction));
  if (e.kind == model::EndKind::body) out.body = pose.rotation * e.at;
  return out;
}

// A line with one free end that comes to lie: out of a heap.
Shape lay_free(const model::Case& c, const model::Line& line, const Bodies& bodies,
               const std::vector<CatenarySection>& sections, const Mesh& mesh, const LineSpan& span,
               const std::vector<Vec3>& x) {
  const bool a = line.end_a.kind != model::EndKind::free;
  const HeldEnd end = held_end(c, bodies, line);
  std::vector<double> arc;
  for (int n = 0; n < span.nodes; ++n) {
    const int i = span.first_node + (a ? n : span.nodes - 1 - n);
    const double s = mesh.nodes[static_cast<size_t>(i)].arc;
    arc.push_back(a ? s : span.length - s);
  }
  auto laid =
      streams(c, line) ? std::nullopt : laid_free_end(c, line, end, a ? sections : backwards(sections), arc);
  if (laid) {
    if (!a) std::reverse(laid->begin(), laid->end());
    return through(*std::move(laid));
  }
  return through(flexible_start(c, line, mesh, span, x, way_of_free_end(c, line, end, false)));
}

Shape place(const model::Case& c, const model::Line& line, const Bodies& bodies, const Mesh& mesh,
            const LineSpan& span) {
  using model::EndKind, model::Start;
  const bool a = line.end_a.kind != EndKind::free, b = line.end_b.kind != EndKind::free;
  const Vec3 xa = frame(c, bodies, line.end_a).to_space(line.end_a.at);
  const Vec3 xb = frame(c, bodies, line.end_b).to_space(line.end_b.at);
  if (line.start == Start::points) return along(line.points, mesh, span);
  if (line.start == Start::other_run)
    return as_left(*line.left, a ? std::optional(xa) : std::nullopt, b ? std::optional(xb) : std::nullopt,
                   mesh, span);
  const auto straight = [&] {
    if (a && b) return along({xa, xb}, mesh, span);
    const model::End& e = a ? line.end_a : line.end_b;
    const Vec3 d = e.direction ? Vec3(frame(c, bodies, e).rotation * *e.direction) : Vec3(0, 0, a ? -1 : 1);
    return a ? along({xa, xa + span.length * d}, mesh, span) : along({xb - span.length * d, xb}, mesh, span);
  };
  const auto sections = catenary_sections(c, line);
  // Nothing to hang by: any shape of the right length will do, and a straight one is the least surprise.
  const bool loaded = std::any_of(sections.begin(), sections.end(), [](const CatenarySection& s) {
    return !s.load.isZero(0) || !s.end_load.isZero(0);
  });
  if ((a || b) && (line.start == Start::straight || !loaded)) return straight();
  if (!a && !b) throw InputError("lines." + line.name + ": both ends are free and no start shape is given");
  const auto closed_form = [&]() -> std::optional<Shape> {
    try {
      if (a && b) {
        auto shape = on_bed(c, xa, xb, sections, mesh, span);
        return shape ? *std::move(shape) : from_catenary(catenary(xa, xb, sections), mesh, span);
      }
      return from_catenary(a ? catenary_free_b(xa, sections) : catenary_free_a(xb, sections), mesh, span);
    } catch (const std::invalid_argument&) {
      return {};  // slack, and its shape not determined
    } catch (const std::runtime_error&) {
      return {};
    }
  };
  std::optional<Shape> shape = closed_form();
  const bool hangs = shape && !goes_through(c, line, shape->x) && ((a && b) || !folded(shape->x));
  if (shape && (line.start != Start::automatic || (hangs && !streams(c, line)))) return *std::move(shape);
  if (shape && a && b && lay(c, sections, mesh, span, *shape)) return *std::move(shape);
  const std::vector<Vec3> x = shape ? shape->x : straight().x;
  if (!hangs && !(a && b)) return lay_free(c, line, bodies, sections, mesh, span, x);
  return through(flexible_start(c, line, mesh, span, x, Vec3::Zero()));
}

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

// Ends in the soil go straight out of it; between them the line is one that starts on the bed. What is buried
// ends at a node here.
Shape out_of_soil(const model::Case& c, const model::Line& line, const Bodies& bodies, const Mesh& mesh,
                  const LineSpan& span) {
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
  const Vec3 xa = frame(c, bodies, line.end_a).to_space(line.end_a.at),
             xb = frame(c, bodies, line.end_b).to_space(line.end_b.at);
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
  Shape free = place(c, rest, bodies, part, between);
  lift(bed, free);
  Shape out;
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

// Axes with the first along t and the second horizontal.
Quat axes_along(const Vec3& t) {
  const Vec3 side = std::abs(t.z()) > 0.999 ? Vec3::UnitY() : Vec3::UnitZ();
  Mat3 m;
  m.col(0) = t;
  m.col(1) = (std::abs(t.z()) > 0.999 ? Vec3(side - side.dot(t) * t) : Vec3(side.cross(t))).normalized();
  m.col(2) = m.col(0).cross(m.col(1));
  return Quat(m);
}

}  // namespace

StartShape start_shape(const model::Case& c, const LocalMesh& mesh, const Bodies& bodies) {
  const Mesh& g = *mesh.mesh;
  StartShape out{State(mesh.nodes()), {}};

  for (size_t l = 0; l < c.lines.size(); ++l) {
    const model::Line& line = c.lines[l];
    const LineSpan& span = g.lines[l];
    const bool by_itself = line.start == model::Start::automatic || line.start == model::Start::catenary;
    Shape shape = by_itself && !line.buried.empty() ? out_of_soil(c, line, bodies, g, span)
                                                    : place(c, line, bodies, g, span);
    mend(shape);
    if (by_itself && line.buried.empty()) lift(c.environment.seabed, shape);
    auto clamp_direction = [&](const model::End& e, size_t node) {
      if (e.clamped && e.direction)
        shape.tangent[node] = frame(c, bodies, e).rotation * e.direction->normalized();
    };
    clamp_direction(line.end_a, 0);
    clamp_direction(line.end_b, shape.x.size() - 1);
    std::vector<Quat> q = shape.q;
    if (q.empty()) {
      q.push_back(axes_along(shape.tangent[0]));
      for (size_t i = 1; i < shape.x.size(); ++i)
        q.push_back((minimal_rotation(shape.tangent[i - 1], shape.tangent[i]) * q.back()).normalized());
    } else {  // a clamped end may point elsewhere now
      for (size_t i = 0; i < q.size(); ++i)
        q[i] = (minimal_rotation(q[i] * Vec3::UnitX(), shape.tangent[i]) * q[i]).normalized();
    }

    for (int i = 0; i < span.nodes; ++i) {
      const int here = mesh.find(span.first_node + i);
      if (here < 0) continue;
      const size_t n = static_cast<size_t>(here), k = static_cast<size_t>(i);
      out.state.x[n] = shape.x[k];
      if (mesh.rotates(here)) out.state.q[n] = q[k];
    }
    bool twist_held = line.end_a.clamped || line.end_b.clamped;
    // Friction of the bed holds a line without held ends that was laid on it; nothing holds its twist.
    if (line.end_a.kind == model::EndKind::free && line.end_b.kind == model::EndKind::free &&
        c.statics.enabled && model::laid_with_friction(c, line) &&
        g.nodes[static_cast<size_t>(span.first_node)].rotates)
      if (const int here = mesh.find(span.first_node); here >= 0) {
        Support s;
        s.position_mask = 0, s.rotation_mask = 1, s.node = here;
        out.supports.push_back(s);
      }
    // Twist is held at a joint only where no other end is held.
    const bool joint_first = line.end_a.kind == model::EndKind::joint;
    for (int k = 0; k < 2; ++k) {
      const int end = joint_first ? 1 - k : k;
      const model::End& e = end ? line.end_b : line.end_a;
      if (e.kind == model::EndKind::free) continue;
      const int node = span.first_node + (end ? span.nodes - 1 : 0);
      const bool joint = e.kind == model::EndKind::joint;
      if (const int here = mesh.find(node); joint && here >= 0)
        out.state.x[static_cast<size_t>(here)] = e.at;  // exactly as the other ends there
      if (joint && (twist_held || !g.nodes[static_cast<size_t>(node)].rotates)) continue;
      Support s;
      if (joint) s.position_mask = 0;
      s.body = e.kind == model::EndKind::body ? c.body_index(e.body) : -1;
      s.at = e.at;
      if (g.nodes[static_cast<size_t>(node)].rotates) {
        if (e.clamped) {
          s.rotation_mask = 7;
          s.rotation = frame(c, bodies, e).rotation.conjugate() * q[end ? q.size() - 1 : 0];
        } else if (!twist_held) {
          s.rotation_mask = 1;
          twist_held = true;
        }
      }
      if (const int here = mesh.find(node); here >= 0) {
        s.node = here;
        out.supports.push_back(s);
      }
    }
  }
  for (int n = 0; n < mesh.nodes(); ++n) {
    const int body = g.nodes[static_cast<size_t>(mesh.global[static_cast<size_t>(n)])].body;
    if (body < 0) continue;
    const RigidBodyState s = floating_start(*c.bodies[static_cast<size_t>(body)].mass, bodies.pose(body, 0));
    const size_t i = static_cast<size_t>(n);
    out.state.x[i] = s.x, out.state.q[i] = s.q, out.state.v[i] = s.v, out.state.w[i] = s.w;
  }
  return out;
}

}  // namespace hawser
