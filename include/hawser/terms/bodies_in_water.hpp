// Forces of the sea on floating bodies by Morison's equation: on a body as a whole (`in_water`), and on its
// members, in pieces along their length. See docs/theory/bodies-in-water.md.
#pragma once

#include <vector>

#include "hawser/kernels/body_water.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/run_roles.hpp"
#include "hawser/terms/sea.hpp"
#include "hawser/terms/static_rest.hpp"

namespace hawser {

namespace model {
struct Body;
struct BodyMember;
}  // namespace model

class BodiesInWater final : public ForceTerm,
                            public ScalesResiduals,
                            public RestrainedInStatics,
                            public InCurrent,
                            public ActsOnBodies {
 public:
  // Of the bodies of the case that this rank owns.
  BodiesInWater(const model::Case& c, const LocalMesh& mesh);

  // In statics no water acts on bodies that are held where they start (RigidBodies::hold).
  void hold(bool on, bool friction) override {
    hold_ = on;
    friction_ = friction;
  }
  void scale_current(double factor) override { sea_.current_scale = factor; }

  // This rank's bodies that pierce the water surface, by their index in the case.
  std::vector<int> in_surface(const Kinematics& at) const;

  std::string_view name() const override { return "bodies in water"; }
  void prepare(const Kinematics& committed, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  double dead_load() const override;
  double round_off(const Kinematics& at, double h) const override;
  std::vector<std::string> origins(int body) const override;
  std::vector<BodyForce> forces_on(int body, const Kinematics& at) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> records(NodeRange of) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  // Both centres of a body, in space.
  struct Places {
    Vec3 centre = Vec3::Zero(), drag = Vec3::Zero();
  };
  // Forces of the flow, and where they act: buoyancy in still water has a potential.
  struct Flow {
    BodyWaterForce force;
    Places at;
  };
  struct Wet {
    BodyInWater data;                     // in axes of its own,
    Quat axes = Quat::Identity();         // which these turn to those of the body
    int node = 0, block = 0, global = 0;  // local; local block of the position; mesh node
    int body = 0;                         // of the case
    int key = 0;                          // of the body's
    StaticRest rest;
    // Waves are evaluated once a step, at its end and at the centres extrapolated with their velocity.
    Places start, speed;              // m, m/s, at the start of the step
    Places wave_place;                // m, for the state at start_time_
    bool has_wave_place = false;      // wave_place comes from a checkpoint
    mutable WaveMotion centre, drag;  // what they are at `time`
    mutable double time = 0;
    mutable bool known = false;
    Flow flow;  // of the last accepted state; in statics of the last iteration
    bool flowed = false;
    double work = 0;  // J, of the flow over the accepted steps
  };
  // Adds the pieces of a member; `piece` holds what they have in common, such as the node of the body.
  void add_member(const model::Body& body, const model::BodyMember& m, Wet piece);
  // Of the body, in the axes of the data.
  static RigidBodyState state(const Wet& b, const Kinematics& at);
  static Places places(const Wet& b, const RigidBodyState& s);
  Places wave_places(const Wet& b, const Kinematics& at) const;
  Water water(const Wet& b, const Kinematics& at, const Vec3& x, WaveMotion Wet::*wave) const;
  Flow flow(const Wet& b, const Kinematics& at) const;
  bool idle(const Wet& b) const { return hold_ && !b.rest.found(friction_); }

  Sea sea_;
  std::vector<Wet> list_;
  std::vector<bool> has_;  // by body of the case
  bool hold_ = false, friction_ = false;
  double start_time_ = 0;  // s
};

}  // namespace hawser
