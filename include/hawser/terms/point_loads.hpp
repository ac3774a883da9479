// Dead point forces and moments on nodes with a smooth start, and point masses with their weight.
#pragma once

#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/system/force_term.hpp"

namespace hawser {

struct NodeLoad {
  int node = 0;                // local
  Vec3 force = Vec3::Zero();   // N, space axes
  Vec3 moment = Vec3::Zero();  // N m, space axes; the node must have rotations
  double ramp = 0;             // s; 0: acts from statics on; else increases smoothly from zero at t = 0
};

// Loads of a case on the owned nodes, each on the node nearest to its arc length.
std::vector<NodeLoad> point_loads(const model::Case& c, const LocalMesh& mesh);

// Residual: -s(t) F on the position, -s(t) R'M on the rotation block; K of the moment is exact.
class PointLoads final : public ForceTerm, public ScalesResiduals {
 public:
  // Ignores loads on nodes that this rank does not own. Throws std::invalid_argument for a moment on a cable
  // node.
  PointLoads(const LocalMesh& mesh, std::vector<NodeLoad> loads);

  std::string_view checkpoint_key() const override { return "point loads"; }
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  // Constant forces have a potential. Moments and ramped forces do work, summed over the accepted steps by
  // the trapezoidal rule. In statics a moment has a potential too, valid only from the prepared state on.
  Energy energy(const Kinematics& state) const override;
  double dead_load() const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  std::vector<NodeLoad> loads_;
  std::vector<int> block_, global_;
  std::vector<double> length_;  // m, of the line
  std::vector<Vec3> start_;     // positions and
  std::vector<Quat> rotation_;  // rotations of the loaded nodes at the start of the step
  double start_time_ = 0;
  std::vector<double> work_;  // J, by load
};

// Derivative of the residual -R'M by the material rotation increment: -hat(R'M).
Mat3 moment_stiffness(const Quat& rotation, const Vec3& moment);

struct NodeMass {
  int node = 0;     // local
  double mass = 0;  // kg
};

std::vector<NodeMass> point_masses(const model::Case& c, const LocalMesh& mesh);

// Residual m (a + g z): inertia and weight on the position block.
class PointMasses final : public ForceTerm, public ScalesResiduals {
 public:
  PointMasses(const LocalMesh& mesh, std::vector<NodeMass> masses, double gravity);

  std::string_view checkpoint_key() const override { return "point masses"; }
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  Energy energy(const Kinematics& state) const override;
  double dead_load() const override;

 private:
  std::vector<NodeMass> masses_;
  std::vector<int> block_;
  double gravity_ = 0;
};

}  // namespace hawser
