// Dynamic positioning: thrusters keep position and heading of floating bodies by their slow motion. See
// docs/theory/positioning.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hawser/kernels/slow_pose.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser {

class DynamicPositioning final : public ForceTerm, public AppliesExternalLoad, public ReportsBodyForces {
 public:
  // Builds the term for the bodies of the case that this rank owns.
  DynamicPositioning(const model::Case& c, const LocalMesh& mesh);

  // Behaviour at rest. true, as in statics: the integral part holds the position. false, as for modes: the
  // integral is constant, and the proportional part acts on motion about rest.
  void integrate_at_rest(bool on) { integrates_ = on; }

  std::string_view checkpoint_key() const override { return "dynamic positioning"; }
  std::vector<std::string> load_components(int body) const override;
  std::vector<BodyForce> forces_on(int body, const Kinematics& state) const override;
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  // Forces in x and y [N] and moment about the vertical [N m] at the body's origin, and their derivative by
  // its x, y [m] and heading [rad].
  struct Thrust {
    Vec3 force = Vec3::Zero();   // space axes
    Vec3 demand = Vec3::Zero();  // before limits, axes of the slow heading
    Mat3 by_pose = Mat3::Zero();
    bool force_limited = false, moment_limited = false;
  };
  // Demand within the limits, axes of the slow heading, and its derivative by the demand.
  struct Delivered {
    Vec3 force = Vec3::Zero();
    Mat3 by_demand = Mat3::Identity();
    bool force_limited = false, moment_limited = false;
  };
  // Input of the controller: offset, velocity and time integral of the offset, space axes, and their
  // derivatives by the body's pose.
  struct Deviation {
    double heading = 0;  // rad, slow
    Vec3 offset = Vec3::Zero(), speed = Vec3::Zero(), sum = Vec3::Zero();
    double by_place = 1, by_speed = 0, by_sum = 0;
  };
  // Force and pose at one end of a step, for the work of the force over the step.
  struct WorkPoint {
    Vec3 force = Vec3::Zero(), origin = Vec3::Zero();
    Quat rotation = Quat::Identity();
  };
  struct Positioned {
    model::DynamicPositioning data;
    Vec3 target = Vec3::Zero(), arm = Vec3::Zero();  // x, y, heading; from centre of mass to origin
    int node = 0, block = 0, global = 0, body = 0;   // local node; local block; mesh node; body of the case
    ControllerPose slow;                             // at the last accepted state, at `time`
    Vec3 integral = Vec3::Zero();                    // time integral of the offset, space axes: m s, rad s
    double time = 0, work = 0;                       // s, J
    bool begun = false;
    WorkPoint last;  // at the last accepted state; in statics at the last iteration
  };
  static Vec3 offset(const Positioned& p, const Vec3& pose);
  // only_integral_axis: at rest, the one of surge (0) and sway (1) that alone has an integral part; -1: none.
  static Delivered limited(const model::DynamicPositioning& data, const Vec3& demand, int only_integral_axis);
  static Thrust thrust(const model::DynamicPositioning& data, const Deviation& deviation,
                       int only_integral_axis = -1);
  Thrust thrust(const Positioned& p, const Kinematics& state) const;
  Thrust thrust_at_rest(const Positioned& p, const Vec3& pose) const;
  static Thrust thrust_in_motion(const Positioned& p, const Vec3& pose, double time);
  static WorkPoint work_point(const Positioned& p, const Kinematics& state, const Thrust& now);
  // J, of the mean force over the displacement.
  static double work(const WorkPoint& from, const WorkPoint& to);
  static void begin(Positioned& p, const Vec3& pose, double time);

  bool statics_, integrates_ = true;
  std::vector<bool> has_;  // by body of the case
  std::vector<Positioned> list_;
};

}  // namespace hawser
