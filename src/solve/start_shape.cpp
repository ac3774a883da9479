#include "hawser/solve/start_shape.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "hawser/base/error.hpp"
#include "hawser/kernels/catenary.hpp"
#include "hawser/kernels/catenary_on_bed.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/solve/start_slack.hpp"
#include "hawser/terms/rigid_bodies.hpp"

namespace hawser {
namespace {

struct Shape {
  std::vector<Vec3> x, tangent;  // one a node
};

RigidPose frame(const model::Case& c, const Bodies& bodies, const model::End& e) {
  return e.kind == model::EndKind::body ? bodies.pose(c.body_index(e.body), 0) : RigidPose{};
}

// N/m of a line under water.
double buoyancy(const model::Case& c, const model::LineType& t) {
  const model::Water& w = c.environment.water;
  return w.present ? w.density * c.environment.gravity * M_PI / 4 * t.displaced() * t.displaced() : 0;
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

// A line from an end on the bed to one above it: part of it may lie. Nothing when there is no such shape.
std::optional<Shape> on_bed(const model::Case& c, const Vec3& xa, const Vec3& xb,
                            std::vector<CatenarySection> sections, const Mesh& mesh, const LineSpan& span) {
  const model::Seabed& bed = c.environment.seabed;
  if (!bed.present) return {};
  const Vec3 down(std::cos(bed.direction), std::sin(bed.direction), 0);
  const auto height = [&](const Vec3& x) { return x.z() + bed.depth + std::tan(bed.slope) * down.dot(x); };
  const double near = 1e-3 * bed.depth;
  const bool a = std::abs(height(xa)) < near, b = std::abs(height(xb)) < near;
  if (a == b) return {};
  if (b) {  // from B to A; a load at a joint goes to the section that ends there now
    std::reverse(sections.begin(), sections.end());
    for (size_t i = 0; i + 1 < sections.size(); ++i) sections[i].end_load = sections[i + 1].end_load;
    sections.back().end_load.setZero();
  }
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

// Tangents where the shape has none (a slack end): from the neighbours' positions.
void mend(Shape& s) {
  for (size_t i = 0; i < s.x.size(); ++i) {
    if (s.tangent[i].norm() > 0) continue;
    const Vec3 d = s.x[std::min(i + 1, s.x.size() - 1)] - s.x[i > 0 ? i - 1 : 0];
    s.tangent[i] = d.norm() > 0 ? Vec3(d.normalized()) : Vec3::UnitX();
  }
}

// A catenary that goes through the bed, or into the air though the line floats, lies there instead.
void lay(const model::Case& c, const std::vector<CatenarySection>& sections, const Mesh& mesh,
         const LineSpan& span, Shape& s) {
  const bool floats = c.environment.water.present &&
                      std::all_of(sections.begin(), sections.end(), [](const CatenarySection& k) {
                        return k.load.z() > 0 && k.end_load.z() >= 0;
                      });
  std::vector<double> arc;
  for (int n = span.first_node; n < span.first_node + span.nodes; ++n)
    arc.push_back(mesh.nodes[static_cast<size_t>(n)].arc);
  if (lay_slack(c.environment, floats, arc, s.x))
    for (Vec3& t : s.tangent) t.setZero();  // mend() makes them
}

Shape place(const model::Case& c, const model::Line& line, const Bodies& bodies, const Mesh& mesh,
            const LineSpan& span) {
  using model::EndKind, model::Start;
  const bool a = line.end_a.kind != EndKind::free, b = line.end_b.kind != EndKind::free;
  const Vec3 xa = frame(c, bodies, line.end_a).to_space(line.end_a.at);
  const Vec3 xb = frame(c, bodies, line.end_b).to_space(line.end_b.at);
  if (line.start == Start::points) return along(line.points, mesh, span);
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
  try {
    if (a && b)
      if (auto shape = on_bed(c, xa, xb, sections, mesh, span)) return *std::move(shape);
    if (a && b) {
      Shape shape = from_catenary(catenary(xa, xb, sections), mesh, span);
      if (line.start == Start::automatic) lay(c, sections, mesh, span, shape);
      return shape;
    }
    if (a) return from_catenary(catenary_free_b(xa, sections), mesh, span);
    if (b) return from_catenary(catenary_free_a(xb, sections), mesh, span);
  } catch (const std::invalid_argument&) {
    return straight();  // slack, and its shape not determined
  }
  throw InputError("lines." + line.name + ": both ends are free and no start shape is given");
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
    Shape shape = place(c, line, bodies, g, span);
    mend(shape);
    auto clamp_direction = [&](const model::End& e, size_t node) {
      if (e.clamped && e.direction)
        shape.tangent[node] = frame(c, bodies, e).rotation * e.direction->normalized();
    };
    clamp_direction(line.end_a, 0);
    clamp_direction(line.end_b, shape.x.size() - 1);
    std::vector<Quat> q{axes_along(shape.tangent[0])};
    for (size_t i = 1; i < shape.x.size(); ++i)
      q.push_back((minimal_rotation(shape.tangent[i - 1], shape.tangent[i]) * q.back()).normalized());

    for (int i = 0; i < span.nodes; ++i) {
      const int here = mesh.find(span.first_node + i);
      if (here < 0) continue;
      const size_t n = static_cast<size_t>(here), k = static_cast<size_t>(i);
      out.state.x[n] = shape.x[k];
      if (mesh.rotates(here)) out.state.q[n] = q[k];
    }
    bool twist_held = line.end_a.clamped || line.end_b.clamped;
    for (int end = 0; end < 2; ++end) {
      const model::End& e = end ? line.end_b : line.end_a;
      if (e.kind == model::EndKind::free) continue;
      const int node = span.first_node + (end ? span.nodes - 1 : 0);
      Support s;
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
