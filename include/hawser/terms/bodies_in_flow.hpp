// Forces of wind and current on floating bodies from tables of coefficients. See
// docs/theory/wind-and-current.md.
#pragma once

#include <vector>

#include "hawser/kernels/body_flow.hpp"
#include "hawser/kernels/wind.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/run_roles.hpp"
#include "hawser/terms/sea.hpp"

namespace hawser {

Wind wind_of(const model::Case& c);

// In statics the flow does not act on bodies that are held where they start.
class BodiesInFlow final : public ForceTerm,
                           public AppliesExternalLoad,
                           public RestrainedInStatics,
                           public InCurrent,
                           public ReportsBodyForces {
 public:
  // Builds the term for the bodies of the case that this rank owns.
  BodiesInFlow(const model::Case& c, const LocalMesh& mesh);

  void scale_current(double factor) override { sea_.current_scale = factor; }

  std::vector<std::string> load_components(int body) const override;
  std::vector<BodyForce> forces_on(int body, const Kinematics& state) const override;

  std::string_view checkpoint_key() const override { return "wind and current on bodies"; }
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  // Force at the reference point of the coefficients, position of this point, and rotation of the body.
  struct Push {
    Vec3 force = Vec3::Zero(), place = Vec3::Zero();  // N, m, space axes
    Vec3 moment = Vec3::Zero();                       // N m, body axes
    Quat turned = Quat::Identity();
  };
  struct Flow {
    BodyFlow data;
    bool air = false;   // wind; else current
    double height = 0;  // m above the still water, reference height of the wind coefficients
    int node = 0, block = 0, global = 0;  // local node; local block of its position; mesh node
    int body = 0;                         // index in the case
    Push push;                            // at the last accepted state; in statics at the last iteration
    bool pushed = false;
    double work = 0;  // J, over the accepted steps
  };
  void add(const model::Case& c, int body, int node, const LocalMesh& mesh, bool air);
  FlowVelocity velocity(const Flow& f, const Kinematics& state, const RigidBodyState& s) const;
  Push push(const Flow& f, const Kinematics& state) const;
  static double work(const Push& from, const Push& to);

  Sea sea_;
  Wind wind_;
  std::vector<std::vector<std::string>> load_components_;  // by body of the case
  std::vector<Flow> list_;
};

}  // namespace hawser
