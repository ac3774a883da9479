// Forces of the sea on platforms by hydrodynamic coefficients: hydrostatics, radiation with its memory, wave
// forces of first and second order, added linear and quadratic damping. See docs/theory/platforms.md.
#pragma once

#include <mpi.h>

#include <memory>
#include <vector>

#include "hawser/kernels/platform_frame.hpp"
#include "hawser/kernels/platform_hydrostatics.hpp"
#include "hawser/kernels/platform_waves.hpp"
#include "hawser/kernels/radiation_memory.hpp"
#include "hawser/kernels/slow_pose.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/hydrodynamic_data.hpp"
#include "hawser/system/depends_on_frequency.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/run_roles.hpp"
#include "hawser/terms/sea.hpp"

namespace hawser {

// Bodies that have coefficients of the same files are one group and radiate on each other. Every rank that
// owns one of a group computes all of it; the owner of a body counts its energy.
class PlatformWater final : public ForceTerm,
                            public CouplesNodes,
                            public ScalesResiduals,
                            public DependsOnFrequency,
                            public ActsOnBodies {
 public:
  PlatformWater(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh);

  std::string_view name() const override { return "platforms in the sea"; }
  bool recouple(const Kinematics& committed, double h) override;
  void couple(Couplings& to) const override;
  void update_ghosts() override;
  void prepare(const Kinematics& committed, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  double dead_load() const override;
  double round_off(const Kinematics& at, double h) const override;
  // Added mass and damping of the rows next to it, straight between them; B = 0 at omega = 0 and beyond the
  // last row.
  void oscillate(double omega) override;
  std::vector<std::string> origins(int body) const override;
  std::vector<BodyForce> forces_on(int body, const Kinematics& at) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> records(NodeRange of) const override;
  // Collective: a rank has the records of its own bodies, and needs the velocities of all of a group.
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  struct Group;
  struct Power {
    double damping = 0, waves = 0;  // W, taken out; brought in
  };
  struct Platform {
    int body = 0;                          // of the case
    int node = 0, local = -1, block = -1;  // of the mesh; local ones
    bool owned = false;
    Mat3 axes = Mat3::Identity();  // H, of its coefficients, in a step
    double follow = 0;             // s, period of the motion that these follow; 0: they stay
    SlowPose slow;                 // of that motion, in the last accepted state
    Vec3 arm = Vec3::Zero();       // m, body's origin from the centre of mass, body axes
    PlatformHydrostatics hydrostatics;
    PlatformPotential potential;  // of the stiffness that is added
    Mat6 damping = Mat6::Zero();
    Mat6 quadratic = Mat6::Zero();
    PlatformWaves waves;
    Vec3 file_origin = Vec3::Zero();  // m, of the files' axes from the body's origin, axes of the heading
    double damping_work = 0, wave_work = 0;  // J, over the accepted steps
    RigidBodyState rest;                     // of statics, in the last iteration
    Power power;                             // of the last accepted state
  };
  // Velocities of a group at the end of an accepted step.
  struct Past {
    double time = 0;
    Eigen::VectorXd rate;
  };
  // Turns axes and wave forces to the slow heading.
  static void turn(Platform& p);
  static Vec3 pose_of(const Platform& p, const RigidBodyState& s);
  // The mean force of the waves at rest, its moment about the body's origin: axes of space.
  static Vec6 mean_force(const Platform& p, const RigidBodyState& s);
  // J, work of that force since the last iteration of statics, which needs a potential.
  static double mean_work(const Platform& p, const RigidBodyState& s);
  static void rest_at(Platform& p, const RigidBodyState& s);
  static void add_past(Group& g, double time, Eigen::VectorXd rate);
  // Forces at a time that do not depend on the trial state: of the waves, and of the memory of accepted
  // steps. The memory of the current step adds damping (rate - rate at its start).
  struct AtTime {
    double time = 0;
    Eigen::VectorXd past, first, second;  // of waves of first and of second order
    Eigen::MatrixXd damping;
  };
  struct Group {
    std::vector<Platform> platforms;
    std::vector<std::pair<int, int>> entries;  // rows and columns of what `memory` has, row <= column
    RadiationMemory memory;
    Eigen::MatrixXd added_mass;        // as `oscillate` has chosen it
    Eigen::MatrixXd harmonic_damping;  // of that frequency; empty: time integration
    // Modes on the stiffness of the potentials alone, 6 N by number of modes: M v with v . M v = 1, and
    // omega² [1/s²]. Empty where a body has a hull, whose stiffness is another one.
    Eigen::MatrixXd modes;
    Eigen::ArrayXd squares;
    std::shared_ptr<const model::HydrodynamicData> data;
    std::vector<int> rows;  // of the data's matrices
    std::vector<Past> past;
    // By step of `past` (none before the first): the change of velocity over its length as the entries of the
    // memory take it, that of their columns, which moves their rows, then that of their rows, 0 on the
    // diagonal. In one piece: the memory is read as a whole in each step.
    std::vector<double> slopes;
    double slow_time = 0;  // s, of the slow poses
    bool here = false;     // this rank owns one of its bodies
    mutable AtTime now;
    mutable bool known = false;
  };
  void add_group(const model::Case& c, const std::vector<int>& bodies);
  Platform platform(const model::Case& c, int body) const;
  static void find_modes(const model::Case& c, Group& g);
  // kg and so on: what is added to the mass of a group so that its free oscillations have their periods in
  // steps of h.
  Eigen::MatrixXd period_mass(const Group& g, double h) const;
  Eigen::VectorXd rates(const Group& g, const Kinematics& at) const;
  const AtTime& at_time(const Group& g, double time) const;
  // The force of damping and memory on a group, and its derivative by the rates.
  void damping(const Group& g, const AtTime& now, const Eigen::VectorXd& rate, Eigen::VectorXd& force,
               Eigen::MatrixXd* slope) const;
  std::vector<Power> powers(const Group& g, double time, const Eigen::VectorXd& rate) const;

  MPI_Comm comm_;
  const LocalMesh& mesh_;
  Sea sea_;
  std::vector<Group> groups_;
  double period_error_ = 0;  // omega² (1 + period_error omega² h²) is what the scheme makes of a frequency
  bool coupled_ = false;
};

}  // namespace hawser
