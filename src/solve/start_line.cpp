// Selects the start shape of each line: given points, another run's shape, a straight line, a catenary with
// or without seabed, an arc of slack, or the shape of least energy.
#include "start_line.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "hawser/advice/start_shape.hpp"
#include "hawser/base/error.hpp"
#include "hawser/kernels/catenary.hpp"
#include "hawser/kernels/catenary_on_bed.hpp"
#include "hawser/kernels/motion.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/solve/start_slack.hpp"
#include "start_flexible.hpp"
#include "start_free_end.hpp"
#include "start_on_supports.hpp"

namespace hawser {
namespace {

// Relative excess of length below which a line counts as no longer than the distance of its ends.
constexpr double kSlack = 1e-4;

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
      if (l.ramp > 0) continue;  // the load is zero at t = 0
      const double end = l.to < 0 ? total : l.to;
      const double overlap = std::min(from + s.length, end) - std::max(from, l.from);
      if (overlap > 0) k.load += overlap / s.length * l.per_length;
    }
    from += s.length;
    // Point masses and forces act at the end of their section, which is accurate enough for a start shape.
    const auto in_section = [&](double at) { return at > from - s.length && at <= from; };
    for (const auto& m : line.masses)
      if (in_section(m.at))
        k.end_load +=
            Vec3(0, 0, (water.present ? water.density * m.volume : 0) - m.mass) * c.environment.gravity;
    for (const auto& p : line.point_loads)
      if (in_section(p.at) && p.ramp == 0) k.end_load += p.force;
    out.push_back(k);
  }
  return out;
}

LineStart from_catenary(const CatenaryShape& shape, const Mesh& mesh, const LineSpan& span) {
  LineStart out;
  const double largest_tension = std::max(shape.tension_a().norm(), shape.tension_b().norm());
  for (int n = span.first_node; n < span.first_node + span.nodes; ++n) {
    const double s = mesh.node(n).arc;
    out.x.push_back(shape.position(s));
    const Vec3 t = shape.tension(s);
    // At a free end the tension is only round-off and has no meaningful direction.
    out.tangent.push_back(t.norm() > 1e-9 * largest_tension ? Vec3(t.normalized()) : Vec3::Zero());
  }
  return out;
}

// The sections from B to A. A load at a joint of sections goes to the section that now ends there.
std::vector<CatenarySection> backwards(std::vector<CatenarySection> sections) {
  std::reverse(sections.begin(), sections.end());
  for (size_t i = 0; i + 1 < sections.size(); ++i) sections[i].end_load = sections[i + 1].end_load;
  if (!sections.empty()) sections.back().end_load.setZero();
  return sections;
}

// Start shape of a line from an end near the bed to one high above it, of which a part may lie on the bed. If
// the lower end is above the bed, the line first hangs straight down from it. The closed form uses the plane
// through the points on the bed under both ends. None if there is no such shape.
std::optional<LineStart> on_bed(const model::Case& c, const model::Line& line, const Vec3& xa, const Vec3& xb,
                                std::vector<CatenarySection> sections, const Mesh& mesh,
                                const LineSpan& span) {
  constexpr double kNear = 0.1;  // of the other end's height
  const model::Seabed& bed = c.environment.seabed;
  if (!bed.present) return {};
  const double heights[2] = {model::height_above_bed(bed, xa), model::height_above_bed(bed, xb)};
  const bool b = heights[1] < heights[0];
  if (!(heights[b ? 1 : 0] < kNear * heights[b ? 0 : 1])) return {};
  if (b) sections = backwards(std::move(sections));
  const model::LineType& type = c.line_type((b ? line.sections.back() : line.sections.front()).type);
  const Vec3& high = b ? xa : xb;
  const Vec3 anchor = model::below_on_bed(bed, b ? xb : xa) + Vec3(0, 0, model::resting_height(c, type));
  const Vec3 foot = model::below_on_bed(bed, high) + Vec3(0, 0, model::resting_height(c, type));
  const double distance = (foot - anchor).norm();
  if (!(distance > 0)) return {};
  const Vec3& low = b ? xb : xa;
  const double hang = std::max(0.0, heights[b ? 1 : 0] - 0.5 * type.contact_diameter);
  if (!(hang < sections.front().length)) return {};
  sections.front().length -= hang;
  const double rise = (foot.z() - anchor.z()) / distance;  // sine of the slope
  const double friction = (bed.as_laid ? bed.friction.axial : 0) * std::sqrt(1 - rise * rise) + rise;
  const auto shape =
      catenary_on_bed(anchor, high, sections, std::max(0.0, friction), rise / std::sqrt(1 - rise * rise));
  if (!shape) return {};
  const auto place = [&](double from) -> Vec3 {
    if (from < hang) return low - Vec3(0, 0, from);
    return shape->position(from - hang);
  };
  LineStart out;
  for (int n = span.first_node; n < span.first_node + span.nodes; ++n) {
    const double s = mesh.node(n).arc;
    const double from = b ? span.length - s : s;
    const double h = 1e-6 * span.length;
    out.x.push_back(place(from));
    // The tangent is that of the shape, because a part without tension has a direction, too.
    const Vec3 t = place(std::min(span.length, from + h)) - place(std::max(0.0, from - h));
    out.tangent.push_back((b ? Vec3(-t) : t).normalized());
  }
  out.x.front() = xa;
  out.x.back() = xb;
  return out;
}

// Places nodes at equal fractions of the polyline's length. A straight line is a polyline of two points.
LineStart along(const std::vector<Vec3>& points, const Mesh& mesh, const LineSpan& span) {
  std::vector<double> at{0};
  for (size_t i = 1; i < points.size(); ++i) at.push_back(at.back() + (points[i] - points[i - 1]).norm());
  LineStart out;
  for (int n = span.first_node; n < span.first_node + span.nodes; ++n) {
    const double s = mesh.node(n).arc / span.length * at.back();
    size_t i = 1;
    while (i + 1 < points.size() && s > at[i]) ++i;
    const double z = (s - at[i - 1]) / (at[i] - at[i - 1]);
    out.x.push_back(points[i - 1] + z * (points[i] - points[i - 1]));
    out.tangent.push_back((points[i] - points[i - 1]).normalized());
  }
  return out;
}

// The given points, with the first and last one at the held ends, from which the case may differ by rounding.
LineStart through_points(std::vector<Vec3> points, const std::optional<Vec3>& xa,
                         const std::optional<Vec3>& xb, const Mesh& mesh, const LineSpan& span) {
  if (xa) points.front() = *xa;
  if (xb) points.back() = *xb;
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return along(points, mesh, span);
}

// Shape of another run, by fraction of the length. If ends are held elsewhere now, the line is shifted with
// them, in proportion to its nearness to each end.
LineStart as_previous(const model::PreviousShape& previous, const std::optional<Vec3>& xa,
                      const std::optional<Vec3>& xb, const Mesh& mesh, const LineSpan& span) {
  const RowCurve spline(previous.arc, previous.position);
  const double previous_length = previous.arc.back();
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
  if (xa) a = *xa - previous.position.front();
  if (xb) b = *xb - previous.position.back();
  if (!xa) a = b;
  if (!xb) b = a;
  LineStart out;
  for (int n = span.first_node; n < span.first_node + span.nodes; ++n) {
    const double fraction = mesh.node(n).arc / span.length;
    const double s = fraction * previous_length;
    const VectorMotion at = spline.at(s);
    out.x.push_back(at.value + (1 - fraction) * a + fraction * b);
    if (previous.rotation.empty()) {
      out.tangent.push_back(at.rate.normalized());
      continue;
    }
    const auto above = std::upper_bound(previous.arc.begin() + 1, previous.arc.end() - 1, s);
    const size_t j = above - previous.arc.begin();
    const double z =
        std::clamp((s - previous.arc[j - 1]) / (previous.arc[j] - previous.arc[j - 1]), 0.0, 1.0);
    out.q.push_back(previous.rotation[j - 1].slerp(z, previous.rotation[j]));
    out.tangent.push_back(out.q.back() * Vec3::UnitX());
  }
  return out;
}

// A shape of positions only; repair() computes the tangents.
LineStart through(std::vector<Vec3> x) {
  LineStart out;
  out.tangent.assign(x.size(), Vec3::Zero());
  out.x = std::move(x);
  return out;
}

// Where the middle of a line lies without tension, so that equilibrium does not determine its place: the
// whole line sinks (or floats) and is longer than the path from one end to the bed (or the surface), along
// it, and up to the other end. None: nowhere, or on a measured bed.
std::optional<LiesOn> lies_slack(const model::Case& c, const std::vector<CatenarySection>& sections,
                                 const LineStart& s, double length) {
  const model::Seabed& bed = c.environment.seabed;
  const std::optional<LiesOn> where = comes_to_lie(c, sections);
  if (!where || (*where == LiesOn::bed && bed.surface)) return std::nullopt;
  const bool floats = *where == LiesOn::water_surface;
  const auto off = [&](const Vec3& x) {
    return std::abs(floats ? x.z() - c.environment.water.surface : model::height_above_bed(bed, x));
  };
  const Vec3& from = s.x.front();
  const Vec3& to = s.x.back();
  if (length > std::hypot(to.x() - from.x(), to.y() - from.y()) + off(from) + off(to)) return where;
  return std::nullopt;
}

// Replaces the part of a catenary under the bed, or the part of a floating line above the surface, by an arc.
// Returns whether there was such a part.
bool lay(const model::Case& c, const std::vector<CatenarySection>& sections, const Mesh& mesh,
         const LineSpan& span, LineStart& s) {
  std::vector<double> arc{0};  // arc lengths without tension
  for (int e = span.first_element; e < span.first_element + span.elements; ++e) {
    const Element& g = mesh.element(e);
    arc.push_back(arc.back() + (1 + g.free_strain) * g.length);
  }
  const std::optional<LiesOn> where = lies_slack(c, sections, s, arc.back());
  if (!where || !lay_slack(c.environment, *where, arc, s.x)) return false;
  for (Vec3& t : s.tangent) t.setZero();  // repair() computes them
  return true;
}

HeldEnd held_end(const model::Case& c, const Bodies& bodies, const model::Line& line) {
  const bool a = line.end_a.kind != model::EndKind::free;
  const model::End& e = a ? line.end_a : line.end_b;
  const RigidPose pose = start_pose(c, bodies, e);
  HeldEnd out;
  out.at = pose.to_space(e.at);
  if (e.direction) out.direction = pose.rotation * (a ? *e.direction : Vec3(-*e.direction));
  if (e.kind == model::EndKind::body) out.body = pose.rotation * e.at;
  return out;
}

// Start shape of a line with one free end, laid without a heap.
LineStart lay_free(const model::Case& c, const model::Line& line, const Bodies& bodies,
                   const std::vector<CatenarySection>& sections, const Mesh& mesh, const LineSpan& span,
                   const std::vector<Vec3>& x) {
  const bool a = line.end_a.kind != model::EndKind::free;
  const HeldEnd end = held_end(c, bodies, line);
  std::vector<double> arc;
  for (int n = 0; n < span.nodes; ++n) {
    const int i = span.first_node + (a ? n : span.nodes - 1 - n);
    const double s = mesh.node(i).arc;
    arc.push_back(a ? s : span.length - s);
  }
  auto laid =
      streams(c, line) ? std::nullopt : laid_free_end(c, line, end, a ? sections : backwards(sections), arc);
  if (laid) {
    if (!a) std::reverse(laid->begin(), laid->end());
    return through(*std::move(laid));
  }
  return through(flexible_start(c, line, mesh, span, x, direction_of_free_end(c, line, end, LiesOn::bed)));
}

double smallest_bending_stiffness(const model::Case& c, const model::Line& line) {
  double least = HUGE_VAL;
  for (const model::Section& s : line.sections)
    least = std::min(least, c.line_type(s.type).smallest_bending_stiffness());
  return least;
}

// True if a line that is no longer than the distance of its ends carries its weight by bending: as a cable it
// would sag under the tension w L²/(8 sag), and a beam whose buckling load is above this tension sags less.
bool is_beam(const model::Case& c, const model::Line& line, const std::vector<CatenarySection>& sections,
             double length, const std::vector<Vec3>& x) {
  const Vec3 chord = x.back() - x.front();
  if (length > (1 + kSlack) * chord.norm()) return false;
  const double stiffness = smallest_bending_stiffness(c, line);
  double load = 0, sag = 0;
  for (const CatenarySection& s : sections) load = std::max(load, s.load.norm());
  for (const Vec3& p : x) sag = std::max(sag, (p - x.front()).cross(chord).norm() / chord.norm());
  return load * std::pow(length, 4) < 8 * sag * M_PI * M_PI * stiffness;
}

// True if a line clamped at one end is stable as a straight line in any direction. A column of the weight w
// [N/m] and the length L is stable for w L³ < 7.837 EI (Greenhill 1881), one under a load P at its end while
// P L² < pi²/4 EI (Euler).
bool stands(const model::Case& c, const model::Line& line, const std::vector<CatenarySection>& sections,
            double length) {
  const model::End& e = line.end_a.kind != model::EndKind::free ? line.end_a : line.end_b;
  const bool held = e.clamped || (e.kind == model::EndKind::joint && c.joint(e.carrier).rigid);
  if (!held || !e.direction) return false;
  const double stiffness = smallest_bending_stiffness(c, line);
  double load = 0, at_end = 0;
  for (const CatenarySection& s : sections) {
    load = std::max(load, s.load.norm());
    at_end += s.end_load.norm();
  }
  return load * std::pow(length, 3) / 7.837 + at_end * length * length * 4 / (M_PI * M_PI) < stiffness;
}

}  // namespace

RigidPose start_pose(const model::Case& c, const Bodies& bodies, const model::End& e) {
  return e.kind == model::EndKind::body ? bodies.pose(c.body_index(e.carrier), 0) : RigidPose{};
}

LineStart line_start(const model::Case& c, const model::Line& line, const Bodies& bodies, const Mesh& mesh,
                     const LineSpan& span) {
  using model::EndKind, model::Start;
  const bool a = line.end_a.kind != EndKind::free;
  const bool b = line.end_b.kind != EndKind::free;
  const Vec3 xa = start_pose(c, bodies, line.end_a).to_space(line.end_a.at);
  const Vec3 xb = start_pose(c, bodies, line.end_b).to_space(line.end_b.at);
  const std::optional<Vec3> held_a = a ? std::optional(xa) : std::nullopt;
  const std::optional<Vec3> held_b = b ? std::optional(xb) : std::nullopt;
  if (line.start == Start::points) return through_points(line.points, held_a, held_b, mesh, span);
  if (line.start == Start::other_run) return as_previous(*line.previous_shape, held_a, held_b, mesh, span);
  if (line.start == Start::automatic)
    if (auto laid = line_over_supports(c, line, bodies, mesh, span)) return *std::move(laid);
  const auto straight = [&] {
    if (a && b) return along({xa, xb}, mesh, span);
    const model::End& e = a ? line.end_a : line.end_b;
    const Vec3 d =
        e.direction ? Vec3(start_pose(c, bodies, e).rotation * *e.direction) : Vec3(0, 0, a ? -1 : 1);
    return a ? along({xa, xa + span.length * d}, mesh, span) : along({xb - span.length * d, xb}, mesh, span);
  };
  const auto sections = catenary_sections(c, line);
  // Without loads any shape of the correct length is an equilibrium. Users expect a straight one.
  const bool loaded = std::any_of(sections.begin(), sections.end(), [](const CatenarySection& s) {
    return !s.load.isZero(0) || !s.end_load.isZero(0);
  });
  if ((a || b) && (line.start == Start::straight || !loaded)) return straight();
  if (!a && !b) throw InputError(advice::no_start_shape(line.name));
  if (a != b && line.start == Start::automatic && stands(c, line, sections, span.length)) return straight();
  const auto closed_form = [&]() -> std::optional<LineStart> {
    try {
      if (a && b) {
        auto shape = on_bed(c, line, xa, xb, sections, mesh, span);
        return shape ? *std::move(shape) : from_catenary(catenary(xa, xb, sections), mesh, span);
      }
      return from_catenary(a ? catenary_free_b(xa, sections) : catenary_free_a(xb, sections), mesh, span);
    } catch (const std::invalid_argument&) {
      return {};  // slack, so that the shape is not determined
    } catch (const std::runtime_error&) {
      return {};
    }
  };
  std::optional<LineStart> shape = closed_form();
  const bool hangs = shape && !crosses_bed_or_surface(c, line, shape->x) && ((a && b) || !folded(shape->x));
  if (shape && a && b && line.start == Start::automatic && is_beam(c, line, sections, span.length, shape->x))
    return straight();
  if (shape && (line.start != Start::automatic || (hangs && !streams(c, line)))) return *std::move(shape);
  if (shape && a && b && lay(c, sections, mesh, span, *shape)) return *std::move(shape);
  const std::vector<Vec3> x = shape ? shape->x : straight().x;
  if (!hangs && !(a && b)) return lay_free(c, line, bodies, sections, mesh, span, x);
  return through(flexible_start(c, line, mesh, span, x, Vec3::Zero()));
}

}  // namespace hawser
