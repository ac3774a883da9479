// Forces of the sea on floating bodies by Morison's equation: on a body as a whole (`in_water`), and on
// pieces of its members. See docs/theory/bodies-in-water.md.
#pragma once

#include <vector>

#include "hawser/kernels/body_water.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/run_roles.hpp"
#include "hawser/terms/sea.hpp"

namespace hawser {

namespace model {
struct Body;
struct BodyMember;
}  // namespace model

// In statics the water does not act on bodies that are held where they start.
class BodiesInWater final : public ForceTerm,
                            public AppliesExternalLoad,
                            public ScalesResiduals,
                            public RestrainedInStatics,
                            public InCurrent,
                            public ReportsBodyForces {
 public:
  // Builds the term for the bodies of the case that this rank owns.
  BodiesInWater(const model::Case& c, const LocalMesh& mesh);

  void scale_current(double factor) override { sea_.current_scale = factor; }

  // Indices in the case of this rank's bodies that pierce the water surface.
  std::vector<int> in_surface(const Kinematics& state) const;

  std::string_view checkpoint_key() const override { return "bodies in water"; }
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  double dead_load() const override;
  double round_off(const Kinematics& state, double h) const override;
  std::vector<std::string> load_components(int body) const override;
  std::vector<BodyForce> forces_on(int body, const Kinematics& state) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  // Positions of a body's centres of buoyancy and of drag, space axes, m.
  struct Places {
    Vec3 centre = Vec3::Zero(), drag = Vec3::Zero();
  };
  // Forces of the water and their points of application.
  struct Flow {
    BodyWaterForce force;
    Places at;
  };
  struct Wet {
    BodyInWater data;                     // in the piece's own axes
    Quat axes = Quat::Identity();         // from those axes to the body's
    int node = 0, block = 0, global = 0;  // local node; local block of its position; mesh node
    int body = 0;                         // index in the case
    int key = 0;                          // distinguishes the records of one body
    // Waves are evaluated once a step, for its end, at the centres extrapolated with their velocities.
    Places start, speed;              // m, m/s, at the start of the step
    Places wave_place;                // m, where waves were evaluated for the state at start_time_
    bool has_wave_place = false;      // whether wave_place is set
    mutable WaveMotion centre, drag;  // wave motion at `time`
    mutable double time = 0;
    mutable bool known = false;
    Flow flow;  // at the last accepted state; in statics at the last iteration
    bool flowed = false;
    double work = 0;  // J, work of the flow over the accepted steps
  };
  // Adds the pieces of a member. `piece` holds the data that they share, such as the body's node.
  void add_member(const model::Body& body, const model::BodyMember& m, Wet piece);
  // State of the body in the axes of b.data.
  static RigidBodyState body_state(const Wet& b, const Kinematics& state);
  static Places places(const Wet& b, const RigidBodyState& s);
  Places wave_places(const Wet& b, const Kinematics& state) const;
  Water water(const Wet& b, const Kinematics& state, const Vec3& x, WaveMotion Wet::*wave) const;
  // All forces of the water on a body in the state s of `state`.
  Flow all_forces(const Wet& b, const RigidBodyState& s, const Kinematics& state) const;
  // The same without the buoyancy in still water, which has a potential.
  Flow flow(const Wet& b, const Kinematics& state) const;

  Sea sea_;
  std::vector<Wet> list_;
  std::vector<bool> has_;  // by body of the case
  double start_time_ = 0;  // s
};

}  // namespace hawser
