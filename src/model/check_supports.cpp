// Checks that lines can lie on their supports: boxes in sequence, the tensioner before the first and on its
// supporting side.
#include <fmt/format.h>

#include <cmath>
#include <set>
#include <variant>

#include "hawser/model/body_motion.hpp"
#include "hawser/model/check.hpp"

namespace hawser::model {
namespace {

constexpr double kSteep = 0.25;  // up to the first roller: tangent of the largest plausible turn

RigidPose pose_of_end(const Case& c, const End& e) {
  const int body = c.body_index(e.carrier);
  return body < 0 ? RigidPose{} : pose_at_start(c.bodies[body]);
}

RigidPose pose_of(const Case& c, const SupportBox& b) {
  const int body = c.body_index(b.body);
  return body < 0 ? RigidPose{} : pose_at_start(c.bodies[body]);
}

void check_names(const Case& c, const Issues& issue) {
  std::set<std::string> names;
  for (const HistoryPoint& h : c.output.histories) names.insert(h.name);
  for (const Clearance& k : c.output.clearances) names.insert(k.name);
  for (const SupportBox& b : c.supports)
    if (!names.insert(b.name).second)
      issue(b.key,
            "there is another history called '{}', and supports have one each; give the group or that "
            "history another name",
            b.name);
}

double roller_radius(const Case& c, const SupportBox& b) {
  return std::get<CylinderShape>(*c.volumes[b.first].shape).radius;
}

void check_start(const Case& c, const Line& line, const SupportBox& first, const Issues& issue) {
  const End* end = end_before(c, line, first);
  if (!end) return;
  const RigidPose pose = pose_of(c, first);
  const Vec3 to = pose.to_space(first.at) - end_position(c, *end);
  const Vec3 along = pose.rotation * first.along;
  const std::string which = fmt::format("lines.{}.end_{}", line.name, end == &line.end_a ? "a" : "b");
  if (end->direction) {  // direction of the line from end A to end B
    const Vec3 given =
        end->kind == EndKind::body ? pose_of_end(c, *end).rotation * *end->direction : *end->direction;
    if (given.dot(along) * (end == &line.end_a ? 1 : -1) < 0)
      return issue(which + ".direction",
                   "points away from support '{}', over which the line goes overboard from there; turn it "
                   "round, or the path",
                   first.name);
  }
  const double ahead = to.dot(along);
  const double below = to.dot(pose.rotation * first.up);
  if (!(ahead > 0))
    return issue(first.key,
                 "support '{}' lies {:.4g} m behind '{}', from which the line goes overboard over it; move "
                 "the end back or the supports ahead, or turn the path round",
                 first.name, -ahead, which);
  if (below > first.rise && below > kSteep * ahead)
    issue(which,
          "is {:.4g} m below where the line lies on support '{}', {:.4g} m further on: the line would start "
          "below the roller; raise the end or lower the support",
          below, first.name, ahead);
}

}  // namespace

Vec3 support_point(const Case& c, const SupportBox& box, const Vec3& x) {
  return pose_of(c, box).to_space(x);
}

const End* end_before(const Case& c, const Line& line, const SupportBox& first) {
  const Vec3 at = support_point(c, first, first.at);
  const End* best = nullptr;
  double nearest = HUGE_VAL;
  for (const End* e : {&line.end_a, &line.end_b})
    if (is_held(*e))
      if (const double d = (end_position(c, *e) - at).norm(); d < nearest) {
        best = e;
        nearest = d;
      }
  return best;
}

void check_supports(const Case& c, const Issues& issue) {
  check_names(c, issue);
  for (const Line& line : c.lines) {
    const SupportBox* before = nullptr;
    for (const SupportBox& b : c.supports) {
      if (b.line != line.name) continue;
      if (!c.contact.takes_part(line)) {
        issue(b.key,
              "line '{}' takes no part in contact and cannot lie on supports; name it in 'contact.lines'",
              line.name);
        break;
      }
      if (const int body = c.body_index(b.body); c.rides(body) && !c.bodies[body].ride->placed_in_space) {
        issue(b.key,
              "body '{}' rides on a line; name that line in 'on' of the group, and as 'body' the one in "
              "whose frame the boxes are given",
              b.body);
        break;
      }
      if ((pose_of(c, b).rotation * b.up).z() <= 0)
        issue(b.key,
              "support '{}' faces downwards, so that its rollers are above the line; turn the body or the "
              "path of the supports round",
              b.name);
      if (!before) {
        check_start(c, line, b, issue);
      } else {
        const Vec3 span = support_point(c, b, b.at) - support_point(c, *before, before->at);
        const Vec3 direction_before = pose_of(c, *before).rotation * before->along;
        const Vec3 direction = pose_of(c, b).rotation * b.along;
        if (!(span.dot(direction_before) > 0) || !(direction.dot(direction_before) > 0))
          issue(b.key,
                "support '{}' lies behind '{}', which the line passes before it; give supports and groups in "
                "the order in which it passes them",
                b.name, before->name);
        else if (const double radius = roller_radius(c, b), radius_before = roller_radius(c, *before);
                 span.norm() < radius + radius_before)
          issue(b.key,
                "its rollers of {:g} m in diameter and those of support '{}', {:g} m, overlap: the supports "
                "are {:.4g} m apart; is 'roller_diameter' in m?",
                2 * radius, before->name, 2 * radius_before, span.norm());
      }
      before = &b;
    }
  }
}

}  // namespace hawser::model
