// Floating bodies: rigid bodies with mass and weight, and springs towards the pose of their prescribed
// motion. The equations are in kernels/rigid_body.cpp. Ends of lines are attached to bodies in
// solve/start_shape.cpp (hold_ends). system/tied_nodes.hpp moves the ends with the body,
// system/tied_node_forces.hpp transmits their forces to it.
#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "hawser/kernels/body_momentum.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/bodies.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser {

// In statics a spring of 1 rad/s holds a body without other support, and the body's weight does not act. A
// body that has an equilibrium of its own (StaticRest) is only kept from drifting in directions without
// resistance, such as the rotation of a load about its sling.
class RigidBodies final : public ForceTerm,
                          public AppliesExternalLoad,
                          public ScalesResiduals,
                          public RestrainedInStatics {
 public:
  // Builds the term for the bodies with mass of the case that this rank owns. gravity [m/s²] along -z.
  RigidBodies(const model::Case& c, const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies);

  // Force [N] and moment [N m] of lines and contact about the centre of mass of a body, space axes: the
  // remainder of inertia, springs and weight in a balanced state. On the rank that owns the body.
  std::array<Vec3, 2> force_on(int body, const Kinematics& state) const;

  std::string_view checkpoint_key() const override { return "floating bodies"; }
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  double dead_load() const override;
  double round_off(const Kinematics& state, double h) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  struct Load {
    RigidBodyLoad constant;
    std::vector<std::pair<double, Vec6>> table;  // added to the constant load
    RigidBodyLoad at(double time) const;
  };
  struct Floating {
    RigidBodyData data;
    std::vector<Load> loads;
    Vec3 centre;                // m, centre of mass in the body frame
    int body = 0, node = 0;     // index in the case; local node
    int block = 0, global = 0;  // local block of the position; mesh node
    bool has_hull = false;
    RigidBodyState start;                      // at the last prepare()
    MomentumForces momenta;                    // at the last accepted state
    double damping = 0, work = 0;              // J, over the accepted steps
    double damping_power = 0, work_power = 0;  // W, at the start of the step

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("damping", "J", self.damping);
      each("work", "J", self.work);
      each("algorithmic rates of change of the momenta", "N, N m", self.momenta.q);
      each("rates of change of the momenta", "N, N m", self.momenta.f);
    }
  };
  RigidPose spring_rest(const Floating& f, double time) const;
  // Residual of a body. step: inertia from the change of the momenta over the step; else from accelerations.
  RigidBodyResidual residual(const Floating& f, const RigidBodyState& s, const Kinematics& trial,
                             bool step) const;
  void powers(const Floating& f, const Kinematics& state, double& damping, double& work) const;

  std::shared_ptr<const Bodies> bodies_;
  RigidBodyData data(const Floating& f) const;

  MeanWeights scheme_;
  std::vector<Floating> list_;
};

// Start position of the centre of mass of a floating body, and its velocities (w in body axes).
RigidBodyState floating_start(const model::BodyMass& mass, const RigidPose& pose);
// Pose of the body's frame from the state of its centre of mass.
RigidPose floating_pose(const RigidBodyState& s, const Vec3& centre);
RigidBodyState floating_state(const Kinematics& state, int node);

}  // namespace hawser
