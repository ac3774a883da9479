// `supports`: positions of the boxes of a ramp or stinger, and the cylinders of their rollers.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hawser/io/case_values.hpp"
#include "hawser/kernels/support_path.hpp"
#include "hawser/math/segment.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/nearest.hpp"

namespace hawser::io {
namespace {

using model::refuse;
using model::refuse_key;
using model::SupportBox;
using model::Value;

// Penetration, as a fraction of the line's radius, at which the given stiffness of rollers applies.
constexpr double kNominal = 0.01;

// Stiffness per length of line equivalent to `stiffness` [N/m] of a roller at penetration d: the gap of a
// line of radius r across a roller of radius R is parabolic, and below d over a length of 2 sqrt(2 (R + r)
// d).
double per_length(double stiffness, double roller, double line) {
  const double d = kNominal * line;
  return 0.75 * stiffness / std::sqrt(2 * (roller + line) * d);
}

class Group {
 public:
  Group(const std::string& name, const Value& v, model::Case& c)
      : name_(name), v_(v), c_(c), line_(the_line()) {
    radius_ = 0.5 * model::contact_diameter_of(c, line_);
  }

  void read() {
    for (const Value& e : v_["boxes"].items) places(e);
    std::stable_sort(places_.begin(), places_.end(),
                     [](const PlacedSupport& a, const PlacedSupport& b) { return a.station < b.station; });
    if (!v_.has("path")) turn_along_points();
    for (const PlacedSupport& p : places_) box(p);
  }

 private:
  struct PlacedSupport {
    const Value* entry;
    double station;  // m along the path; for points their number
    PathPoint at;
  };

  const model::Line& the_line() const {
    if (v_.has("line")) return c_.line(v_["line"].text);
    if (c_.lines.size() != 1)
      refuse_key(
          v_, v_.where + ".line",
          "required key is missing: the case has {} lines; state which of them is laid over these supports",
          c_.lines.size());
    return c_.lines.front();
  }

  void places(const Value& e) {
    if (!places_.empty() && e.has("points") != places_.front().entry->has("points"))
      refuse(e,
             "has 'points' where other boxes of the group have 'at', or the other way round; make it a group "
             "of its own");
    if (const Value* points = e.find("points")) {
      if (v_.has("path"))
        refuse(*points,
               "the group has a 'path', along which boxes have their place by 'at'; remove one of the two");
      for (const Value& p : points->items)
        places_.push_back({&e, static_cast<double>(places_.size()), {as_vec3(p)}});
      return;
    }
    const Value* path = v_.find("path");
    if (!path) refuse(e["at"], "is a length along 'path', which the group has not; give it, or 'points'");
    std::vector<PathSegment> segments;
    for (const Value& s : (*path)["segments"].items)
      segments.push_back({s["length"].number, s.has("radius") ? s["radius"].number : 0});
    const Vec3 direction = as_vec3((*path)["direction"]).stableNormalized();
    if (!(direction.norm() > 0)) refuse((*path)["direction"], "[0, 0, 0] is no direction");
    if (std::hypot(direction.x(), direction.y()) < 1e-6)
      refuse((*path)["direction"],
             "is vertical: a pipe does not lie on rollers there; give the way that it goes overboard");
    const SupportPath along(as_vec3((*path)["from"]), direction, segments);
    const Value& at = e["at"];
    const auto add = [&](const Value& s) {
      if (s.number > along.length() * (1 + 1e-9))
        refuse_key(s, e.where + ".at",
                   "a box {:g} m along the path is beyond its end at {:g} m; lengthen the last of its "
                   "segments or move the box",
                   s.number, along.length());
      PathPoint p = along.at(s.number);
      if (p.dip > 0.5 * std::numbers::pi * (1 - 1e-9))
        refuse_key(s, e.where + ".at",
                   "the path has turned by {:.3g} degrees below the horizontal there, and must stay below "
                   "90; make its arcs shorter or their radius larger",
                   p.dip * 180 / std::numbers::pi);
      p.at += e["above_path"].number * p.up;
      places_.push_back({&e, s.number, p});
    };
    if (at.kind == Value::Kind::list)
      for (const Value& s : at.items) add(s);
    else
      add(at);
  }

  // Directions at points without a given path: tangent of the circle through a point and its neighbours.
  void turn_along_points() {
    std::vector<Vec3> points;
    for (const PlacedSupport& p : places_) points.push_back(p.at.at);
    if (points.size() < 2)
      refuse(v_,
             "one point does not define the direction of the pipe; give two points or more, or a 'path' and "
             "'at'");
    for (size_t i = 0; i < points.size(); ++i) {
      PlacedSupport& p = places_[i];
      if (i > 0 && !((points[i] - points[i - 1]).norm() > 0))
        refuse_key(*p.entry, p.entry->where + ".points", "point {} is the same as the one before it", i + 1);
      p.at.along = direction_at(points, i);
      if (std::hypot(p.at.along.x(), p.at.along.y()) < 1e-6)
        refuse_key(*p.entry, p.entry->where + ".points",
                   "the pipe would go straight up or down at point {}, where it does not lie on rollers",
                   i + 1);
      p.at.up = across(p.at.along);
    }
  }

  enum class Shape { V, flat, U, box };
  static Shape shape_of(const Value& e) {
    const Value& type = e["type"];
    return type.is("V") ? Shape::V : type.is("flat") ? Shape::flat : type.is("box") ? Shape::box : Shape::U;
  }

  // Refuses keys that a support of this type has not, or needs.
  static void check_keys(const Value& e, Shape shape) {
    const auto only = [&](const char* key, bool required, const char* types) {
      if (e.has(key) && !required)
        refuse(e[key], "a support of type '{}' has none; remove it, or choose {}", e["type"].text, types);
      if (!e.has(key) && required)
        refuse_key(e, e.where + "." + key, "required key is missing: a support of type '{}' needs it",
                   e["type"].text);
    };
    only("angle_deg", shape == Shape::V, "type 'V'");
    only("side_height", shape == Shape::U || shape == Shape::box, "type 'U' or 'box'");
  }

  void box(const PlacedSupport& p) {
    const Value& e = *p.entry;
    const Shape shape = shape_of(e);
    check_keys(e, shape);
    SupportBox b;
    b.name = fmt::format("{} {}", name_, ++count_);
    b.key = e.where;
    b.line = line_.name;
    if (v_.has("body")) b.body = v_["body"].text;
    b.along = p.at.along;
    b.up = p.at.up;
    const double r = 0.5 * e["roller_diameter"].number;
    const double length = e["roller_length"].number;
    const double angle = shape == Shape::V ? e["angle_deg"].number : 0;
    if (const double needed = (r + radius_) * std::tan(angle); length < needed)
      refuse(e["roller_length"],
             "is {:g} m, but a line of radius {:g} m lies {:.3g} m along the rollers of a V of {:.3g} deg: "
             "it would hang between their ends; make them longer",
             length, radius_, needed, angle * 180 / M_PI);
    b.rise = (r + radius_) / std::cos(angle);
    b.at = p.at.at + b.rise * b.up;
    if (const Value* lines = v_.find("on")) b.body = carry(b, *lines);
    b.half_width = shape == Shape::V ? length * std::cos(angle) : 0.5 * length;
    b.first = c_.volumes.size();
    if (shape == Shape::V)
      add_rollers_of_V(p, b);
    else
      add_rollers_around(p, shape, b);
    c_.supports.push_back(std::move(b));
  }

  void add_roller(SupportBox& b, const Value& e, const char* name, const Vec3& from, const Vec3& to) {
    b.rollers.emplace_back(name);
    c_.volumes.push_back(volume(b, e, CylinderShape{from, to, 0.5 * e["roller_diameter"].number}));
  }

  void add_rollers_of_V(const PlacedSupport& p, SupportBox& b) {
    const Value& e = *p.entry;
    const double length = e["roller_length"].number;
    const double angle = e["angle_deg"].number;
    const Vec3 left = b.left();
    const Vec3 base = p.at.at;
    for (const double side : {1., -1.})
      add_roller(b, e, side > 0 ? "left" : "right", base,
                 base + length * (std::cos(angle) * side * left + std::sin(angle) * b.up));
  }

  // A roller below the line, with two beside it for a U, and one above for a box.
  void add_rollers_around(const PlacedSupport& p, Shape shape, SupportBox& b) {
    const Value& e = *p.entry;
    const double r = 0.5 * e["roller_diameter"].number;
    const double length = e["roller_length"].number;
    const Vec3 left = b.left();
    const Vec3 base = p.at.at;
    add_roller(b, e, "below", base + 0.5 * length * left, base - 0.5 * length * left);
    if (shape == Shape::flat) return;
    const bool closed = shape == Shape::box;
    const double height = e["side_height"].number;
    const double top = height + 2 * r;
    for (const double side : {1., -1.}) {
      const Vec3 foot = base + side * (0.5 * length + r) * left;
      add_roller(b, e, side > 0 ? "left" : "right", foot, foot + (closed ? top : r + height) * b.up);
    }
    if (closed && height < 2 * radius_)
      refuse(e["side_height"],
             "a clear height of {:g} m is less than the contact diameter of line '{}', {:g} m", height,
             line_.name, 2 * radius_);
    if (closed)
      add_roller(b, e, "above", base + 0.5 * length * left + top * b.up,
                 base - 0.5 * length * left + top * b.up);
    if (length < 2 * radius_)
      refuse(e["roller_length"],
             "a clear width of {:g} m is less than the contact diameter of line '{}', {:g} m", length,
             line_.name, 2 * radius_);
  }

  // Adds a body that carries box b, attached to the nearest point of the lines of a structure, each straight
  // between its ends, with the axes of the group's body at the start. Returns its name.
  std::string carry(const SupportBox& b, const Value& lines) {
    RigidPose pose;
    if (const int body = c_.body_index(b.body); body >= 0) {
      if (c_.rides(body))
        refuse(v_["body"],
               "body '{}' rides on a line itself; name the body in whose frame the supports are drawn",
               b.body);
      pose = model::pose_at_start(c_.bodies[body]);
    }
    const Vec3 place = pose.to_space(b.at - b.rise * b.up);
    model::Body o;
    o.name = b.name;
    o.position = pose.position;
    o.rotation = log_so3(pose.rotation);
    if (c_.body_index(o.name) >= 0)
      refuse(v_, "the body of one of its boxes is called '{}' as another is; give the group another name",
             o.name);
    double nearest = HUGE_VAL;
    for (const Value& name : lines.items) {
      const model::Line& line = c_.line(name.text);
      if (line.name == line_.name || line.end_a.kind == model::EndKind::free ||
          line.end_b.kind == model::EndKind::free)
        refuse_key(name, v_.where + ".on",
                   "line '{}' {}; name beams with both ends at joints, anchors or bodies", line.name,
                   line.name == line_.name ? "is laid over these supports itself" : "has a free end");
      const Vec3 a = model::end_position(c_, line.end_a);
      const Vec3 end = model::end_position(c_, line.end_b);
      const double fraction = nearest_fraction(place, a, end);
      const double distance = (a + fraction * (end - a) - place).norm();
      if (distance < nearest) {
        nearest = distance;
        o.ride = model::Ride{line.name, fraction * model::length_of(line), true};
      }
    }
    c_.bodies.push_back(std::move(o));
    return c_.bodies.back().name;
  }

  model::Volume volume(const SupportBox& b, const Value& e, const CylinderShape& shape) const {
    model::Volume o;
    o.name = b.name + " " + b.rollers.back();
    for (const model::Volume& other : c_.volumes)
      if (other.name == o.name)
        refuse(v_, "one of its rollers is called '{}' as another volume is; give the group another name",
               o.name);
    model::take(e, o);
    o.shape = shape;
    o.body = b.body;
    o.roller = true;
    if (const Value& k = e["normal_stiffness"]; !k.is("auto")) {
      o.basis = model::StiffnessBasis::per_length;
      o.normal_stiffness = per_length(k.number, shape.radius, radius_);
    }
    return o;
  }

  const std::string name_;
  const Value& v_;
  model::Case& c_;
  const model::Line& line_;
  double radius_ = 0;  // m, of the line
  std::vector<PlacedSupport> places_;
  int count_ = 0;
};

}  // namespace

void read_supports(const Value& supports, model::Case& c) {
  for (size_t i = 0; i < supports.items.size(); ++i) Group(supports.keys[i], supports.items[i], c).read();
}

}  // namespace hawser::io
