// The class TiedNodeForces: converts forces at tied nodes, and their derivatives, to the frames.
#include "hawser/system/tied_node_forces.hpp"

#include <algorithm>

#include "hawser/system/assembler.hpp"

namespace hawser {

TiedNodeForces::TiedNodeForces(const LocalMesh& mesh, const TiedNodes& tied) {
  if (!tied.to_frames().empty()) tie_of_.assign(static_cast<size_t>(mesh.blocks()), -1);
  for (const int i : tied.to_frames()) {
    const TiedNode& s = tied.nodes()[i];
    Tie t;
    t.block = mesh.block[s.node];
    t.frame = mesh.block[s.frame];
    t.frame_node = s.frame;
    t.owned = s.node < mesh.owned;
    t.turns = mesh.rotates(s.node) && s.rotation_mask == 7;
    t.point = !mesh.rotates(s.frame);
    t.frame_point.y = s.at;
    t.turn = s.rotation.conjugate().toRotationMatrix();
    tie_of_[t.block] = static_cast<int>(ties_.size());
    if (t.turns) tie_of_[t.block + 1] = static_cast<int>(ties_.size());
    ties_.push_back(t);
  }
}

void TiedNodeForces::move(const Kinematics& trial) {
  director_weight_ = trial.director_weight;
  for (Tie& t : ties_) {
    t.frame_point.R = trial.q[t.frame_node].toRotationMatrix();
    t.frame_point.w = trial.w[t.frame_node];
  }
}

void TiedNodeForces::add_forces(std::vector<double>& force, std::vector<double>& squares) const {
  const auto at = [&force](int b) { return Eigen::Map<Vec3>(force.data() + 3 * b); };
  for (const Tie& t : ties_) {
    if (!t.owned) continue;
    const Vec3 f = at(t.block);
    at(t.frame) += f;
    squares[t.frame] += f.squaredNorm();
    if (t.point) continue;
    Vec3 moment = t.frame_point.moment(f);
    if (t.turns) moment += t.turn.transpose() * at(t.block + 1);
    at(t.frame + 1) += moment;
    squares[t.frame + 1] += moment.squaredNorm();
  }
}

void TiedNodeForces::add_geometric_stiffness(const std::vector<double>& force, bool convex,
                                             Assembler& assembler) const {
  for (const Tie& t : ties_) {
    if (!t.owned || t.point) continue;
    const Eigen::Map<const Vec3> f(force.data() + 3 * t.block);
    const Mat3 K = convex ? t.frame_point.convex_moment_by_turn(f) : t.frame_point.moment_by_turn(f);
    assembler.add(t.frame + 1, Vec3::Zero(), &K);
  }
}

TiedNodeForces::Unknowns TiedNodeForces::unknowns(std::span<const int> blocks) const {
  Unknowns z;
  const auto place = [&z](int block) {
    const auto at = std::find(z.to.begin(), z.to.end(), block);
    if (at != z.to.end()) return 3 * (at - z.to.begin());
    z.to.push_back(block);
    return 3 * static_cast<std::ptrdiff_t>(z.to.size() - 1);
  };
  const Eigen::Index m = 3 * static_cast<Eigen::Index>(blocks.size());
  z.P = z.V = Eigen::MatrixXd::Zero(m, 2 * m);
  for (Eigen::Index i = 0; i < m; i += 3) {
    const int block = blocks[i / 3];
    if (!tied(block)) {
      z.P.block<3, 3>(i, place(block)).setIdentity();
      continue;
    }
    const Tie& t = ties_[tie_of_[block]];
    if (block != t.block) {
      z.P.block<3, 3>(i, place(t.frame + 1)) = t.turn;
      continue;
    }
    z.P.block<3, 3>(i, place(t.frame)).setIdentity();
    if (t.point) continue;
    z.P.block<3, 3>(i, place(t.frame + 1)) = t.frame_point.by_turn();
    z.V.block<3, 3>(i, place(t.frame + 1)) = t.frame_point.velocity_by_turn();
  }
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(z.to.size());
  z.P.conservativeResize(m, size);
  z.V.conservativeResize(m, size);
  return z;
}

}  // namespace hawser
