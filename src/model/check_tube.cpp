// Checks of the path and the radii of tubes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/count_of.hpp"
#include "hawser/geometry/primitives.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/check.hpp"

namespace hawser::model {
namespace {

// Relative rounding of lengths of legs and of angles.
constexpr double kRounding = 1e-9;

bool radii_fit(const TubeShape& s, const Issues& issue) {
  const std::size_t corners = s.path.size() - 2;
  const std::size_t given = s.bend_radius.size();
  if (corners == 0) {
    if (given > 0) issue("bend_radius", "has no effect: a path of two points is straight");
    return given == 0;
  }
  if (given == 0) {
    issue("bend_radius", "required key is missing: the path has {}",
          count_of(static_cast<long long>(corners), "corner"));
    return false;
  }
  if (given > 1 && given != corners) {
    issue("bend_radius", "{} radii for {} of the path; give one for each, or one for all", given,
          count_of(static_cast<long long>(corners), "corner"));
    return false;
  }
  for (std::size_t i = 0; i < given; ++i)
    if (!(s.bend_radius[i] > s.outer_radius())) {
      issue("bend_radius",
            "{:g} m is too tight: must be above the outer radius of {:g} m (inner radius and wall)",
            s.bend_radius[i], s.outer_radius());
      return false;
    }
  return true;
}

bool legs_fit(const TubeShape& s, const Issues& issue) {
  for (std::size_t i = 0; i + 1 < s.path.size(); ++i)
    if (s.path[i] == s.path[i + 1]) {
      issue("path", "points {} and {} are the same", i + 1, i + 2);
      return false;
    }
  const std::vector<TubeBend> bends = tube_bends(s);
  for (std::size_t i = 0; i < bends.size(); ++i)
    if (bends[i].turn > (1 - kRounding) * M_PI) {
      issue("path", "turns straight back at point {}; round a hairpin off at two points", i + 2);
      return false;
    }
  for (std::size_t i = 0; i + 1 < s.path.size(); ++i) {
    const double length = (s.path[i + 1] - s.path[i]).norm();
    const double before = i > 0 ? bends[i - 1].tangent : 0;
    const double after = i < bends.size() ? bends[i].tangent : 0;
    if (before + after <= length * (1 + kRounding)) continue;
    issue("path",
          "from point {} to point {} are {:g} m, and the bends there take {:g} m of it, "
          "r tan(half the turn) each; move the points apart, or make the radii smaller",
          i + 1, i + 2, length, before + after);
    return false;
  }
  return true;
}

// Lines that are given a start in the bore and are nowhere thin enough for it.
void lines_fit(const Case& c, const Volume& v, const TubeShape& s, const Issues& issue) {
  const TubeSurface tube(s);
  const int body = c.body_index(v.body);
  const RigidPose pose = body < 0 ? RigidPose{} : pose_at_start(c.bodies[body]);
  for (const Line& line : c.lines) {
    if (!c.contact.takes_part(line) || !c.contact.takes_part(v)) continue;
    double thinnest = HUGE_VAL;
    for (const Section& section : line.sections)
      thinnest = std::min(thinnest, c.line_type(section.type).contact_diameter);
    if (thinnest < 2 * s.inner_radius) continue;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      if (!tube.in_bore(pose.to_body(line.points[i]))) continue;
      issue("lines." + line.name + ".start",
            "point {} is in the bore of volume {}, whose diameter of {:g} m is too small for the line of "
            "{:g} m",
            i + 1, v.name, 2 * s.inner_radius, thinnest);
      break;
    }
  }
}

}  // namespace

void check_tube(const Case& c, const Volume& v, const TubeShape& s, const Issues& all) {
  const Issues issue = all.below("volumes." + v.name + ".shape.tube");
  if (!radii_fit(s, issue) || !legs_fit(s, issue)) return;
  lines_fit(c, v, s, all);
  if (const auto t = tube_touches_itself(s))
    issue("path",
          "the tube runs into itself: {:.4g} m and {:.4g} m along the path are {:.4g} m apart, less than its "
          "outer "
          "diameter of {:g} m",
          t->first, t->second, t->distance, 2 * s.outer_radius());
}

}  // namespace hawser::model
