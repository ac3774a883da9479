// Path of a line over its supports, the support that is out of line with the others, and the messages.
#include "hawser/advice/supports.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hawser/math/segment.hpp"
#include "hawser/model/check.hpp"

namespace hawser::advice {
namespace {

// A point on the path of a line over its supports, in space: the end at the tensioner, which has the box
// after it, and the resting point on each box.
struct Stop {
  Vec3 at, along, up;  // m; unit
  const model::SupportBox* box;
};

std::vector<Stop> path_over_supports(const model::Case& c, const model::Line& line,
                                     const std::vector<RigidPose>& poses) {
  std::vector<Stop> path;
  for (const model::SupportBox& b : c.supports) {
    if (b.line != line.name) continue;
    const auto pose_of = [&](const std::string& body) {
      const int i = c.body_index(body);
      return i < 0 ? RigidPose{} : poses[i];
    };
    const RigidPose pose = pose_of(b.body);
    const Stop stop{pose.to_space(b.at), pose.rotation * b.along, pose.rotation * b.up, &b};
    if (const model::End* end = path.empty() ? model::end_before(c, line, b) : nullptr) {
      const Vec3 at = model::end_position(c, *end);
      Vec3 along = (stop.at - at).normalized();
      if (end->direction)
        along = (end == &line.end_a ? 1.0 : -1.0) * (pose_of(end->carrier).rotation * *end->direction);
      path.push_back({at, along, stop.up, &b});
    }
    path.push_back(stop);
  }
  return path;
}

// Height [m] of a point above the path of the others, at least three: for interior points the cubic Hermite
// curve through both neighbours; for end points an arc with the curvature between the nearest two.
double height_above_others(const std::vector<Stop>& path, size_t k) {
  const Stop& stop = path[k];
  if (k > 0 && k + 1 < path.size()) {
    const Stop& a = path[k - 1];
    const Stop& b = path[k + 1];
    const Vec3 chord = b.at - a.at;
    const double d = chord.norm();
    const double t = nearest_fraction(stop.at, a.at, b.at);
    const double u = 1 - t;
    const Vec3 on_curve =
        u * u * (1 + 2 * t) * a.at + t * t * (3 - 2 * t) * b.at + t * u * d * (u * a.along - t * b.along);
    return (stop.at - on_curve).dot(stop.up);
  }
  const bool first = k == 0;
  const Stop& near = path[first ? 1 : k - 1];
  const Stop& next = path[first ? 2 : k - 2];
  const double d = (stop.at - near.at).norm();
  const double turn = 0.5 * d / (near.at - next.at).norm();
  const Vec3 along = (near.along + turn * (near.along - next.along)).normalized();
  return (stop.at - near.at - (first ? -d : d) * along).dot(stop.up);
}

}  // namespace

std::optional<BelowSupport> below_supports(const model::Case& c,
                                           const std::vector<model::SupportCrossing>& crossings,
                                           const std::vector<RigidPose>& poses) {
  for (size_t k = 0; k < crossings.size(); ++k) {
    const model::SupportBox& b = c.supports[k];
    const model::SupportCrossing& x = crossings[k];
    if (!x.known || std::abs(x.offset) > b.half_width || x.height > -b.rise) continue;
    const model::Line& line = c.line(b.line);
    const std::string wrong =
        fmt::format("starts on the wrong side of support '{}', {:.3g} m below its position on the roller",
                    b.name, -x.height);
    if (line.start != model::Start::automatic)
      return BelowSupport{
          "lines." + line.name,
          wrong + "; remove 'start', so that it starts on its supports, or give points above them"};
    const std::vector<Stop> path = path_over_supports(c, line, poses);
    size_t odd = 0;
    double off = 0;  // m
    for (size_t i = 0; i < path.size() && path.size() > 2; ++i)
      if (const double above = height_above_others(path, i); std::abs(above) > std::abs(off)) {
        odd = i;
        off = above;
      }
    if (!(std::abs(off) > b.rise))
      return BelowSupport{
          b.key,
          fmt::format(
              "line {} {}; move the supports or the end of the line, so that the path leads to the end",
              line.name, wrong)};
    const model::SupportBox& named = *path[odd].box;
    const std::string cause =
        odd > 0
            ? fmt::format("support '{}' is {:.3g} m {} the path over its neighbours", named.name,
                          std::abs(off), off > 0 ? "above" : "below")
            : fmt::format(
                  "the path over the supports begins {:.3g} m {} the end from which line {} goes overboard",
                  std::abs(off), off > 0 ? "below" : "above", line.name);
    return BelowSupport{named.key,
                        fmt::format("{}, so that line {} {}; {}", cause, line.name, wrong,
                                    odd > 0 ? "move it into line with them"
                                            : "move them or the end, so that the path leads to the end")};
  }
  return {};
}

std::string off_rollers(const model::SupportBox& box, const model::SupportCrossing& at, double time) {
  return fmt::format(
      "line {} is beyond the end of the rollers of support {} at t = {:.6g} s: {:.3g} m to the {} of their "
      "middle, and they end at {:.3g} m",
      box.line, box.name, time, std::abs(at.offset), at.offset > 0 ? "left" : "right", box.half_width);
}

std::string never_carries(const model::SupportBox& box, double height) {
  return fmt::format(
      "support {} never carries line {}, {} and lies on supports further on: raise it by 'above_path', or "
      "remove it",
      box.name, box.line,
      std::isfinite(height) ? fmt::format("which passes {:.3g} m above it", height)
                            : std::string("which does not pass it"));
}

std::string none_carries(const std::string& line) {
  return fmt::format("none of its supports ever carries line {}: are they too low, or beside the line?",
                     line);
}

}  // namespace hawser::advice
