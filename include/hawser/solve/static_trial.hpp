// What searches for an equilibrium share: a state, a trial beside it, an increment with the SNES that finds
// it, and the question whether lines would pass through each other on the way. Configurations are re-based at
// every step, so rotations of any size are met by small increments: the unknown of the SNES is the increment
// from the state.
#pragma once

#include <petscsnes.h>

#include <string>
#include <vector>

#include "hawser/base/carried_error.hpp"
#include "hawser/base/error.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// A line or a volume blocks every step: the message names it.
struct PathBlocked : SolveError {
  using SolveError::SolveError;
};
// Thrown on all ranks where contact stiffness was raised during the search: the search begins again.
struct StiffnessRaised {};

class StaticTrial {
 public:
  // Prepares the system for the state, which outlives this. Collective, as everything here is. PETSc's
  // options of the SNES have the prefix "statics_"; its line search is SNESLINESEARCHBASIC, and Newton's
  // method stays.
  StaticTrial(System& system, State& state);
  virtual ~StaticTrial() = default;

 protected:
  // What SNES asks for. The residual at an increment in local_, to r_:
  virtual void residual() = 0;
  // the tangent there, to J_:
  virtual void tangent() = 0;
  // before every iteration, whether it is the last.
  virtual SNESConvergedReason check_step(int iteration) = 0;

  // Newton's method from the state: why it ended. What the functions above throw comes out of it.
  SNESConvergedReason solve();
  // Anew what depends on ghosts and on the matrix's pattern, also in the middle of solve().
  void build();
  // Once before every step. True: other pairs of lines may touch, so forces are not what they were.
  bool prepare();
  // Longest fraction of the increment local_ that keeps displacements below 5 % of the longest line and turns
  // below half a radian.
  double limit() const;
  // trial = state moved by `factor` times local_.
  void step(double factor);
  // Whether, on the straight way from the state to the trial, no line goes through another or through a
  // volume, nor deeper into a volume than its contact law is for. Where the candidates were not chosen for
  // that way they are chosen anew.
  bool path_is_clear();
  // Throws the end of a search that has no further step: PathBlocked where something blocks the path,
  // StiffnessRaised where automatic contact can be made stiffer, else SolveError with that sentence.
  [[noreturn]] void throw_no_equilibrium(const std::string& why);
  // Push off a saddle: a fixed, rank-independent displacement field without symmetry, larger with `attempt`
  // (1, 2, ...); less of it where lines would pass through each other.
  void perturb(int attempt);
  void accept_trial() {
    std::swap(state_.x, trial_.x);
    std::swap(state_.q, trial_.q);
  }

  double sum(double x) const;
  // Strain energy and potential over all ranks, J.
  double potential(const State& s) const;
  // Close enough for the exact tangent.
  bool near(const ResidualNorms& n) const;

  void push(int attempt, double share, State& s) const;

  System& system_;
  State& state_;
  State trial_;
  CarriedError error_;
  Handle<SNES, SNESDestroy> snes_;
  VecHandle x_, f_;  // its unknown and its residual
  VecHandle u_, r_;  // an increment and a residual, with the ghosts of the moment
  MatHandle J_;
  KspHandle ksp_;
  std::vector<double> local_, zero_;  // 3 * local blocks: an increment; nothing
  double length_ = 0;                 // m, of the longest element
  // What blocks the path to the last trial that was not clear, in words, and that trial; empty: nothing.
  std::string blocked_by_;
  State blocked_;
};

}  // namespace hawser
