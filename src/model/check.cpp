// Checks of time steps, tables, outputs, joints, bodies and shapes. Lines: check_line.cpp; contact:
// check_contact.cpp.
#include "hawser/model/check.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <stdexcept>

#include "hawser/math/symmetric.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/body_pairs.hpp"

namespace hawser::model {
namespace {

constexpr double kMostElements = 1e6;  // per case; each needs 5 to 10 KB in a run
constexpr double kMostSteps = 1e9;     // per run, a day or more; also the limit of outputs

void check_size_and_times(const Case& c, const Issues& issue) {
  double elements = 0;
  for (const Line& l : c.lines)
    for (const Section& s : l.sections) elements += s.elements;
  if (elements > kMostElements)
    issue("lines", "{:.3g} elements in all; the limit is {:.3g}", elements, kMostElements);
  if (!c.statics.enabled && !c.dynamics.enabled)
    issue("statics", "statics is off and there is no 'dynamics': nothing to run");
  const Dynamics& d = c.dynamics;
  if (d.enabled) {
    const auto check_order = [&](double a, const char* key, double b, const char* than) {
      if (a > 0 && b > 0 && a > b)
        issue(fmt::format("dynamics.{}", key), "{:g} s is longer than {} ({:g} s)", a, than, b);
    };
    check_order(d.step, "step", d.duration, "the duration");
    check_order(d.min_step, "min_step", d.duration, "the duration");
    check_order(d.min_step, "min_step", d.max_step, "max_step");
    check_order(d.min_step, "min_step", d.step, "step");
    check_order(d.step, "step", d.max_step, "max_step");
    const auto many = [&](double each, const char* key, const char* events) {
      if (each > 0 && d.duration > kMostSteps * each)
        issue(key, "{:g} s make {:.3g} {} of a run of {:g} s; the limit is {:.3g}", each, d.duration / each,
              events, d.duration, kMostSteps);
    };
    many(d.step, "dynamics.step", "steps");
    many(d.max_step, "dynamics.max_step", "steps");
    many(c.output.every, "output.every", "outputs");
  }
  // A spline is undefined beyond its rows, and extrapolation would be a guess.
  const auto covers = [&](const TableMotion& t, const std::string& key) {
    if (t.time.empty()) return;
    if (t.time.front() > 0) issue(key, "the first row is at {:g} s; the run starts at 0 s", t.time.front());
    if (d.enabled && t.time.back() < d.duration)
      issue(key, "the last row is at {:g} s; the run lasts {:g} s", t.time.back(), d.duration);
  };
  for (const Body& b : c.bodies) {
    const std::string key = fmt::format("bodies.{}.motion", b.name);
    if (const auto* t = std::get_if<TableMotion>(&b.motion)) covers(*t, key + ".table");
    if (b.drift) covers(b.drift->table, key + ".drift.table");
  }
  std::set<std::string> names{"energy", "solver", "time"};  // names used by the program
  for (const Line& line : c.lines) names.insert(line.name + " touchdown");
  for (const Link& l : c.links) names.insert(l.name + " link");
  for (std::size_t i = 0; i < c.output.histories.size(); ++i) {
    const HistoryPoint& h = c.output.histories[i];
    const std::string name = fmt::format("output.histories[{}]", i);
    if (!names.insert(h.name).second)
      issue(name, "there is another history called '{}'; give this one a 'name'", h.name);
    if (h.line.empty()) continue;
    const double length = length_of(c.line(h.line));
    const std::string key = fmt::format("output.histories[{}]", i);
    if (h.at > length * (1 + kArcTolerance))
      issue(key + ".at", "arc length {:.6g} m is beyond the end of line '{}', which is {:.6g} m long", h.at,
            h.line, length);
  }
  if (c.dynamics.enabled && c.output.statistics && c.output.statistics_from >= c.dynamics.duration)
    issue("output.statistics_from", "statistics would begin at {:g} s, but the run ends at {:g} s",
          c.output.statistics_from, c.dynamics.duration);
  for (std::size_t i = 0; i < c.output.clearances.size(); ++i) {
    const Clearance& k = c.output.clearances[i];
    const std::string key = fmt::format("output.clearances[{}]", i);
    if (!names.insert(k.name).second)
      issue(key, "there is another history called '{}'; give this one a 'name'", k.name);
    if (k.line == k.other_line) issue(key + ".other_line", "a line has no clearance to itself; name another");
  }
  for (const Volume& v : c.volumes)
    if (v.active_box && (v.active_box->lower.array() >= v.active_box->upper.array()).any())
      issue("volumes." + v.name + ".active.box", "the first corner must be below the second in x, y and z");
}

void check_joints(const Case& c, const Issues& issue) {
  struct Ends {
    int all = 0, bending = 0;
  };
  std::map<std::string, Ends> joined;
  for (const Line& l : c.lines) {
    const auto add = [&](const End& e, const Section& s) {
      if (e.kind != EndKind::joint) return;
      Ends& at = joined[e.carrier];
      ++at.all;
      at.bending += c.line_type(s.type).kind == LineKind::beam;
    };
    add(l.end_a, l.sections.front());
    add(l.end_b, l.sections.back());
    if (l.end_a.kind == EndKind::joint && l.end_b.kind == EndKind::joint &&
        l.end_a.carrier == l.end_b.carrier)
      issue("lines." + l.name + ".end_b.joint",
            "both ends are at joint '{}'; the ends of a line must be at different points", l.end_a.carrier);
  }
  for (const Joint& j : c.joints) {
    const auto& [ends, bending] = joined[j.name];
    const std::string key = "joints." + j.name;
    if (ends < 2) issue(key, "joins {} end of a line; it takes two", ends);
    if (bending > 1 && !j.rigid)
      issue(key,
            "joins {} lines that resist bending; at most one may, unless the joint is 'rigid: true'; the "
            "others need 'bending: false' in the section at the joint",
            bending);
  }
}

void check_rides(const Case& c, const Issues& issue) {
  for (const Body& b : c.bodies) {
    if (!b.ride) continue;
    const std::string key = "bodies." + b.name;
    const Line& line = c.line(b.ride->line);
    if (b.mass || b.motion.index() != 0 || b.drift)
      issue(key + ".on",
            "a body that rides on a line has no motion or mass of its own; give the line a mass there "
            "('lines.<line>.masses')");
    if (!(b.ride->at >= 0 && b.ride->at <= length_of(line)))
      issue(key + ".on.at", "line {} ends at {:.6g} m of arc length", line.name, length_of(line));
    else if (c.line_type(section_at(line, b.ride->at).type).kind == LineKind::cable)
      issue(key + ".on.at",
            "line {} does not resist bending there, so the rotation of the body is not defined", line.name);
    for (const auto& [l, end] : line_ends_at(c, b))
      issue("lines." + l.name + (&end == &l.end_a ? ".end_a" : ".end_b") + ".body",
            "body {} rides on a line; ends of lines are tied to lines at a joint", b.name);
  }
}

void check_mass_matrix(const MassMatrix& m, const std::string& key, const Issues& issue) {
  constexpr double kRounded = 1e-6;
  const Mat6& M = m.rows;
  for (int i = 0; i < 6; ++i)
    if (!(M(i, i) > 0)) {
      issue(key, "row {} has {:g} on the diagonal: mass and moments of inertia are above 0", i + 1, M(i, i));
      return;
    }
  // Scaling by the body's own diagonal makes kg and kg m² comparable.
  const Vec6 size = M.diagonal().cwiseSqrt();
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < i; ++j)
      if (std::abs(M(i, j) - M(j, i)) > kRounded * size[i] * size[j]) {
        issue(key, "is not symmetric: row {} has {:g} in column {}, and row {} has {:g} in column {}", i + 1,
              M(i, j), j + 1, j + 1, M(j, i), i + 1);
        return;
      }
  const Mat6 scaled = size.cwiseInverse().asDiagonal() * M * size.cwiseInverse().asDiagonal();
  if (const double smallest = eigenpairs(scaled).values[0]; !(smallest > 0))
    issue(key,
          "no body has this inertia: the matrix must be positive definite, and its smallest scaled "
          "eigenvalue is {:.3g}",
          smallest);
}

void check_floating(const Case& c, const Issues& issue) {
  bool any = false;
  for (const Body& b : c.bodies) {
    if (!b.mass) continue;
    any = true;
    if (b.mass->matrix) {
      check_mass_matrix(*b.mass->matrix, "bodies." + b.name + ".floating.mass_matrix.rows", issue);
      continue;
    }
    const Vec3 moments = eigenpairs(b.mass->tensor()).values;
    // Radii of gyration of ships are estimates; for platforms a violation is only a warning
    // (advice/input_platforms.cpp).
    const bool beyond = !b.mass->hydrodynamics && moments[2] > (1 + 1e-9) * (moments[0] + moments[1]);
    if (!(moments[0] > 0) || beyond)
      issue("bodies." + b.name + ".floating.inertia",
            "no body has the principal moments {:.6g}, {:.6g}, {:.6g} kg m²: each must be above 0 and at "
            "most the sum of the other two",
            moments[0], moments[1], moments[2]);
    if (!b.mass->in_water) continue;
    const std::string key = "bodies." + b.name + ".floating.in_water";
    if (!c.environment.water.present) issue(key, "there is no water: give 'environment: {{water: ...}}'");
    if (!b.mass->weight)
      issue(key, "adds the buoyancy of the body, so its weight must act as well: set 'weight: true'");
  }
  if (c.lines.empty() && !any)
    issue("lines", "required key is missing: there is no line, and no floating body either");
  for (const BodyPair& p : body_pairs(c)) {
    if (p.stiffness > 0) continue;
    const Volume& a = c.volumes[p.a];
    const Volume& b = c.volumes[p.b];
    const auto given_to_ball = [](const Volume& v) {
      return is_ball(v) && v.basis != StiffnessBasis::automatic;
    };
    if (given_to_ball(a) || given_to_ball(b))
      issue("volumes." + (given_to_ball(a) ? a : b).name + ".normal_stiffness",
            "a sphere touches other bodies as a ball, with a stiffness per_point only");
    else
      issue("volumes." + a.name + ".normal_stiffness",
            "contact of bodies needs a stiffness of '{}' or '{}': per_point (its corners and balls touch), "
            "per_length (its edges and bars) or per_area (its faces); if they never touch, exclude one of "
            "them from contact, also with lines: 'contact: {{volumes: [...]}}' lists those with contact",
            a.name, b.name);
  }
}

// Checks that involve several numbers of a shape.
void check_shape(const Case& c, const Volume& v, const Issues& issue) {
  const std::string key = "volumes." + v.name + ".shape.";
  if (const auto* s = std::get_if<CylinderShape>(&*v.shape); s && s->from == s->to)
    issue(key + "cylinder.to", "is the same point as 'from': a cylinder needs a length above 0");
  if (const auto* s = std::get_if<CapsuleShape>(&*v.shape); s && s->from == s->to)
    issue(key + "capsule.to", "is the same point as 'from'; give a sphere instead");
  if (const auto* s = std::get_if<TorusShape>(&*v.shape); s && s->tube_radius >= s->radius)
    issue(key + "torus.tube_radius", "{:g} m closes the hole of the ring; must be below the radius of {:g} m",
          s->tube_radius, s->radius);
  if (const auto* s = std::get_if<TubeShape>(&*v.shape)) check_tube(c, v, *s, issue);
}

}  // namespace

const Section& section_at(const Line& line, double arc) {
  double end = 0;
  for (const Section& s : line.sections)
    if (arc <= (end += s.length)) return s;
  return line.sections.back();
}

double length_of(const Line& line) {
  double length = 0;
  for (const Section& s : line.sections) length += s.length;
  return length;
}

double contact_diameter_of(const Case& c, const Line& line) {
  double largest = 0;
  for (const Section& s : line.sections) largest = std::max(largest, c.line_type(s.type).contact_diameter);
  return largest;
}

double expansion_of(const Case& c, const Line& line) {
  double sum = 0, at = 0;
  for (const Section& s : line.sections) {
    sum += s.length * thermal_strain(c.line_type(s.type), line, at, at + s.length);
    at += s.length;
  }
  return sum;
}

std::vector<EndAtBody> line_ends_at(const Case& c, const Body& body) {
  std::vector<EndAtBody> out;
  for (const Line& line : c.lines)
    for (const End* e : {&line.end_a, &line.end_b})
      if (e->kind == EndKind::body && e->carrier == body.name) out.push_back({line, *e});
  return out;
}

std::vector<std::vector<EndAtBody>> line_ends_by_body(const Case& c) {
  std::vector<std::vector<EndAtBody>> out(c.bodies.size());
  for (const Line& line : c.lines)
    for (const End* e : {&line.end_a, &line.end_b})
      if (const int body = e->kind == EndKind::body ? c.body_index(e->carrier) : -1; body >= 0)
        out[body].push_back({line, *e});
  return out;
}

bool is_held(const End& end) { return end.kind == EndKind::anchor || end.kind == EndKind::body; }

Vec3 end_position(const Case& c, const End& end) {
  if (end.kind == EndKind::anchor || end.kind == EndKind::joint) return end.at;
  const int i = c.body_index(end.carrier);
  if (i < 0) throw std::out_of_range("no body '" + end.carrier + "'");
  return pose_at_start(c.bodies[i]).to_space(end.at);
}

std::vector<Issue> check(const Case& c) {
  std::vector<Issue> issues;
  const Issues issue(issues);
  for (const Line& l : c.lines) check_line(c, l, issue);
  for (const Volume& v : c.volumes)
    if (v.shape) check_shape(c, v, issue);
  check_size_and_times(c, issue);
  check_joints(c, issue);
  check_rides(c, issue);
  check_floating(c, issue);
  check_platforms(c, issue);
  check_contact(c, issue);
  check_supports(c, issue);
  check_links(c, issue);
  check_events(c, issue);
  return issues;
}

}  // namespace hawser::model
