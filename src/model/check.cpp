// Checks of lines (ends, span, start shape, soil, temperature, loads), of time steps, tables and outputs, of
// joints, bodies and shapes; those of contact are in check_contact.cpp.
#include "hawser/model/check.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "hawser/model/bed.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/body_pairs.hpp"

namespace hawser::model {
namespace {

constexpr double kLargestStrain = 0.10;     // to reach between held ends; more is a misprint, not a taut line
constexpr double kLargestExpansion = 0.05;  // by heat; ropes and rubber stay below
constexpr double kArcTolerance = 1e-9;      // of the line's length
constexpr double kMostWeight = 100;    // of a line in air, in EA: soft rubber under water has 1 at the most
constexpr double kMostElements = 1e6;  // of a case; each takes 5 to 10 KB in a run

class LineCheck {
 public:
  LineCheck(const Case& c, const Line& line, std::vector<Issue>& issues)
      : c_(c), line_(line), key_("lines." + line.name), length_(length_of(line)), issues_(issues) {}

  void run() {
    check_weight();
    check_end(line_.end_a, line_.sections.front(), "end_a");
    check_end(line_.end_b, line_.sections.back(), "end_b");
    check_start();
    if (check_temperature()) check_span();
    for (std::size_t i = 0; i < line_.masses.size(); ++i)
      check_arc(line_.masses[i].at, fmt::format("masses[{}].at", i));
    check_loads();
    for (std::size_t i = 0; i < line_.bend_stiffeners.size(); ++i)
      check_stiffener(line_.bend_stiffeners[i], fmt::format("bend_stiffeners[{}]", i));
    for (std::size_t i = 0; i < line_.buried.size(); ++i) check_buried(i, fmt::format("buried[{}]", i));
    if (line_.target) check_target(*line_.target);
  }

 private:
  template <class... Args>
  void issue(const std::string& key, fmt::format_string<Args...> text, Args&&... args) {
    issues_.push_back(
        {key.empty() ? key_ : key_ + "." + key, fmt::format(text, std::forward<Args>(args)...)});
  }

  bool held(const End& e) const { return e.kind != EndKind::free; }

  void check_weight() {
    for (const Section& s : line_.sections) {
      const LineType& type = c_.line_type(s.type);
      const double weight = type.mass_per_length * s.length * c_.environment.gravity;
      if (weight > kMostWeight * type.EA)
        issue("",
              "{:g} m of line type '{}' weigh {:.3g} N, which an EA of {:.3g} N cannot carry: check its "
              "mass_per_length and EA",
              s.length, s.type, weight, type.EA);
    }
  }

  void check_end(const End& e, const Section& section, const std::string& key) {
    if (e.kind == EndKind::joint && (e.clamped || e.rotational_stiffness > 0))
      return issue(key + (e.clamped ? ".clamped" : ".rotational_stiffness"),
                   "ends turn freely at a joint; remove it");
    if (held(e) && e.rotational_stiffness > 0) check_spring(e, section, key);
    if (!held(e) || !e.clamped) return;
    if (c_.line_type(section.type).kind == LineKind::cable)
      issue(key + ".clamped", "a line of type '{}' has no bending stiffness here and cannot be clamped",
            section.type);
    else if (!e.direction)
      issue(key + ".clamped", "a clamped end needs a direction: the tangent from end A to end B");
  }

  void check_spring(const End& e, const Section& section, const std::string& key) {
    if (e.clamped)
      issue(key + ".rotational_stiffness", "a clamped end does not turn; remove one of them");
    else if (c_.line_type(section.type).kind == LineKind::cable)
      issue(key + ".rotational_stiffness",
            "a line of type '{}' has no bending stiffness here to turn against", section.type);
    else if (!e.direction)
      issue(key + ".rotational_stiffness",
            "needs a direction, which the spring turns the end to: the tangent from end A to end B");
  }

  void check_start() {
    const int ends = held(line_.end_a) + held(line_.end_b);
    const bool directed = line_.end_a.direction || line_.end_b.direction;
    switch (line_.start) {
      case Start::points:
        return check_points();
      case Start::catenary:
        if (ends < 2) issue("start", "a catenary hangs between two held ends, but this line has {}", ends);
        break;
      case Start::hanging:
        if (ends != 1) issue("start", "a hanging line has one held end, but this line has {}", ends);
        break;
      case Start::straight:
        if (ends == 0 || (ends == 1 && !directed))
          issue("start",
                "a straight start needs two held ends, or one with a direction; give start: {{points: ...}}");
        break;
      case Start::other_run:
        break;
      case Start::automatic:
        if (ends == 0)
          issue("", "both ends are free: give start: {{points: [[x, y, z], ...]}} to say where it lies");
    }
    check_held();
  }

  void check_held() {
    if (held(line_.end_a) || held(line_.end_b) || !c_.statics.enabled || held_by_friction(c_, line_)) return;
    issue("",
          "both ends are free, so there is no static equilibrium; give statics: false, or where it lies "
          "('start') on a volume with friction and statics: {{contact_friction: true}}");
  }

  void check_points() {
    double laid = 0;
    for (std::size_t i = 1; i < line_.points.size(); ++i) {
      const double d = (line_.points[i] - line_.points[i - 1]).norm();
      if (d <= 0) issue(fmt::format("start.points[{}]", i), "is the same point as the one before it");
      laid += d;
    }
    if (std::abs(laid - length_) > kLargestStrain * length_)
      issue("start.points",
            "this polyline is {:.6g} m long, but the line is {:.6g} m; they may differ by {:g} %", laid,
            length_, 100 * kLargestStrain);
    check_point(line_.end_a, line_.points.front(), 0);
    check_point(line_.end_b, line_.points.back(), line_.points.size() - 1);
    check_held();
  }

  void check_point(const End& e, const Vec3& p, std::size_t i) {
    if (!held(e)) return;
    const double gap = (end_position(c_, e) - p).norm();
    if (gap > 1e-3 * length_)
      issue(fmt::format("start.points[{}]", i), "is {:.4g} m away from the line's end, which is held", gap);
  }

  // A taut line may be a little shorter than its span; it stretches.
  void check_span() {
    if (!held(line_.end_a) || !held(line_.end_b)) return;
    if (line_.end_a.kind == EndKind::joint || line_.end_b.kind == EndKind::joint) return;  // it moves
    const double span = (end_position(c_, line_.end_b) - end_position(c_, line_.end_a)).norm();
    const double natural = length_ + expansion_of(c_, line_), strain = (span - natural) / natural;
    if (!(strain < kLargestStrain))
      issue("sections",
            "the line is {:.6g} m long{} but its ends are {:.6g} m apart at t = 0; reaching that takes a "
            "strain of {:.3g} %, and the limit is {:g} %",
            natural, natural == length_ ? "" : " at its temperature", span, 100 * strain,
            100 * kLargestStrain);
  }

  void check_arc(double s, const std::string& key) {
    if (s > length_ * (1 + kArcTolerance))
      issue(key, "arc length {:.6g} m is beyond the end of the line, which is {:.6g} m long", s, length_);
  }

  void check_stiffener(const BendStiffener& b, const std::string& key) {
    check_arc(b.at, key + ".at");
    const double tip = b.towards_a ? b.at - b.rows.back().first : b.at + b.rows.back().first;
    double start = 0;
    for (const Section& s : line_.sections) {
      const double overlap =
          std::min(start + s.length, std::max(b.at, tip)) - std::max(start, std::min(b.at, tip));
      if (overlap > kArcTolerance * length_ && c_.line_type(s.type).kind == LineKind::cable)
        return issue(key, "it is on a section of '{}', which does not resist bending", s.type);
      start += s.length;
    }
  }

  void check_buried(std::size_t i, const std::string& key) {
    const Buried& b = line_.buried[i];
    const double near = kArcTolerance * length_;
    if (!c_.environment.seabed.present)
      issue(key, "a line lies in the soil of a seabed, but there is no 'environment.seabed'");
    check_arc(b.from, key + ".from");
    check_arc(b.to, key + ".to");
    if (b.to <= b.from)
      issue(key + ".to", "a stretch from {:.6g} m to {:.6g} m is none; 'to' must be beyond 'from'", b.from,
            b.to);
    else if (i > 0 && b.from < line_.buried[i - 1].to - near)
      issue(key + ".from", "{:.6g} m is within the stretch before, which goes to {:.6g} m", b.from,
            line_.buried[i - 1].to);
    if (line_.start != Start::automatic && line_.start != Start::catenary && line_.start != Start::hanging)
      return;
    const bool at_a = b.from <= near, at_b = b.to >= length_ - near;
    if (!held(line_.end_a) || !held(line_.end_b) || line_.start == Start::hanging || at_a == at_b)
      issue(
          key,
          "nothing says where this stretch lies: give 'start' as straight or as points, or two held ends of "
          "which it begins at one");
  }

  void check_target(const LengthTarget& t) {
    using Kind = LengthTarget::Kind;
    const bool bed = t.kind == Kind::touchdown || t.kind == Kind::laid_length;
    if (!c_.statics.enabled)
      issue("target", "is met in static equilibrium, which this case leaves out ('statics: false')");
    if (bed && !c_.environment.seabed.present)
      issue("target", "is about the seabed, but there is no 'environment.seabed'");
    if (!bed && !held(t.at_a ? line_.end_a : line_.end_b))
      issue("target", "end {} is free: it has no tension and no angle to be met", t.at_a ? "A" : "B");
  }

  // K, the largest either way over the arc [from, to], m.
  double most_change(double from, double to) const {
    double most = 0;
    for (const double s : {from, to}) most = std::max(most, std::abs(mean_temperature_change(line_, s, s)));
    for (const auto& [s, change] : line_.temperature_change)
      if (s > from && s < to) most = std::max(most, std::abs(change));
    return most;
  }

  bool check_temperature() {
    const auto& rows = line_.temperature_change;
    if (rows.empty()) return true;
    const std::size_t before = issues_.size();
    const std::string key = "temperature_change";
    if (rows.front().first < -kArcTolerance * length_)
      issue(key + "[0]", "arc length {:.6g} m is before end A", rows.front().first);
    for (std::size_t i = 0; i < rows.size(); ++i) check_arc(rows[i].first, fmt::format("{}[{}]", key, i));
    bool expands = false;
    double from = 0;
    for (const Section& s : line_.sections) {
      const double alpha = c_.line_type(s.type).thermal_expansion, most = most_change(from, from + s.length);
      from += s.length;
      expands |= alpha != 0;
      if (std::abs(alpha) * most > kLargestExpansion) {
        issue(key, "by {:g} K '{}' gets a strain of {:.3g} %; the limit is {:g} %", most, s.type,
              100 * std::abs(alpha) * most, 100 * kLargestExpansion);
        return false;
      }
    }
    if (!expands)
      issue(key, "none of the line's types has 'thermal_expansion', so nothing comes of it; give it to '{}'",
            line_.sections.front().type);
    return issues_.size() == before;
  }

  const LineType& type_at(double s) const {
    double end = 0;
    for (const Section& sec : line_.sections) {
      end += sec.length;
      if (s <= end) return c_.line_type(sec.type);
    }
    return c_.line_type(line_.sections.back().type);
  }

  void check_loads() {
    // Keys count the loads in file order, which `order` keeps.
    for (const DistributedLoad& q : line_.loads) {
      const std::string key = fmt::format("loads[{}]", q.order);
      check_arc(q.from, key + ".from");
      check_arc(q.to, key + ".to");
      if (q.to >= 0 && q.to <= q.from)
        issue(key + ".to", "a load from {:.6g} m to {:.6g} m acts nowhere; 'to' must be beyond 'from'",
              q.from, q.to);
    }
    for (const PointLoad& p : line_.point_loads) {
      const std::string key = fmt::format("loads[{}]", p.order);
      check_arc(p.at, key + ".at");
      if (!p.moment.isZero(0) && type_at(p.at).kind == LineKind::cable)
        issue(key + ".moment", "a line without bending stiffness cannot carry a moment");
    }
  }

  const Case& c_;
  const Line& line_;
  std::string key_;
  double length_;
  std::vector<Issue>& issues_;
};

void check_whole(const Case& c, std::vector<Issue>& issues) {
  double elements = 0;
  for (const Line& l : c.lines)
    for (const Section& s : l.sections) elements += s.elements;
  if (elements > kMostElements)
    issues.push_back(
        {"lines", fmt::format("{:.3g} elements in all; the limit is {:.3g}", elements, kMostElements)});
  if (!c.statics.enabled && !c.dynamics.enabled)
    issues.push_back({"statics", "statics is off and there is no 'dynamics': nothing to run"});
  const Dynamics& d = c.dynamics;
  if (d.enabled) {
    const auto over = [&](double a, const char* key, double b, const char* than) {
      if (a > 0 && b > 0 && a > b)
        issues.push_back(
            {fmt::format("dynamics.{}", key), fmt::format("{:g} s is longer than {} ({:g} s)", a, than, b)});
    };
    over(d.step, "step", d.duration, "the duration");
    over(d.min_step, "min_step", d.duration, "the duration");
    over(d.min_step, "min_step", d.max_step, "max_step");
    over(d.min_step, "min_step", d.step, "step");
    over(d.step, "step", d.max_step, "max_step");
  }
  // A spline knows nothing beyond its rows, and going on with its last slope would be a guess.
  const auto covers = [&](const TableMotion& t, const std::string& key) {
    if (t.time.empty()) return;
    if (t.time.front() > 0)
      issues.push_back(
          {key, fmt::format("the first row is at {:g} s; the run starts at 0 s", t.time.front())});
    if (d.enabled && t.time.back() < d.duration)
      issues.push_back(
          {key, fmt::format("the last row is at {:g} s; the run lasts {:g} s", t.time.back(), d.duration)});
  };
  for (const Body& b : c.bodies) {
    const std::string key = fmt::format("bodies.{}.motion", b.name);
    if (const auto* t = std::get_if<TableMotion>(&b.motion)) covers(*t, key + ".table");
    if (b.drift) covers(b.drift->table, key + ".drift.table");
  }
  std::set<std::string> names{"energy", "solver", "time"};  // of the program's own
  for (const Line& line : c.lines) names.insert(line.name + " touchdown");
  for (std::size_t i = 0; i < c.output.histories.size(); ++i) {
    const HistoryPoint& h = c.output.histories[i];
    const std::string name = fmt::format("output.histories[{}]", i);
    if (!names.insert(h.name).second)
      issues.push_back(
          {name, fmt::format("there is another history called '{}'; give this one a 'name'", h.name)});
    if (!h.body.empty()) continue;
    const double length = length_of(c.lines[static_cast<std::size_t>(c.line_index(h.line))]);
    const std::string key = fmt::format("output.histories[{}]", i);
    if (h.at > length * (1 + kArcTolerance))
      issues.push_back(
          {key + ".at", fmt::format("arc length {:.6g} m is beyond the end of line '{}', which is {:.6g} "
                                    "m long",
                                    h.at, h.line, length)});
  }
  if (c.dynamics.enabled && c.output.statistics && c.output.statistics_from >= c.dynamics.duration)
    issues.push_back(
        {"output.statistics_from", fmt::format("statistics would begin at {:g} s, but the run ends at {:g} s",
                                               c.output.statistics_from, c.dynamics.duration)});
  for (std::size_t i = 0; i < c.output.clearances.size(); ++i) {
    const Clearance& k = c.output.clearances[i];
    const std::string key = fmt::format("output.clearances[{}]", i);
    if (!names.insert(k.name).second)
      issues.push_back(
          {key, fmt::format("there is another history called '{}'; give this one a 'name'", k.name)});
    if (k.line == k.other_line)
      issues.push_back({key + ".other_line", "a line has no clearance to itself; name another"});
  }
  for (const Volume& v : c.volumes)
    if (v.active_box && (v.active_box->lower.array() >= v.active_box->upper.array()).any())
      issues.push_back(
          {"volumes." + v.name + ".active.box", "the first corner must be below the second in x, y and z"});
}

std::string section_at(const Line& line, double at) {
  double end = 0;
  for (const Section& s : line.sections)
    if (at <= (end += s.length)) return s.type;
  return line.sections.back().type;
}

void check_joints(const Case& c, std::vector<Issue>& issues) {
  for (const Joint& j : c.joints) {
    int ends = 0, bending = 0;
    for (const Line& l : c.lines) {
      const auto here = [&](const End& e, const Section& s) {
        if (e.kind != EndKind::joint || e.body != j.name) return 0;
        bending += c.line_type(s.type).kind == LineKind::beam;
        return 1;
      };
      const int of_line = here(l.end_a, l.sections.front()) + here(l.end_b, l.sections.back());
      if (of_line == 2)
        issues.push_back({"lines." + l.name + ".end_b.joint",
                          fmt::format("both ends are at joint '{}'; a line goes somewhere", j.name)});
      ends += of_line;
    }
    const std::string key = "joints." + j.name;
    if (ends < 2) issues.push_back({key, fmt::format("joins {} end of a line; it takes two", ends)});
    if (bending > 1 && !j.rigid)
      issues.push_back(
          {key, fmt::format(
                    "joins {} lines that resist bending; at most one may, unless the joint is 'rigid: true'; "
                    "the others need 'bending: false' in the section at the joint",
                    bending)});
  }
}

void check_rides(const Case& c, std::vector<Issue>& issues) {
  for (const Body& b : c.bodies) {
    if (!b.on) continue;
    const std::string key = "bodies." + b.name;
    const Line& line = c.lines[static_cast<std::size_t>(c.line_index(b.on->line))];
    if (b.mass || b.motion.index() != 0 || b.drift)
      issues.push_back({key + ".on",
                        "a body that rides on a line has no motion or mass of its own; give the line a mass "
                        "there ('lines.<line>.masses')"});
    if (!(b.on->at >= 0 && b.on->at <= length_of(line)))
      issues.push_back({key + ".on.at",
                        fmt::format("line {} ends at {:.6g} m of arc length", line.name, length_of(line))});
    else if (c.line_type(section_at(line, b.on->at)).kind == LineKind::cable)
      issues.push_back(
          {key + ".on.at", fmt::format("line {} does not resist bending there, so that nothing says how the "
                                       "body is turned",
                                       line.name)});
    for (const Line& l : c.lines)
      for (const End* e : {&l.end_a, &l.end_b})
        if (e->kind == EndKind::body && e->body == b.name)
          issues.push_back(
              {"lines." + l.name + (e == &l.end_a ? ".end_a" : ".end_b") + ".body",
               fmt::format("body {} rides on a line; ends of lines are tied to lines at a joint", b.name)});
  }
}

void check_floating(const Case& c, std::vector<Issue>& issues) {
  bool any = false;
  for (const Body& b : c.bodies) {
    if (!b.mass) continue;
    any = true;
    const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(b.mass->tensor()).eigenvalues();  // ascending
    if (!(moments[0] > 0) || moments[2] > (1 + 1e-9) * (moments[0] + moments[1]))
      issues.push_back(
          {"bodies." + b.name + ".floating.inertia",
           fmt::format("no body has the principal moments {:.6g}, {:.6g}, {:.6g} kg m²: each must be "
                       "above 0 and at most the sum of the other two",
                       moments[0], moments[1], moments[2])});
  }
  if (c.lines.empty() && !any)
    issues.push_back({"lines", "required key is missing: there is no line, and no floating body either"});
  for (const BodyPair& p : body_pairs(c))
    if (!(p.stiffness > 0))
      issues.push_back(
          {"volumes." + c.volumes[p.a].name + ".normal_stiffness",
           fmt::format("contact of bodies needs a stiffness of '{}' or '{}': per_point (its corners "
                       "and balls touch), per_length (its edges) or per_area (its faces)",
                       c.volumes[p.a].name, c.volumes[p.b].name)});
}

// What the numbers of a shape cannot say one by one.
void check_shape(const Volume& v, std::vector<Issue>& issues) {
  const std::string key = "volumes." + v.name + ".shape.";
  if (const auto* s = std::get_if<CylinderShape>(&*v.shape); s && s->from == s->to)
    issues.push_back({key + "cylinder.to", "is the same point as 'from': a cylinder has a length"});
  if (const auto* s = std::get_if<CapsuleShape>(&*v.shape); s && s->from == s->to)
    issues.push_back({key + "capsule.to", "is the same point as 'from'; give a sphere instead"});
  if (const auto* s = std::get_if<TorusShape>(&*v.shape); s && s->tube_radius >= s->radius)
    issues.push_back({key + "torus.tube_radius",
                      fmt::format("{:g} m closes the hole of the ring; must be below the radius of {:g} m",
                                  s->tube_radius, s->radius)});
}

}  // namespace

double length_of(const Line& line) {
  double length = 0;
  for (const Section& s : line.sections) length += s.length;
  return length;
}

double expansion_of(const Case& c, const Line& line) {
  double sum = 0, at = 0;
  for (const Section& s : line.sections) {
    sum += s.length * thermal_strain(c.line_type(s.type), line, at, at + s.length);
    at += s.length;
  }
  return sum;
}

bool is_held(const End& end) { return end.kind == EndKind::anchor || end.kind == EndKind::body; }

Vec3 end_position(const Case& c, const End& end) {
  if (end.kind == EndKind::anchor || end.kind == EndKind::joint) return end.at;
  const int i = c.body_index(end.body);
  if (i < 0) throw std::out_of_range("no body '" + end.body + "'");
  return rigid_motion(c.bodies[static_cast<std::size_t>(i)]).at(0).to_space(end.at);
}

std::vector<Issue> check(const Case& c) {
  std::vector<Issue> issues;
  for (const Line& l : c.lines) LineCheck(c, l, issues).run();
  for (const Volume& v : c.volumes)
    if (v.shape) check_shape(v, issues);
  check_whole(c, issues);
  check_joints(c, issues);
  check_rides(c, issues);
  check_floating(c, issues);
  check_contact(c, issues);
  check_supports(c, issues);
  return issues;
}

}  // namespace hawser::model
