// Checks of links: their ends, and whether they have an effect.
#include <fmt/format.h>

#include <optional>

#include "hawser/model/body_motion.hpp"
#include "hawser/model/check.hpp"

namespace hawser::model {
namespace {

// True if the end has prescribed motion: a point of space or of a body without unknowns.
bool prescribed(const Case& c, const LinkEnd& e) {
  const int body = c.body_index(e.body);
  return e.line.empty() && !c.floats(body) && !c.rides(body);
}

void check_end(const Case& c, const LinkEnd& e, const std::string& key, const Issues& issue) {
  if (e.line.empty()) return;
  const double length = length_of(c.line(e.line));
  if (e.arc > length * (1 + kArcTolerance))
    issue(key + ".at", "arc length {:.6g} m is beyond the end of line '{}', which is {:.6g} m long", e.arc,
          e.line, length);
}

// Initial position of the end; none for ends on lines and on bodies that ride on lines.
std::optional<Vec3> start_position(const Case& c, const LinkEnd& e) {
  const int body = c.body_index(e.body);
  if (!e.line.empty() || c.rides(body)) return std::nullopt;
  return body < 0 ? e.at : pose_at_start(c.bodies[body]).to_space(e.at);
}

}  // namespace

void check_links(const Case& c, const Issues& issue) {
  for (const Link& l : c.links) {
    const std::string key = "links." + l.name;
    check_end(c, l.end_a, key + ".end_a", issue);
    check_end(c, l.end_b, key + ".end_b", issue);
    const bool spring = l.law.stiffness > 0 || l.law.spring;
    const bool damper = l.law.damping > 0 || l.law.damper;
    if (!spring && !damper)
      issue(key, "does nothing: give it a 'stiffness', a 'force_table', a 'damping' or a 'damping_table'");
    if (l.law.tension_only && !spring)
      issue(key + ".tension_only",
            "a damper alone has no slack state: give it a 'stiffness' or a 'force_table'");
    if (prescribed(c, l.end_a) && prescribed(c, l.end_b))
      issue(key,
            "the motion of both ends is prescribed, so the link has no effect: fix an end to a line or to a "
            "body with 'floating' or 'on'");
    if (!l.end_a.body.empty() && l.end_a.body == l.end_b.body)
      issue(key + ".end_b", "both ends are on body '{}', which is rigid", l.end_a.body);
    if (!l.end_a.line.empty() && l.end_a.line == l.end_b.line && l.end_a.arc == l.end_b.arc)
      issue(key + ".end_b", "both ends are at the same point of line '{}'", l.end_a.line);
    const std::optional<Vec3> a = start_position(c, l.end_a);
    const std::optional<Vec3> b = start_position(c, l.end_b);
    if (!l.rest_given && a && b && *a == *b)
      issue(key,
            "its ends are drawn at the same point, so that its length is 0: give it a 'rest_length', which "
            "may be 0, or move its ends apart");
  }
}

}  // namespace hawser::model
