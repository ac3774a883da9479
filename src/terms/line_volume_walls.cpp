// What a pair sees of its volume; where that has several walls, which of them a pair is about, and which of
// the points of before were its own.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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

std::optional<SurfacePoint> LineVolumeFinder::see(const LineVolumePair& pair, double xi, const Vec3& y,
                                                  double within, bool either_side) const {
  if (by_gap()) {
    const GapSpring& s = pair.springs[xi > 0.5];
    const double distance = s.direction.dot(y - s.anchor);
    if (!s.paired || distance > within) return std::nullopt;
    return SurfacePoint{distance, s.direction, Mat3::Zero(), s.anchor};
  }
  const SurfaceWall* wall = pair.wall();
  return wall ? surface(pair).query_wall(*wall, y, within, either_side)
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
  ElementWalls& w = *pair.walls;
  if (!w.of.same_places(shape, pose)) {
    w.of = {true, shape, pose};
    auto seen = std::make_shared<SeenWalls>();
    const auto p =
        surface(pair).query(pose.to_body(shape.point(0.5)), pair.touch + 2 * shape.reach(), w.hint);
    if (p) w.hint = p->triangle;
    if (p && p->distance - pair.touch < 0.5 * shape.reach())
      surface(pair).walls(polyline(shape, pose, pair.touch), kTogether * pair.touch, seen->walls);
    assign_past(pair, *seen);
    w.seen = std::move(seen);
  }
  pair.seen = w.seen;
}

// A point of before lay on the wall whose normal there is most like its own. On the one wall there is: of
// two that lay side by side, the more heavily pressed.
void LineVolumeFinder::assign_past(const LineVolumePair& pair, SeenWalls& seen) const {
  const auto& committed = pair.walls->committed;
  const bool more =
      std::any_of(committed.begin() + 1, committed.end(), [](const auto& h) { return !h.empty(); });
  if (!seen.walls.several() && !more) return;
  seen.past.assign(committed.size(), {});
  const size_t walls = seen.walls.several() ? seen.walls.of.size() : 1;
  // The points of each of the pairs of before, by wall.
  std::vector<std::vector<std::vector<ContactPoint>>> of(
      walls, std::vector<std::vector<ContactPoint>>(committed.size()));
  for (size_t slot = 0; slot < committed.size(); ++slot)
    for (const ContactPoint& p : committed[slot]) {
      size_t best = 0;
      double like = -2;
      const Vec3 y = pair.start.pose.to_body(pair.start.shape.point(p.xi));
      for (size_t w = 0; w < walls && walls > 1; ++w) {
        const auto there =
            surface(pair).query_wall(seen.walls.of[w], y, std::numeric_limits<double>::max(), true);
        if (there && there->normal.dot(p.normal) > like) like = there->normal.dot(p.normal), best = w;
      }
      of[best][slot].push_back(p);
    }
  for (size_t w = 0; w < walls; ++w) {
    std::vector<size_t> order(committed.size());
    std::iota(order.begin(), order.end(), size_t{0});
    const auto force = [&](size_t slot) {
      double sum = 0;
      for (const ContactPoint& p : of[w][slot]) sum += p.weight * p.normal_force;
      return sum;
    };
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return force(a) > force(b); });
    std::vector<ContactPoint>& past = seen.past[w];
    for (const size_t slot : order) {
      const size_t before = past.size();
      for (const ContactPoint& p : of[w][slot])
        if (std::none_of(past.begin(), past.begin() + static_cast<std::ptrdiff_t>(before),
                         [&](const ContactPoint& q) { return p.from < q.to && q.from < p.to; }))
          past.push_back(p);
    }
    std::sort(past.begin(), past.end(),
              [](const ContactPoint& a, const ContactPoint& b) { return a.xi < b.xi; });
  }
}

void LineVolumeFinder::walls_ahead(const LineVolumePair& pair, double ahead, SurfaceWalls& out) const {
  surface(pair).walls(polyline(pair.start.shape, pair.start.pose, pair.touch), kTogether * pair.touch + ahead,
                      out);
}

}  // namespace hawser
