// The class LineVolumeFinder: surface queries of a pair. If the surface has several facet groups: those near
// the pair, and their contact points of the last step.
#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/terms/line_volume_finder.hpp"

namespace hawser {
namespace {

// Parts of a surface are one facet group if they are connected within this factor times the distance at which
// contact begins. Facet groups therefore split and merge only while the farther one of them does not touch.
constexpr double kTogether = 1.1;
constexpr double kSagitta = 0.05;  // of that distance: largest distance between axis and polyline

// Axis as a polyline in the body's frame.
std::vector<Vec3> polyline(const AxisShape& shape, const RigidPose& pose, double contact_distance) {
  const double chords = std::sqrt(shape.bend_bound() / (8 * kSagitta * contact_distance));
  const int n = static_cast<int>(std::clamp(std::ceil(chords), 1.0, 16.0));
  std::vector<Vec3> points;
  for (int i = 0; i <= n; ++i) points.push_back(pose.to_body(shape.point(static_cast<double>(i) / n)));
  return points;
}

}  // namespace

std::optional<SurfacePoint> LineVolumeFinder::query(LineVolumePair& pair, int group, double xi, const Vec3& y,
                                                    double within, bool either_side) const {
  if (by_gap()) {
    const GapSpring& s = pair.start.springs[xi > 0.5];
    const double distance = s.direction.dot(y - s.anchor);
    if (!s.paired || distance > within) return std::nullopt;
    return SurfacePoint{distance, s.direction, Mat3::Zero(), s.anchor};
  }
  if (const FacetGroup* only = pair.group(group))
    return surface(pair).query_group(*only, y, within, either_side);
  // In each trial and each step, points in contact are queried near the same places of the surface.
  if (pair.start.points.empty()) return surface(pair).query(y, within, pair.cache.hint);
  return surface(pair).query_again(y, within, pair.cache.hint, pair.cache.near_facets.about(y));
}

bool LineVolumeFinder::one_facet_group(const LineVolumePair& pair, double motion) const {
  const AxisShape& shape = pair.start.shape;
  const RigidPose& pose = pair.start.pose;
  const std::array<Vec3, 2> chord{pose.to_body(shape.point(0)), pose.to_body(shape.point(1))};
  return surface(pair).one_facet_group(chord,
                                       kTogether * pair.contact_distance + motion + shape.bend_bound() / 8);
}

// Facet groups of the trial near the axis. The contact points of the last step are assigned to them.
void LineVolumeFinder::find_facet_groups(LineVolumePair& pair, const AxisShape& shape,
                                         const RigidPose& pose) const {
  const auto p = surface(pair).query(pose.to_body(shape.point(0.5)),
                                     pair.contact_distance + 2 * shape.slope_bound(), pair.cache.hint);
  if (p) pair.cache.hint = p->triangle;
  if (p && p->distance - pair.contact_distance < 0.5 * shape.slope_bound())
    surface(pair).facet_groups(polyline(shape, pose, pair.contact_distance),
                               kTogether * pair.contact_distance, pair.trial.near.facet_groups);
  assign_previous_points(pair);
}

// Assigns each point of the last step to the facet group with the most similar normal. If only one of two
// adjacent facet groups remains, the points of the more heavily loaded one are kept where both had points.
void LineVolumeFinder::assign_previous_points(LineVolumePair& pair) const {
  NearGroups& near = pair.trial.near;
  if (!near.facet_groups.several() && (pair.start.points.empty() || pair.start.points.back().group == 0))
    return;
  const size_t facet_groups = pair.facet_groups();
  // By present facet group: points by facet group of the last step.
  using Points = std::vector<AxisContactPoint>;
  std::vector<std::vector<Points>> points_of(facet_groups, std::vector<Points>(FacetGroups::kMaxGroups));
  for (const AxisContactPoint& p : pair.start.points) {
    size_t best = 0;
    double like = -2;
    const Vec3 y = pair.start.pose.to_body(pair.start.shape.point(p.xi));
    for (size_t w = 0; w < facet_groups && facet_groups > 1; ++w) {
      const auto nearest =
          surface(pair).query_group(near.facet_groups.list[w], y, std::numeric_limits<double>::max(), true);
      if (nearest && nearest->normal.dot(p.normal) > like) {
        like = nearest->normal.dot(p.normal);
        best = w;
      }
    }
    points_of[best][p.group].push_back(p);
  }
  for (std::vector<Points>& before : points_of) {
    const auto force = [](const Points& points) {
      double sum = 0;
      for (const AxisContactPoint& p : points) sum += p.weight * p.normal_force;
      return sum;
    };
    std::stable_sort(before.begin(), before.end(),
                     [&](const Points& a, const Points& b) { return force(a) > force(b); });
    Points& previous = near.previous.emplace_back();
    for (const Points& points : before) {
      const auto known = static_cast<std::ptrdiff_t>(previous.size());
      for (const AxisContactPoint& p : points)
        if (std::none_of(previous.begin(), previous.begin() + known,
                         [&](const AxisContactPoint& q) { return p.from < q.to && q.from < p.to; }))
          previous.push_back(p);
    }
    std::sort(previous.begin(), previous.end(), [](const auto& a, const auto& b) { return a.xi < b.xi; });
  }
}

void LineVolumeFinder::facet_groups_ahead(const LineVolumePair& pair, double ahead, FacetGroups& out) const {
  surface(pair).facet_groups(polyline(pair.start.shape, pair.start.pose, pair.contact_distance),
                             kTogether * pair.contact_distance + ahead, out);
}

}  // namespace hawser
