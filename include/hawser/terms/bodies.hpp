// Poses of the bodies of a case. A prescribed motion defines the pose at any time. A body with mass, or one
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
  // Throws std::invalid_argument for an invalid motion; model::check refuses those before.
  explicit Bodies(const model::Entries<model::Body>& bodies);

  // Makes bodies with mass and bodies that ride on lines part of the states of `mesh`.
  void in_state(const model::Case& c, const LocalMesh& mesh);

  // Attaches bodies that ride on lines and are drawn in space to their nodes, at their relative pose in the
  // start shape. Collective.
  void fix_placed_in_space(MPI_Comm comm, const model::Case& c, const Kinematics& start);

  int size() const { return static_cast<int>(motions_.size()); }
  // True if the motion of the body is an unknown.
  bool floats(int body) const { return body >= 0 && frame(body) >= 0; }
  // Mesh node of a floating body, and its local node (-1: not on this rank).
  int frame(int body) const {
    return static_cast<std::size_t>(body) < frames_.size() ? frames_[body].node : -1;
  }
  int local_node(int body) const { return floats(body) ? mesh_->find(frame(body)) : -1; }
  // Converts a point or a direction from the frame of a floating body to the axes of its node, with the node
  // as origin.
  Vec3 in_node_axes(int body, const Vec3& y, bool direction) const {
    const Frame& f = frames_[body];
    return f.turn * (direction ? y : Vec3(y - f.centre));
  }
  // Sends the poses of floating bodies to all ranks, for ranks that lack a body's node. Collective.
  void exchange_poses(MPI_Comm comm, const Kinematics& state) const;
  // Pose of the body in a state; the identity if body < 0. If this rank does not have the node of a floating
  // body, the pose is that of the last exchange.
  RigidPose pose(int body, const Kinematics& state) const;
  // Prescribed pose; for a floating body the pose in which its springs are at rest. body < 0: fixed in space,
  // the identity.
  RigidPose pose(int body, double time) const { return body < 0 ? RigidPose{} : motions_[body].at(time); }
  bool moves(int body) const { return body >= 0 && motions_[body].moves(); }

 private:
  struct Frame {
    int node = -1;                 // of the mesh
    Vec3 centre = Vec3::Zero();    // m, the node's position in the body frame
    Quat turn = Quat::Identity();  // from body axes to node axes
    mutable RigidPose exchanged;   // used where another rank has the node
  };
  std::vector<RigidMotion> motions_;
  std::vector<Frame> frames_;
  const LocalMesh* mesh_ = nullptr;
};

}  // namespace hawser
