// Which pairs may touch in a trial: most are far away, and are known to be by how little their nodes move.
#include <algorithm>

#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {

std::vector<LineVolumeContact::Group> LineVolumeContact::groups() const {
  std::vector<Group> groups;
  for (size_t i = 0, next = 0; i < pairs_.size(); i = next) {
    for (next = i + 1; next < pairs_.size() && pairs_[next].slot > 0;) ++next;
    Group& g = groups.emplace_back();
    g.first = i, g.end = next;
    g.volume = pairs_[i].volume;
    g.nodes[0] = local(pairs_[i]).first, g.nodes[1] = local(pairs_[i]).second;
    // Bézier's inner points are a third of the length along the tangents; |R - R0| <= 2 |q - q0|.
    if (element(pairs_[i]).beam) g.turn = 2.0 / 3 * pairs_[i].length;
    g.room = LineVolumeFinder::room_at_start(pairs_[i]);
  }
  return groups;
}

// m, that points of the axis may have got by since the start of the step with one of its nodes.
double LineVolumeContact::way(const Kinematics& trial, const Group& g) const {
  double most = 0;
  for (const int node : g.nodes) {
    const size_t n = static_cast<size_t>(node);
    const double turn = g.turn > 0 ? (trial.q[n].coeffs() - start_q_[n].coeffs()).norm() : 0;
    most = std::max(most, (trial.x[n] - start_x_[n]).norm() + g.turn * turn);
  }
  return most;
}

void LineVolumeContact::look(const Kinematics& trial) {
  near_.clear();
  if (groups_.empty()) groups_ = groups();
  bool open = false;
  for (Group& g : groups_) {
    if (volumes_.still(g.volume) && way(trial, g) < g.room) continue;
    const AxisShape shape(ends(trial, pairs_[g.first].element));
    const RigidPose& pose = volumes_.trial_pose(g.volume);
    for (size_t i = g.first; i < g.end; ++i) {
      Pair& pair = pairs_[i];
      if (finder_.clear(pair, shape, pose)) {
        if (i == g.first) g.room = LineVolumeFinder::room_at_start(pair);  // it may have grown
        continue;
      }
      near_.push_back({i, shape});
      finder_.find(pair, shape, pose);
      open = open || lacks_pairs(i);
    }
  }
  if (!open) return;
  open_pairs();
  look(trial);  // what was found is known
}

bool LineVolumeContact::lacks_pairs(size_t i) const {
  const Pair& p = pairs_[i];
  if (!p.walls || p.slot > 0) return false;
  const size_t last = i + LineVolumeFinder::walls_seen(p) - 1;
  return last >= pairs_.size() || pairs_[last].walls != p.walls;
}

void LineVolumeContact::open_pairs() {
  std::vector<Pair> all;
  for (size_t i = 0; i < pairs_.size();) {
    const size_t wanted = lacks_pairs(i) ? LineVolumeFinder::walls_seen(pairs_[i]) : 0;
    Pair model;
    if (wanted) model = pairs_[i];
    size_t end = i + 1;
    while (end < pairs_.size() && pairs_[end].slot > 0) ++end;
    for (size_t k = i; k < end; ++k) all.push_back(std::move(pairs_[k]));
    for (size_t slot = end - i; slot < wanted; ++slot) {
      Pair& pair = all.emplace_back(model);
      pair.slot = static_cast<int>(slot);
      pair.points = pair.walls->committed[slot];
      pair.found = {}, pair.seen = nullptr, pair.evaluated_at.known = false;
    }
    i = end;
  }
  pairs_ = std::move(all);
  groups_.clear();
}

}  // namespace hawser
