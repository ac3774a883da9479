// Several walls of one volume: which a pair is about, and which of the points of before were its own.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "hawser/terms/line_contact.hpp"

namespace hawser {
namespace {

constexpr double kSagitta =
    0.05;  // of the distance at which contact begins: how far the axis is from its polyline
constexpr double kGrid = 0.125;  // the same: of places that are asked whether there is one wall

}  // namespace

std::optional<SurfacePoint> LineContact::see(const Pair& pair, const Vec3& y, double within,
                                             bool either_side) const {
  const Surface& surface = *volumes_[static_cast<size_t>(pair.volume)].surface;
  const SurfaceWall* wall = pair.wall();
  return wall ? surface.query_wall(*wall, y, within, either_side) : surface.query(y, within, pair.hint);
}

std::vector<Vec3> LineContact::polyline(const AxisShape& shape, const RigidPose& pose, double touch) {
  const double chords = std::sqrt(shape.bend_bound() / (8 * kSagitta * touch));
  const int n = static_cast<int>(std::clamp(std::ceil(chords), 1.0, 16.0));
  std::vector<Vec3> points;
  for (int i = 0; i <= n; ++i) points.push_back(pose.to_body(shape.point(static_cast<double>(i) / n)));
  return points;
}

// Asked of a chord and a reach on a grid: what is remembered of another step is then what would be answered
// now, and a run that goes on from a checkpoint decides as the one that made it.
bool LineContact::one_wall(Pair& pair, const AxisShape& shape, const RigidPose& pose, double motion) const {
  const double grid = kGrid * pair.touch;
  std::array<Vec3, 2> chord{pose.to_body(shape.point(0)), pose.to_body(shape.point(1))};
  for (Vec3& end : chord)
    for (double& x : end) x = grid * std::round(x / grid);
  const double need = kTogether * pair.touch + motion + shape.bend_bound() / 8;
  const double reach = grid * std::ceil(need / grid + 0.5 * std::sqrt(3.0));
  if (reach == pair.one_reach && chord == pair.one_chord) return pair.one;
  pair.one = volumes_[static_cast<size_t>(pair.volume)].surface->one_wall(chord, reach);
  pair.one_chord = chord, pair.one_reach = reach;
  return pair.one;
}

// Walls of the trial alone: of the axis, and of what was left by the last step.
void LineContact::see_walls(Pair& pair, const AxisShape& shape, const RigidPose& pose) const {
  Walls& w = *pair.walls;
  const bool same = w.known && w.shape.same_axis(shape) && w.position == pose.position &&
                    w.rotation.coeffs() == pose.rotation.coeffs();
  if (!same) {
    w.known = true, w.shape = shape, w.position = pose.position, w.rotation = pose.rotation;
    auto seen = std::make_shared<Seen>();
    const size_t k = static_cast<size_t>(pair.volume);
    const SurfaceQuestion first = middle(pair, shape, pose);
    const auto p = volumes_[k].surface->query(first.point, first.max_distance, w.hint);
    if (p) w.hint = p->triangle;
    if (p && p->distance - pair.touch < 0.5 * shape.reach())
      volumes_[k].surface->walls(polyline(shape, pose, pair.touch), kTogether * pair.touch, seen->walls);
    assign_past(pair, *seen);
    w.seen = std::move(seen);
  }
  pair.seen = w.seen;
}

bool LineContact::lacks_pairs(size_t i) const {
  const Pair& p = pairs_[i];
  if (p.slot > 0 || !p.seen || !p.seen->walls.several()) return false;
  const size_t last = i + p.seen->walls.of.size() - 1;
  return last >= pairs_.size() || pairs_[last].walls != p.walls;
}

void LineContact::open_pairs() {
  std::vector<Pair> all;
  for (size_t i = 0; i < pairs_.size();) {
    const size_t wanted = pairs_[i].walls && lacks_pairs(i) ? pairs_[i].seen->walls.of.size() : 0;
    Pair model;
    if (wanted) model = pairs_[i];
    size_t end = i + 1;
    while (end < pairs_.size() && pairs_[end].slot > 0) ++end;
    for (size_t k = i; k < end; ++k) all.push_back(std::move(pairs_[k]));
    for (size_t slot = end - i; slot < wanted; ++slot) {
      Pair& pair = all.emplace_back(model);
      pair.slot = static_cast<int>(slot);
      pair.history = pair.walls->committed[slot];
      pair.found = {}, pair.seen = nullptr;
    }
    i = end;
  }
  pairs_ = std::move(all);
  groups_.clear();
}

// A point of before lay on the wall whose normal there is most like its own. On the one wall there is: of
// two that lay side by side, the more heavily pressed.
void LineContact::assign_past(const Pair& pair, Seen& seen) const {
  const auto& committed = pair.walls->committed;
  const bool more =
      std::any_of(committed.begin() + 1, committed.end(), [](const auto& h) { return !h.empty(); });
  if (!seen.walls.several() && !more) return;
  seen.past.assign(committed.size(), {});
  const size_t walls = seen.walls.several() ? seen.walls.of.size() : 1;
  const Surface& surface = *volumes_[static_cast<size_t>(pair.volume)].surface;
  const RigidPose& pose = start_poses_[body(pair.volume)];
  // The points of each of the pairs of before, by wall.
  std::vector<std::vector<std::vector<Point>>> of(walls, std::vector<std::vector<Point>>(committed.size()));
  for (size_t slot = 0; slot < committed.size(); ++slot)
    for (const Point& p : committed[slot]) {
      size_t best = 0;
      double like = -2;
      const Vec3 y = pose.to_body(pair.start.point(p.xi));
      for (size_t w = 0; w < walls && walls > 1; ++w) {
        const auto there = surface.query_wall(seen.walls.of[w], y, std::numeric_limits<double>::max(), true);
        if (there && there->normal.dot(p.normal) > like) like = there->normal.dot(p.normal), best = w;
      }
      of[best][slot].push_back(p);
    }
  for (size_t w = 0; w < walls; ++w) {
    std::vector<size_t> order(committed.size());
    std::iota(order.begin(), order.end(), size_t{0});
    const auto force = [&](size_t slot) {
      double sum = 0;
      for (const Point& p : of[w][slot]) sum += p.weight * p.normal_force;
      return sum;
    };
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return force(a) > force(b); });
    std::vector<Point>& past = seen.past[w];
    for (const size_t slot : order) {
      const size_t before = past.size();
      for (const Point& p : of[w][slot])
        if (std::none_of(past.begin(), past.begin() + static_cast<std::ptrdiff_t>(before),
                         [&](const Point& q) { return p.from < q.to && q.from < p.to; }))
          past.push_back(p);
    }
    std::sort(past.begin(), past.end(), [](const Point& a, const Point& b) { return a.xi < b.xi; });
  }
}

bool LineContact::look_ahead_at_walls(const Pair& pair, const Kinematics& committed, Strikes& to) const {
  const RigidPose& pose = start_poses_[body(pair.volume)];
  const Surface& surface = *volumes_[static_cast<size_t>(pair.volume)].surface;
  const auto speed = [&](double xi) {
    return (pair.start.velocity(xi) - pose.velocity_at(pair.start.point(xi))).norm();
  };
  const double ahead = std::min(0.5, 2 * to.most) * std::max({speed(0), speed(0.5), speed(1)});
  SurfaceWalls walls;
  surface.walls(polyline(pair.start, pose, pair.touch), kTogether * pair.touch + ahead, walls);
  for (const SurfaceWall& w : walls.of)
    for (const double xi : {0.0, 0.5, 1.0}) {
      if (!pair.part.has(xi)) continue;
      const auto p = surface.query_wall(w, pose.to_body(pair.start.point(xi)),
                                        pair.touch + 0.5 * (pair.start.reach() + speed(xi)));
      if (p) look_ahead(pair, committed, xi, !pair.history.empty(), *p, to);
    }
  return walls.several();
}

}  // namespace hawser
