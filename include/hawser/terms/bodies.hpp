// The poses of the bodies of a case. A prescribed motion gives the pose at any time. A body with mass, or one
// that rides on a line, floats: it is a node of the mesh, and its pose is part of the state.
#pragma once

#include <mpi.h>

#include <vector>

#include "hawser/kernels/motion.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser {

class Bodies {
 public:
  Bodies() = default;
  explicit Bodies(std::vector<RigidMotion> motions) : motions_(std::move(motions)) {}
  // Throws std::invalid_argument for a motion that makes no sense (model::check has refused it before).
  explicit Bodies(const std::vector<model::Body>& bodies);

  // Bodies with mass and those that ride on lines are part of the states of `mesh` from now on.
  void in_state(const model::Case& c, const LocalMesh& mesh);

  // Fixes those that ride on lines and are drawn in space to their nodes as they are in the start shape.
  // Collective.
  void fix_drawn(MPI_Comm comm, const model::Case& c, const Kinematics& start);

  int size() const { return static_cast<int>(motions_.size()); }
  // Whether its motion is an unknown.
  bool floats(int body) const { return body >= 0 && frame(body) >= 0; }
  // Mesh node of a body that floats; its local node, or -1 where this rank does not see it.
  int frame(int body) const {
    return static_cast<std::size_t>(body) < frames_.size() ? frames_[body].node : -1;
  }
  int local_node(int body) const { return floats(body) ? mesh_->find(frame(body)) : -1; }
  // A point or a direction of the frame of a body that floats, as its node sees it: from there, in its axes.
  Vec3 in_node_axes(int body, const Vec3& y, bool direction) const {
    const Frame& f = frames_[body];
    return f.turn * (direction ? y : Vec3(y - f.centre));
  }
  // Sends the poses of floating bodies to all ranks, for those ranks that do not have a body's node.
  // Collective.
  void exchange_poses(MPI_Comm comm, const Kinematics& at) const;
  // Its pose in a state, the identity where body < 0. Of a body of the state whose node this rank does not
  // see: as of the last exchange.
  RigidPose pose(int body, const Kinematics& at) const;
  // The prescribed pose, or of a body that floats where its springs pull it to. body < 0: fixed in space, the
  // identity.
  RigidPose pose(int body, double time) const { return body < 0 ? RigidPose{} : motions_[body].at(time); }
  bool moves(int body) const { return body >= 0 && motions_[body].moves(); }

 private:
  struct Frame {
    int node = -1;                 // of the mesh
    Vec3 centre = Vec3::Zero();    // m, of the node, body frame
    Quat turn = Quat::Identity();  // body axes to the node's
    mutable RigidPose exchanged;   // where the node is of another rank
  };
  std::vector<RigidMotion> motions_;
  std::vector<Frame> frames_;
  const LocalMesh* mesh_ = nullptr;
};

}  // namespace hawser
