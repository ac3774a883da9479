// Time integration of a system: a PETSc TS whose steps are generalized-alpha steps on the Lie group. SNES
// solves them, a TSAdapt judges them, and what is accepted is committed after the step (lie_alpha_ts.cpp).
#pragma once

#include <petscts.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "hawser/base/carried_error.hpp"
#include "hawser/solve/event_search.hpp"
#include "hawser/solve/generalized_alpha.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "hawser/solve/step_control.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

struct DynamicsSettings {
  double rho_infinity = 0.8;
  double tolerance = 1e-8;  // of the residual, against the size of its contributions
  int max_iterations = 20;  // Newton, before a step counts as failed
  StepSettings step;
  // By line: step.error_tolerance over that of the line; of bodies, and where there is none: 1.
  std::vector<double> strictness;
};

// What happened in one accepted step.
struct StepInfo {
  double time = 0, h = 0;  // s, at its end; its length
  int iterations = 0;      // Newton, of the accepted try, as step control counts them
  int rejected = 0;        // tries before it
  double error = 0;        // m, estimated local error
};

class Dynamics {
 public:
  // Called after every accepted step; false stops the run.
  using Observer = std::function<bool(const StepInfo&)>;

  Dynamics(System& system, const DynamicsSettings& settings);
  // Steps end where one of these functions has risen through zero, within their tolerances. What then happens
  // is up to the observer. Events at times are stops of run().
  void watch(EventFunctions functions) { events_ = std::move(functions); }

  // Starts from positions, rotations and velocities; accelerations come from the mass matrix.
  void start(const State& state);
  // Goes on with other nodes tied, of the local ones: what they held before moves on from where it is, with
  // accelerations that jump; what they hold anew is caught in a plastic impact (docs/theory/events.md).
  // Collective.
  void release(std::vector<TiedNode> nodes);
  // Energy that an event has put into the system or taken from it, J, of this rank's share.
  void add_support_work(double work) { support_work_ += work; }
  // How a node of the mesh goes on: position, velocity and acceleration in m and s, node axes and their rates
  // where it rotates (material, rad and s).
  struct Moved {
    int node = 0;
    Vec3 x, v, a;
    Quat q = Quat::Identity();
    Vec3 w = Vec3::Zero(), alpha = Vec3::Zero();
    bool free = false;  // it settles where the forces on it are in balance with its acceleration
  };
  // A feeder releases a node or catches one: `change` makes the change and returns the motion of that node,
  // on the ranks that have it. Mean forces and reactions change by as much as the forces of the state do; all
  // else goes on as it did. Collective.
  void transfer_node(const std::function<std::optional<Moved>()>& change,
                     const std::function<std::vector<TiedNode>()>& nodes);
  // What a checkpoint carries beside the state.
  struct Carried {
    double step_proposal = 0;
    int step_wait = 0;
    double step_impact_period = 0, step_resolved_until = 0;
    double last_step = 0;
    double support_work = 0;  // J, this rank's share
    MeanForces mean;
  };
  // Starts from a checkpoint: nothing is recomputed. reactions: 3 * local blocks.
  void resume(const AlphaState& state, std::vector<double> reactions, const Carried& carried);

  // Integrates to `until` [s]; steps end exactly at the times `next_stop` names (> its argument).
  // Throws SolveError, naming line, arc length and cause, when the shortest step fails.
  void run(double until, const std::function<double(double)>& next_stop, const Observer& observer);

  const AlphaState& committed() const { return committed_; }
  Kinematics kinematics() const { return committed_.s.view(last_step_); }
  const StepControl& control() const { return control_; }
  double last_step() const { return last_step_; }
  const std::vector<double>& reactions() const { return reactions_; }  // of the committed state
  // Where the last accepted step changed accelerations most, and by how much [m/s²]. Collective.
  NodeValue largest_acceleration_change() const;
  const MeanForces& mean_forces() const { return mean_; }
  double support_work() const { return support_work_; }  // J, this rank's share, done by prescribed ends

  // Before a step of h: terms say who sees whom, and where that is new vectors, matrix, solver and ghosts of
  // the committed state are made anew; then the terms are prepared. Where a step went another way than the
  // rates foretell, `end` is where it led. Collective.
  void prepare(double h, const State* end = nullptr);
  // What the TS asks for, step by step (lie_alpha_ts.cpp), collective:
  // Prepares the terms for a step from the committed state; the length of its first try [s].
  double begin_step();
  // A try of h [s], for which the terms were prepared, or for a longer one: solves for the trial state.
  // Newton's iterations.
  int try_step(double h);
  // What becomes of the last try (step_decision.cpp): accepted, with a proposal for the next step, or to be
  // tried again with h [s]. SolveError where no step can help, or none shorter.
  struct Decision {
    bool accepted = false;
    double h = 0;
  };
  Decision decide();
  double trial_time() const { return trial_.s.time; }
  // Commits the accepted trial and tells the observer. False: the run stops.
  bool end_step();
  CarriedError& error() { return error_; }

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
  void load(Vec u);
  void solve_once();
  void put(const std::vector<double>& u);
  std::vector<double> solve_masses();
  void match_tied_velocities(const TiedNodes& before, State& s);
  void settle(int node, double h);

  System& system_;
  DynamicsSettings settings_;
  AlphaCoefficients alpha_;
  StepControl control_;
  AlphaState committed_, trial_;
  double h_ = 0, last_step_ = 0;
  // The step that is being tried.
  struct Tries {
    StepInfo info;
    bool solved = false;          // Newton's iteration of the last try converged
    double allowed = HUGE_VAL;    // s, by the terms
    double event = HUGE_VAL;      // s, within it, where an event is looked for
    bool prepared_again = false;  // in the middle of it
    EventSearch search;
    std::vector<double> at_start;  // what the events are looked for by, before the first try
  } tries_;
  std::vector<double> local_u_, reactions_;
  MeanForces mean_;              // of the committed state
  std::vector<double> carried_;  // what they add to the residuals of the step
  double expected_ = -1;         // s, the step of the last System::expect()
  bool copied_ = false;          // trial_ has all that a step leaves alone
  bool loaded_ = false;          // trial_ belongs to local_u_
  bool old_tangent_ = false;     // of an iteration before
  double first_ = 0;  // N, size of the first residual of this Newton solution, and of what makes it up
  int counted_ = -1;  // iterations to a residual far above rounding; < 0: not there yet
  VecHandle u_, r_;
  MatHandle J_;
  Handle<TS, TSDestroy> ts_;
  SNES snes_ = nullptr;
  ResidualNorms norms_;
  double support_work_ = 0;
  std::function<double(double)> next_stop_;
  Observer observer_;
  EventFunctions events_;
  CarriedError error_;
};

// Makes a TS one of the type "liealpha", which steps by what Dynamics has for it.
void lie_alpha_attach(TS ts, Dynamics* dynamics);
// TSSetFromOptions. InputError where an option asks for another type, or for another judge of its steps.
void lie_alpha_options(TS ts);

}  // namespace hawser
