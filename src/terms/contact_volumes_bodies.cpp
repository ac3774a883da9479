// The class ContactVolumes: poses of the volumes' bodies, and the floating bodies that lines may meet.
#include <algorithm>
#include <set>

#include "hawser/base/exchange.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/terms/contact_volumes.hpp"

namespace hawser {
namespace {

constexpr int kCouplingsTag = 77;
constexpr double kMaxDisplacementInStatics =
    0.15;  // of the line: largest displacement in a Newton iteration of statics

}  // namespace

void ContactVolumes::pose(const Kinematics& state, std::vector<RigidPose>& poses) const {
  const int n = bodies_->size();
  poses.resize(n + 1);
  for (int b = 0; b < n; ++b) poses[b + 1] = bodies_->pose(b, state);
}

std::vector<RigidPose> ContactVolumes::poses(const Kinematics& state) const {
  std::vector<RigidPose> poses;
  pose(state, poses);
  return poses;
}

// Valid for a body that a line on this rank may touch.
RigidPose ContactVolumes::pose_of(int volume, const Kinematics& state) const {
  return bodies_->pose(this->at(volume).body, state);
}

FloatingFrame ContactVolumes::floating_frame(int volume, const Kinematics& state) const {
  const int local = bodies_->local_node(this->at(volume).body);
  return {mesh_.block[local], state.x[local], state.v[local], state.q[local].toRotationMatrix()};
}

// Elements are listed with a margin, so that the list remains valid for many steps. It is rebuilt when an
// element outside the list comes near.
bool ContactVolumes::refresh_couplings(const Kinematics& from, double h, double thickest) {
  const auto moving = [this](const ContactVolume& v) { return bodies_->floats(v.body); };
  if (std::none_of(volumes_.begin(), volumes_.end(), moving)) return false;
  bodies_->exchange_poses(comm_, from);
  std::vector<std::array<int, 3>> wide;
  bool missing = false;
  const std::vector<RigidPose> poses = this->poses(from);
  const Mesh& mesh = *mesh_.mesh;
  for (const LocalElement& e : mesh_.elements) {
    if (!e.counted) continue;
    const Element& g = mesh_.element(e);
    const size_t a = e.first;
    const size_t b = e.second;
    const Vec3 middle = 0.5 * (from.x[a] + from.x[b]);
    for (size_t k = 0; k < volumes_.size(); ++k) {
      const ContactVolume& v = volumes_[k];
      if (!moving(v)) continue;
      if (takes_part(g.line, static_cast<int>(k), arc_at(mesh_, e, 0), arc_at(mesh_, e, 1)).none()) continue;
      const RigidPose& pose = poses[v.body + 1];
      const double speed = std::max((from.v[a] - pose.velocity_at(from.x[a])).norm(),
                                    (from.v[b] - pose.velocity_at(from.x[b])).norm());
      const double travel = h > 0 ? std::max(2 * h * speed, 0.5 * g.length)
                                  : kMaxDisplacementInStatics * mesh.lines[g.line].length;
      const double contact_distance = 1.01 * thickest + v.settings.smoothing.value_or(0);
      const double gap = distance(boxes_[k], pose.to_body(middle)) - contact_distance -
                         (from.x[b] - from.x[a]).norm() - 0.5 * g.length;
      if (gap > 2 * travel + 2 * g.length) continue;
      const std::array<int, 3> pair{g.first, g.second, bodies_->frame(v.body)};
      wide.push_back(pair);
      missing = missing || (gap <= travel && !std::binary_search(near_.begin(), near_.end(), pair));
    }
  }
  if (!on_any_rank(comm_, missing)) return false;
  // The ranks of the other node and of the body have a part in the coupling.
  ListsByRank<std::array<int, 3>> of_others;
  for (const std::array<int, 3>& pair : wide)
    for (const int owner : std::set{mesh_.owner[pair[1]], mesh_.owner[pair[2]]})
      if (owner != rank_of(comm_)) of_others[owner].push_back(pair);
  near_ = std::move(wide);
  for (const auto& [rank, received] : send_lists(comm_, kCouplingsTag, of_others))
    near_.insert(near_.end(), received.begin(), received.end());
  std::sort(near_.begin(), near_.end());
  near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
  return true;
}

bool ContactVolumes::coupled(const Element& e, int volume) const {
  const std::array<int, 3> pair{e.first, e.second, bodies_->frame(this->at(volume).body)};
  return std::binary_search(near_.begin(), near_.end(), pair);
}

void ContactVolumes::list_couplings(Couplings& to) const {
  for (const auto& [a, b, body] : near_)
    if (mesh_.owns_node(a) || mesh_.owns_node(b) || mesh_.owns_node(body)) to.add({a, b}, {body, body});
}

}  // namespace hawser
