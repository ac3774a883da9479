// The recorded run: its case and the objects that compute it on this rank.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "hawser/io/results.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/solve/dynamics.hpp"
#include "hawser/system/system.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser::record {

// All members must outlive the recordings.
struct Subject {
  const model::Case& model;
  const System& system;
  const Bodies& bodies;
  std::vector<std::shared_ptr<const Surface>> surfaces;  // one per volume of the case
  std::function<Dynamics&()> dynamics;                   // for a case with dynamics

  MPI_Comm comm() const { return system.comm(); }
  const LocalMesh& local() const { return system.mesh(); }
  const Mesh& mesh() const { return *system.mesh().mesh; }
  // Force term of class Term; null: none.
  template <class Term>
  Term* term() const {
    return system.find<Term>();
  }
};

// Pose of a body of the case; for a floating body nullopt except on the rank that owns its node.
std::optional<RigidPose> body_pose(const Bodies& bodies, const LocalMesh& mesh, int body,
                                   const Kinematics& state);
// Poses of all bodies, the same on all ranks; owners of floating bodies send theirs to the others.
// Collective.
std::vector<io::BodyPose> body_poses(const Bodies& bodies, const System& system, const Kinematics& state);

}  // namespace hawser::record
