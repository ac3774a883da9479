// Forces of the sea on platforms from hydrodynamic coefficients: hydrostatics, radiation with memory, wave
// forces of first and second order, added linear and quadratic damping. See docs/theory/platforms.md.
#pragma once

#include <memory>
#include <vector>

#include "hawser/base/shared.hpp"
#include "hawser/kernels/platform_frame.hpp"
#include "hawser/kernels/platform_hydrostatics.hpp"
#include "hawser/kernels/platform_waves.hpp"
#include "hawser/kernels/slow_pose.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/hydrodynamic_data.hpp"
#include "hawser/model/platform.hpp"
#include "hawser/model/platform_memory.hpp"
#include "hawser/system/depends_on_frequency.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/run_roles.hpp"
#include "hawser/terms/sea.hpp"

namespace hawser {

// Bodies with coefficients from the same files form a group and radiate on each other. Every rank that owns a
// body of a group computes the whole group, and no other rank has data of it; the owner of a body counts its
// energy.
class PlatformWater final : public ForceTerm,
                            public AppliesExternalLoad,
                            public CouplesFixedNodes,
                            public ScalesResiduals,
                            public DependsOnFrequency,
                            public ReportsBodyForces {
 public:
  PlatformWater(const model::Case& c, const LocalMesh& mesh);

  std::string_view checkpoint_key() const override { return "platforms in the sea"; }
  void list_couplings(Couplings& to) const override;
  void renumber() override;
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  double dead_load() const override;
  double round_off(const Kinematics& state, double h) const override;
  // Uses the added mass and damping at `omega` [rad/s], interpolated linearly between the rows of the data; B
  // = 0 at omega = 0 and beyond the last row.
  void set_frequency(std::optional<double> omega) override;
  // Bodies without wave forces in their files, or with `excitation: false`, have none.
  std::vector<Excitation> excitation(const std::vector<WaveComponent>& waves,
                                     const Kinematics& state) const override;
  std::vector<std::string> load_components(int body) const override;
  std::vector<BodyForce> forces_on(int body, const Kinematics& state) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  // The record of a body has the history of its whole group.
  void restore(const std::vector<CheckpointRecord>& records) override;

 private:
  struct Group;
  struct Power {
    double damping = 0, waves = 0;  // W, dissipated; supplied
  };
  struct Platform {
    int body = 0;                          // index in the case
    int node = 0, local = -1, block = -1;  // mesh node; local node and block
    bool owned = false;
    Mat3 axes = Mat3::Identity();  // H, axes of velocities and forces during a step
    double follow_period = 0;      // s, period of the slow motion that the axes follow; 0: fixed
    WavePose slow;                 // slow motion at the last accepted state
    Vec3 arm = Vec3::Zero();       // m, from the centre of mass to the body's origin, body axes
    PlatformHydrostatics hydrostatics;
    PlatformPotential potential;  // of the added stiffness
    Mat6 added_damping = Mat6::Zero();
    Mat6 added_quadratic_damping = Mat6::Zero();
    Shared<model::BodyHydrodynamics> coefficients;
    Eigen::Vector2d phase_point;  // m, of the wave forces, from the origin of the files, axes of the heading
    PlatformWaves waves;
    Vec3 file_origin = Vec3::Zero();  // m, origin of the files from the body's origin, axes of the heading
    double damping_work = 0, wave_work = 0;  // J, over the accepted steps
    RigidBodyState last_iterate;             // in statics, at the last iteration
    Power power;                             // at the last accepted state
  };
  // Velocities of a group at the end of an accepted step.
  struct Past {
    double time = 0;
    Eigen::VectorXd rate;
  };
  // Turns axes and wave forces to the slow heading.
  static void turn(Platform& p);
  // Mean force of the waves at rest, and its moment about the body's origin, space axes.
  static Vec6 mean_force(const Platform& p, const RigidBodyState& s);
  // Work of the mean force since the last iteration of statics, J; statics needs a potential.
  static double mean_work(const Platform& p, const RigidBodyState& s);
  static void rest_at(Platform& p, const RigidBodyState& s);
  void begin_memory(Group& g, const Kinematics& start) const;
  static void add_past(Group& g, double time, Eigen::VectorXd rate);
  // Computes the rows of Group::lags that accepted steps of one length have in common.
  static void tabulate_lags(Group& g);
  // S of the memory at lag [s] by entry: a row of Group::lags, or evaluated to `buffer`; with `dS` also S'.
  static const double* integrals_at(const Group& g, double lag, double* buffer, double* dS);
  // Forces at a given time that do not depend on the trial state: of waves, and of the memory of accepted
  // steps. The memory of the current step adds memory_damping (rate - rate at its start).
  struct KnownForces {
    double time = 0;
    Eigen::VectorXd memory_force;
    Eigen::VectorXd first_order, second_order;  // of waves
    Eigen::MatrixXd memory_damping;
  };
  struct Group {
    std::vector<Platform> platforms;
    std::shared_ptr<const model::PlatformMemory> radiation;  // shared by groups of equal platforms
    Eigen::MatrixXd added_mass;                              // at the frequency of set_frequency()
    Eigen::MatrixXd harmonic_damping;                        // at that frequency; empty: time integration
    // Modes for the stiffness of the potentials alone, 6 N by number of modes, with v . M v = 1, and their
    // omega² [1/s²]. Empty if a body has a hull, whose stiffness differs.
    Eigen::MatrixXd modes;
    Eigen::ArrayXd squares;
    std::shared_ptr<const model::HydrodynamicData> data;
    std::vector<Past> past;
    // Mean accelerations of the theory, by row of `past` and by entry of the memory. Row k is a_k-1, of the
    // step that ends at past[k]; row 0 is zero. In a row: first for all columns, which act on the rows, then
    // for all rows, which act on the columns (0 on the diagonal). Contiguous, because each step reads the
    // whole memory.
    std::vector<double> accelerations;
    // S of the memory at m lag_step [s], by m = 0, 1, ... and by entry, as far as accepted steps have that
    // length: they are the same in every step. lag_step is the length of the last accepted step, from the
    // first of equal steps (their lengths differ by rounding).
    double lag_step = 0;
    std::vector<double> lags;
    double slow_time = 0;      // s, time of the slow poses
    bool is_complete = false;  // this rank has all bodies of the group, owned or as ghosts
    mutable KnownForces cache;
    mutable bool is_cached = false;
  };
  void add_group(const model::Case& c, const std::vector<int>& bodies,
                 std::shared_ptr<const model::PlatformMemory> radiation);
  Platform platform(const model::Case& c, int body) const;
  // First-order forces of a body with their phases at its phase point; none: it has none.
  WaveForceTable first_order_table(const Platform& p) const;
  PlatformWaves platform_waves(const Platform& p, double heading) const;
  // Position of the origin of the files at a time for the phases of waves, m.
  static Vec3 wave_origin(const Group& g, const Platform& p, double time);
  static void find_modes(const model::Case& c, Group& g);
  // Mass [kg and so on] added to that of a group so that its free oscillations have the correct periods in
  // steps of h [s].
  Eigen::MatrixXd period_mass(const Group& g, double h) const;
  Eigen::VectorXd rates(const Group& g, const Kinematics& state) const;
  const KnownForces& known_forces(const Group& g, double time) const;
  // Parts of known_forces(): of the memory of a group with a past; of waves.
  static void memory_forces(const Group& g, KnownForces& now);
  void wave_forces(const Group& g, KnownForces& now) const;
  // Force of damping and memory on a group, and its derivative by the rates.
  void damping_and_memory(const Group& g, const KnownForces& now, const Eigen::VectorXd& rate,
                          Eigen::VectorXd& force, Eigen::MatrixXd* slope) const;
  std::vector<Power> powers(const Group& g, double time, const Eigen::VectorXd& rate) const;

  const LocalMesh& mesh_;
  Sea sea_;
  std::vector<bool> on_body_;  // by body of the case: it has coefficients; the same on all ranks
  std::vector<Group> groups_;  // with a body of this rank
  double period_error_ = 0;    // the scheme changes omega² to omega² (1 + period_error_ omega² h²)
};

}  // namespace hawser
