// Time integration of a system: a PETSc TS whose steps are generalized-alpha steps on the Lie group. SNES
// solves a step, a TSAdapt accepts or rejects it, and an accepted step is committed afterwards
// (lie_alpha_ts.cpp).
#pragma once

#include <petscts.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "hawser/base/deferred_error.hpp"
#include "hawser/base/runs.hpp"
#include "hawser/math/function_ref.hpp"
#include "hawser/solve/event_search.hpp"
#include "hawser/solve/generalized_alpha.hpp"
#include "hawser/solve/kink_stiffness.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "hawser/solve/step_control.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

struct DynamicsSettings {
  double rho_infinity = 0.8;
  double tolerance = 1e-8;  // Of the residual, relative to its contributions.
  int max_iterations = 20;  // Of Newton's method, before a trial counts as failed.
  StepSettings step;
  // Factor of the local error, by line: step.error_tolerance divided by the line's own tolerance. Bodies, and
  // lines without one, have 1.
  Runs<double> error_weight;
};

// What happened in one accepted step.
struct StepInfo {
  double time = 0, h = 0;  // s: time at the end of the step; length of the step.
  int iterations = 0;      // Newton iterations of the accepted trial, as counted by step control.
  int rejected = 0;        // Rejected trials before the accepted one.
  double error = 0;        // m, estimated local error
};

class Dynamics {
 public:
  // Called after every accepted step; false stops the run.
  using Observer = std::function<bool(const StepInfo&)>;

  Dynamics(System& system, const DynamicsSettings& settings);
  // Steps end where one of these functions has risen through zero, within their tolerances. The observer
  // decides what happens then. Events at given times are stops of run() instead.
  void watch(EventFunctions functions) { events_ = std::move(functions); }

  // Starts from positions, rotations and velocities; accelerations come from the mass matrix.
  void start(const State& state);
  // Continues with other nodes tied (local nodes). A node that is no longer tied continues from its position
  // and velocity, and its acceleration jumps. A newly tied node has a plastic impact (docs/theory/events.md).
  // Collective.
  void retie(std::vector<TiedNode> nodes);
  // Adds energy that an event has put into the system (negative: taken from it), J, this rank's share.
  void add_support_work(double work) { support_work_ += work; }
  // The motion from which a node of the mesh continues: position, velocity and acceleration in m and s; for
  // nodes that rotate also the rotation and its rates (material axes, rad and s).
  struct Moved {
    int node = 0;
    Vec3 x, v, a;
    Quat q = Quat::Identity();
    Vec3 w = Vec3::Zero(), alpha = Vec3::Zero();
    bool free = false;  // The node is moved to where the forces on it balance its acceleration.
  };
  // A feeder releases or absorbs a node. `change` makes the change and, on the ranks that have that node,
  // returns its motion; `nodes` returns the tied nodes afterwards. Mean forces and reactions change by the
  // change of the forces of the state; everything else continues. Collective.
  void transfer_node(FunctionRef<std::optional<Moved>()> change, FunctionRef<std::vector<TiedNode>()> nodes);
  // Checkpoint data in addition to the state.
  struct RestartData {
    double step_proposal = 0;
    int step_wait = 0;
    double step_impact_period = 0, step_resolved_until = 0;
    double last_step = 0;
    double support_work = 0;  // J, this rank's share
    MeanForces mean;
  };
  // Continues from a checkpoint; nothing is recomputed. reactions: 3 * local blocks.
  void resume(const AlphaState& state, std::vector<double> reactions, const RestartData& data);

  // Integrates to `until` [s]. Steps end exactly at the times that `next_stop` returns (> its argument).
  // Throws SolveError, naming line, arc length and cause, when the shortest step fails.
  void run(double until, const std::function<double(double)>& next_stop, const Observer& observer);

  const AlphaState& committed() const { return committed_; }
  Kinematics committed_kinematics() const { return step_origin(committed_.s, control_.proposal()); }
  const StepControl& control() const { return control_; }
  double last_step() const { return last_step_; }
  const std::vector<double>& reactions() const { return reactions_; }  // of the committed state
  // Largest change of acceleration in the last accepted step [m/s²], and its node. Collective.
  NodeValue largest_acceleration_change() const;
  const MeanForces& mean_forces() const { return mean_; }
  double support_work() const { return support_work_; }  // J, this rank's share, done by prescribed ends

  // Before a step of length h the terms list the nodes they couple. If that changes the layout, vectors,
  // matrix, solver and the ghosts of the committed state are created again. Then the terms are prepared.
  // `end`: end of a trial that left the path predicted by the rates; null: the rates decide. Collective.
  void prepare(double h, const State* end = nullptr);
  // Called by the TS in every step (lie_alpha_ts.cpp), collective: Prepares the terms for a step from the
  // committed state. Returns the length of its first trial [s].
  double begin_step();
  // Solves for the trial state at the end of a step of h [s]. The terms must have been prepared for a step of
  // h or longer. Returns the number of Newton iterations.
  int try_step(double h);
  // Decides on the last trial (step_decision.cpp). accepted: h is the proposal for the next step [s]; else h
  // is the length of the next trial. Throws SolveError if no step, or no shorter one, can be taken.
  struct Decision {
    bool accepted = false;
    double h = 0;
  };
  Decision decide();
  double trial_time() const { return trial_.s.time; }
  // Commits the accepted trial and calls the observer. False: the run stops.
  bool end_step();
  DeferredError& error() { return error_; }

 private:
  Verdict check_step();
  double next_try() const;
  void commit();
  void build();
  static PetscErrorCode residual(SNES, Vec u, Vec r, void* self);
  static PetscErrorCode tangent(SNES, Vec u, Mat J, Mat, void* self);
  static PetscErrorCode converged(SNES, PetscInt it, PetscReal, PetscReal, PetscReal, SNESConvergedReason*,
                                  void*);
  SNESConvergedReason judge_iteration(SNES snes, int it, double fnorm);
  void update_trial(Vec u);
  void solve_once();
  void set_increment(const std::vector<double>& u);
  std::vector<double> accelerations();
  void match_tied_velocities(const TiedNodes& before, State& s);
  void balance_node(int node);
  // Kinematics of the state from which a step of h [s] begins: the end of the last step, or at the start of a
  // motion its first instant. s: the committed state, or one that replaces it.
  Kinematics step_origin(const State& s, double h) const {
    return last_step_ > 0 ? s.after_step(last_step_) : s.at_start(h);
  }

  System& system_;
  DynamicsSettings settings_;
  AlphaCoefficients alpha_;
  StepControl control_;
  AlphaState committed_, trial_;
  double h_ = 0, last_step_ = 0;
  // The step that is being tried.
  struct StepAttempt {
    StepInfo info;
    bool solved = false;          // Newton's iteration of the last trial converged
    double allowed = HUGE_VAL;    // s, longest step that the terms allow
    double event = HUGE_VAL;      // s from the start of the step to the event that is searched for
    bool prepared_again = false;  // this step has been prepared a second time
    bool overstretched = false;   // an element of some rank, in the last trial
    EventSearch search;
    std::vector<double> at_start;  // values of the event functions at the start of the step
  } attempt_;
  std::vector<double> local_u_, reactions_;
  MeanForces mean_;  // of the committed state
  // part of the mean forces at the end of the step that earlier steps determine, N
  std::vector<double> mean_history_;
  double round_off_step_ = -1;  // s, step for which System has the round-off; < 0: none
  bool copied_ = false;         // trial_ holds all values that a step does not change
  bool trial_current_ = false;  // trial_ is the state of local_u_
  bool old_tangent_ = false;    // the next iteration uses the tangent of an earlier one
  // N, the larger of the first residual of this Newton solution and of its contributions
  double first_ = 0;
  int counted_ = -1;     // iterations until the residual fell below kCounted; < 0: not yet
  KinkStiffness kinks_;  // of an iteration that does not converge without them
  double length_ = 0;    // m, of the longest element
  VecHandle u_, r_;
  MatHandle J_;
  Handle<TS, TSDestroy> ts_;
  SNES snes_ = nullptr;
  ResidualNorms norms_;
  double support_work_ = 0;
  std::function<double(double)> next_stop_;
  Observer observer_;
  EventFunctions events_;
  DeferredError error_;
};

// Sets the type of a TS to "liealpha", whose steps Dynamics computes.
void lie_alpha_attach(TS ts, Dynamics* dynamics);
// Calls TSSetFromOptions. Throws InputError if an option requests another type of TS or another TSAdapt.
void lie_alpha_options(TS ts);

}  // namespace hawser
