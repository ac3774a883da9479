// Which pairs may touch in a trial, and where.
#include <algorithm>

#include "hawser/terms/line_contact.hpp"

namespace hawser {

AxisPoints LineContact::points(const AxisShape& shape, const RigidPose& pose) {
  AxisPoints b = shape.bezier();
  for (Vec3& p : b) p = pose.to_body(p);
  return b;
}

// De Casteljau's: the polar form of the cubic at all choices of the two ends.
AxisPoints LineContact::points_of_part(const Pair& pair, const AxisShape& shape, const RigidPose& pose) {
  const AxisPoints b = points(shape, pose);
  if (pair.part.all()) return b;
  const double from = pair.part.from, to = pair.part.to;
  const auto blossom = [&b](double r, double s, double t) {
    AxisPoints p = b;
    size_t n = 3;
    for (const double xi : {r, s, t}) {
      for (size_t i = 0; i < n; ++i) p[i] = (1 - xi) * p[i] + xi * p[i + 1];
      --n;
    }
    return p[0];
  };
  return {blossom(from, from, from), blossom(from, from, to), blossom(from, to, to), blossom(to, to, to)};
}

bool LineContact::clear(Pair& pair, const AxisShape& shape, const RigidPose& pose) {
  if (!(pair.room().left(points(shape, pose)) > 0)) return false;
  pair.found.known = false;
  pair.found.panels.clear(), pair.found.filled.clear(), pair.found.points.clear();
  pair.seen = nullptr;
  return true;
}

void LineContact::group_pairs() {
  for (size_t i = 0, next = 0; i < pairs_.size(); i = next) {
    for (next = i + 1; next < pairs_.size() && pairs_[next].slot > 0;) ++next;
    const LocalElement& e = mesh_.elements[static_cast<size_t>(pairs_[i].element)];
    Group& g = groups_.emplace_back();
    g.first = i, g.end = next;
    g.nodes[0] = e.first, g.nodes[1] = e.second;
    g.body = body(pairs_[i].volume);
    // Bézier's inner points are a third of the length along the tangents.
    if (mesh_.mesh->elements[static_cast<size_t>(e.global)].beam)
      g.turn = 2.0 / 3 * length(pairs_[i].element);
    g.room = room_at_start(pairs_[i]);
  }
}

double LineContact::room_at_start(const Pair& pair) const {
  return pair.room().left(points(pair.start, start_poses_[body(pair.volume)]));
}

// How far the nodes have got since the start of the step; |R - R0| <= 2 |q - q0| for what they turn.
void LineContact::look_at_nodes(const Kinematics& trial) {
  moved_.resize(start_x_.size());
  for (size_t n = 0; n < moved_.size(); ++n)
    moved_[n] = {(trial.x[n] - start_x_[n]).norm(), (trial.q[n].coeffs() - start_q_[n].coeffs()).norm()};
  still_.resize(poses_.size());
  for (size_t b = 0; b < poses_.size(); ++b)
    still_[b] = poses_[b].position == start_poses_[b].position &&
                poses_[b].rotation.coeffs() == start_poses_[b].rotation.coeffs();
}

// By its nodes alone, for all is far away from most volumes.
bool LineContact::quiet(const Group& g) const {
  if (!still_[g.body]) return false;
  const auto way = [&](int node) {
    const Moved& m = moved_[static_cast<size_t>(node)];
    return m.way + g.turn * m.turn;
  };
  return std::max(way(g.nodes[0]), way(g.nodes[1])) < g.room;
}

// The same as find() of each: the search between middle and Gauss points goes from answer to answer, and is
// of the few elements that touch or may.
void LineContact::find_all(const Kinematics& trial) {
  near_.clear(), shapes_.clear(), renewed_.clear();
  if (groups_.empty()) group_pairs();
  look_at_nodes(trial);
  bool open = false;
  for (Group& g : groups_) {
    if (quiet(g)) continue;
    const AxisShape shape(ends(trial, pairs_[g.first].element));
    const RigidPose& pose = poses_[g.body];
    for (size_t i = g.first; i < g.end; ++i) {
      Pair& pair = pairs_[i];
      if (clear(pair, shape, pose)) {
        if (i == g.first) g.room = room_at_start(pair);  // it may have grown
        continue;
      }
      const size_t me = near_.size();
      near_.push_back(i), shapes_.push_back(shape);
      if (pair.walls) {
        find(pair, shape, pose);
        open = open || lacks_pairs(i);
      } else if (renew(pair.found, shape, pose)) {
        renewed_.push_back(me);
        questions_.add(pair.volume, me, middle(pair, shape, pose));
      }
    }
  }
  middles_.assign(near_.size(), std::nullopt);
  questions_.ask(volumes_, [&](size_t i, std::optional<SurfacePoint>& p) { middles_[i] = p; });
  std::vector<SurfaceQuestion> ask;
  for (const size_t i : renewed_) {
    Pair& pair = pairs_[near_[i]];
    const RigidPose& pose = poses_[body(pair.volume)];
    pair.found.panels = locate(pair, shapes_[i], pose, middles_[i]);
    gauss_points(pair, shapes_[i], pose, ask);
    for (const SurfaceQuestion& q : ask) questions_.add(pair.volume, near_[i], q);
  }
  questions_.ask(volumes_, [&](size_t i, std::optional<SurfacePoint>& p) {
    if (p) pairs_[i].hint = p->triangle;
    pairs_[i].found.points.push_back(p ? *p : nothing());
  });
  if (!open) return;
  open_pairs();
  find_all(trial);  // what was found is known
}

}  // namespace hawser
