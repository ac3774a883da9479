// Which pairs may touch in a trial: most are far away, and are known to be by how little their nodes move.
#include <algorithm>
#include <cmath>

#include "hawser/terms/feeders.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {

std::vector<LineVolumeContact::PairBounds> LineVolumeContact::pair_bounds() const {
  std::vector<PairBounds> pair_bounds;
  for (size_t i = 0; i < pairs_.size(); ++i) {
    PairBounds& g = pair_bounds.emplace_back();
    g.pair = i;
    g.volume = pairs_[i].volume;
    g.nodes[0] = local(pairs_[i]).first, g.nodes[1] = local(pairs_[i]).second;
    // Bézier's inner points are a third of the length along the tangents; |R - R0| <= 2 |q - q0|.
    if (element(pairs_[i]).beam) g.turn = 2.0 / 3 * pairs_[i].length;
    g.grows = element(pairs_[i]).beam && feeders_ && feeders_->fed_end(local(pairs_[i]).global) >= 0;
    g.clearance = LineVolumeFinder::clearance_at_start(pairs_[i]);
  }
  return pair_bounds;
}

// m, that points of the axis may have got by since the start of the step with one of its nodes.
double LineVolumeContact::way(const Kinematics& trial, const PairBounds& g) const {
  double most = 0;
  for (const int node : g.nodes) {
    const size_t n = static_cast<size_t>(node);
    const double turn = g.turn > 0 ? (trial.q[n].coeffs() - start_q_[n].coeffs()).norm() : 0;
    most = std::max(most, (trial.x[n] - start_x_[n]).norm() + g.turn * turn);
  }
  // |L R t - L0 R0 t| <= |L - L0| + L0 |R - R0|, a third of it at Bézier's inner points.
  const LineVolumePair& pair = pairs_[g.pair];
  return g.grows ? most + std::abs(ends(trial, pair.element).length - pair.length) / 3 : most;
}

void LineVolumeContact::find_near_pairs(const Kinematics& trial) {
  near_.clear();
  if (bounds_.empty()) bounds_ = pair_bounds();
  for (PairBounds& g : bounds_) {
    if (volumes_.still(g.volume) && way(trial, g) < g.clearance) continue;
    Pair& pair = pairs_[g.pair];
    const AxisShape shape(ends(trial, pair.element));
    const RigidPose& pose = volumes_.trial_pose(g.volume);
    if (finder_.clear(pair, shape, pose)) {
      g.clearance = LineVolumeFinder::clearance_at_start(pair);  // it may have grown
      continue;
    }
    near_.push_back({g.pair, shape});
    finder_.find(pair, shape, pose);
  }
}

}  // namespace hawser
