// What a pair sees of its volume; where that has several walls, which of them a pair is about, and which of
// the points of before were its own.
#include <algorithm>
#include <cmath>
#include <limits>

#include "hawser/terms/line_volume_finder.hpp"

namespace hawser {
namespace {

// Parts of a surface are one wall where they hang together no farther away than this, times the distance at
// which contact begins: so walls part and come together while the farther of them is out of touch.
constexpr double kTogether = 1.1;
constexpr double kSagitta = 0.05;  // of that distance: how far the axis is from its polyline
constexpr double kGrid = 0.125;    // the same: of places that are asked whether there is one wall

// The axis as a polyline in the body's frame.
std::vector<Vec3> polyline(const AxisShape& shape, const RigidPose& pose, double touch) {
  const double chords = std::sqrt(shape.bend_bound() / (8 * kSagitta * touch));
  const int n = static_cast<int>(std::clamp(std::ceil(chords), 1.0, 16.0));
  std::vector<Vec3> points;
  for (int i = 0; i <= n; ++i) points.push_back(pose.to_body(shape.point(static_cast<double>(i) / n)));
  return points;
}

}  // namespace

std::optional<SurfacePoint> LineVolumeFinder::see(const LineVolumePair& pair, int wall, double xi,
                                                  const Vec3& y, double within, bool either_side) const {
  if (by_gap()) {
    const GapSpring& s = pair.springs[xi > 0.5];
    const double distance = s.direction.dot(y - s.anchor);
    if (!s.paired || distance > within) return std::nullopt;
    return SurfacePoint{distance, s.direction, Mat3::Zero(), s.anchor};
  }
  const SurfaceWall* only = pair.wall(wall);
  return only ? surface(pair).query_wall(*only, y, within, either_side)
              : surface(pair).query(y, within, pair.hint);
}

// Asked of a chord and a reach on a grid: what is remembered of another step is then what would be answered
// now, and a run that goes on from a checkpoint decides as the one that made it.
bool LineVolumeFinder::one_wall(LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose,
                                double motion) const {
  const double grid = kGrid * pair.touch;
  std::array<Vec3, 2> chord{pose.to_body(shape.point(0)), pose.to_body(shape.point(1))};
  for (Vec3& end : chord)
    for (double& x : end) x = grid * std::round(x / grid);
  const double need = kTogether * pair.touch + motion + shape.bend_bound() / 8;
  const double reach = grid * std::ceil(need / grid + 0.5 * std::sqrt(3.0));
  if (reach == pair.one_reach && chord == pair.one_chord) return pair.one;
  pair.one = surface(pair).one_wall(chord, reach);
  pair.one_chord = chord, pair.one_reach = reach;
  return pair.one;
}

// Walls of the trial alone: of the axis, and of what was left by the last step.
void LineVolumeFinder::see_walls(LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose) const {
  const auto p =
      surface(pair).query(pose.to_body(shape.point(0.5)), pair.touch + 2 * shape.reach(), pair.hint);
  if (p) pair.hint = p->triangle;
  if (p && p->distance - pair.touch < 0.5 * shape.reach())
    surface(pair).walls(polyline(shape, pose, pair.touch), kTogether * pair.touch, pair.seen.walls);
  assign_past(pair);
}

// A point of before lay on the wall whose normal there is most like its own. On the one wall there is: of
// two that lay side by side, the more heavily pressed.
void LineVolumeFinder::assign_past(LineVolumePair& pair) const {
  SeenWalls& seen = pair.seen;
  if (!seen.walls.several() && (pair.points.empty() || pair.points.back().wall == 0)) return;
  const size_t walls = static_cast<size_t>(pair.walls());
  // The points of each of the walls of before, by wall.
  using Points = std::vector<AxisContactPoint>;
  std::vector<std::vector<Points>> of(walls, std::vector<Points>(SurfaceWalls::kMost));
  for (const AxisContactPoint& p : pair.points) {
    size_t best = 0;
    double like = -2;
    const Vec3 y = pair.start.pose.to_body(pair.start.shape.point(p.xi));
    for (size_t w = 0; w < walls && walls > 1; ++w) {
      const auto there =
          surface(pair).query_wall(seen.walls.of[w], y, std::numeric_limits<double>::max(), true);
      if (there && there->normal.dot(p.normal) > like) like = there->normal.dot(p.normal), best = w;
    }
    of[best][static_cast<size_t>(p.wall)].push_back(p);
  }
  for (std::vector<Points>& before : of) {
    const auto force = [](const Points& points) {
      double sum = 0;
      for (const AxisContactPoint& p : points) sum += p.weight * p.normal_force;
      return sum;
    };
    std::stable_sort(before.begin(), before.end(),
                     [&](const Points& a, const Points& b) { return force(a) > force(b); });
    Points& past = seen.past.emplace_back();
    for (const Points& points : before) {
      const auto known = static_cast<std::ptrdiff_t>(past.size());
      for (const AxisContactPoint& p : points)
        if (std::none_of(past.begin(), past.begin() + known,
                         [&](const AxisContactPoint& q) { return p.from < q.to && q.from < p.to; }))
          past.push_back(p);
    }
    std::sort(past.begin(), past.end(), [](const auto& a, const auto& b) { return a.xi < b.xi; });
  }
}

void LineVolumeFinder::walls_ahead(const LineVolumePair& pair, double ahead, SurfaceWalls& out) const {
  surface(pair).walls(polyline(pair.start.shape, pair.start.pose, pair.touch), kTogether * pair.touch + ahead,
                      out);
}

}  // namespace hawser
