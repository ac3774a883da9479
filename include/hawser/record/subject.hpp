// What is recorded of a run: its case and the parts that compute it on this rank.
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

// All of it outlives what records it.
struct Subject {
  const model::Case& model;
  const System& system;
  const Bodies& bodies;
  std::vector<std::shared_ptr<const Surface>> surfaces;  // one for each volume of the case
  std::function<Dynamics&()> dynamics;                   // of a case with dynamics

  MPI_Comm comm() const { return system.comm(); }
  const LocalMesh& local() const { return system.mesh(); }
  const Mesh& mesh() const { return *system.mesh().mesh; }
  // Its force term of that class; null: there is none.
  template <class Term>
  Term* term() const {
    return system.find<Term>();
  }
};

// Where a body of the case is; of a floating one only the rank that owns its node knows: nullopt elsewhere.
std::optional<RigidPose> body_pose(const Bodies& bodies, const LocalMesh& mesh, int body,
                                   const Kinematics& at);
// Of all bodies, the same on all ranks: of floating ones the rank that owns them sends its pose to the
// others. Collective.
std::vector<io::BodyPose> body_poses(const Bodies& bodies, const System& system, const Kinematics& at);

}  // namespace hawser::record
