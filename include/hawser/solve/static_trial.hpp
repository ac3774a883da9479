// Common base of the searches for an equilibrium: a state, a trial beside it, an increment with the SNES that
// finds it, and the test whether lines would pass through each other between state and trial. The unknown of
// the SNES is the increment from the state, and the configuration is re-based at every step, so that
// rotations of any size are reached by small increments.
#pragma once

#include <petscsnes.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/deferred_error.hpp"
#include "hawser/base/error.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// A line or a volume blocks every step; the message names it.
struct PathBlocked : SolveError {
  using SolveError::SolveError;
};
// Thrown on all ranks if contact stiffness was raised during the search; the search must begin again.
struct StiffnessRaised {};

class StaticTrial {
 public:
  // Prepares the system for the state, which must outlive this object. All functions are collective. PETSc's
  // options of the SNES have the prefix "statics_". Its line search is SNESLINESEARCHBASIC, and its type is
  // always Newton's method.
  StaticTrial(System& system, State& state);
  virtual ~StaticTrial() = default;

 protected:
  // SNES calls the following. The residual at the increment local_, to r_:
  virtual void residual() = 0;
  // The tangent there, to J_:
  virtual void tangent() = 0;
  // Called before every iteration, after the residual; returns whether it is the last.
  virtual SNESConvergedReason test_convergence(int iteration) = 0;

  // Runs Newton's method from the state and returns why it ended. Throws what the functions above throw.
  SNESConvergedReason solve();
  // Creates again everything that depends on ghosts and on the matrix's pattern, also during solve().
  void build();
  // Prepares the terms for the present state, before every iteration. True: other pairs of lines may touch,
  // so the forces have changed.
  bool prepare();
  // Size of the increment local_ relative to the longest step: displacements of 5 % of the longest line, or
  // rotations of half a radian.
  double relative_size() const;
  // Largest fraction of the increment that is no longer than this step.
  double largest_factor() const { return 1 / std::max(1.0, relative_size()); }
  // trial_ = state_ moved by `factor` times local_.
  void move_trial(double factor);
  // True if, on the straight path from the state to the trial, no line passes through another or through a
  // volume, or penetrates a volume beyond the range of its contact law. Chooses new candidates if the present
  // ones do not cover that path.
  bool path_is_clear();
  // Ends a search that has no further step: throws PathBlocked if something blocks the path, StiffnessRaised
  // if automatic contact stiffness can be raised, else SolveError with that sentence.
  [[noreturn]] void throw_no_equilibrium(const std::string& why);
  // Pushes the state away from a saddle point, by a fixed displacement field without symmetry that does not
  // depend on the ranks. It increases with `attempt` (1, 2, ...) and is reduced if lines would pass through
  // each other.
  void push_state(int attempt);
  void accept_trial() {
    std::swap(state_.x, trial_.x);
    std::swap(state_.q, trial_.q);
  }

  // Iterations or steps after which a search tests its progress.
  static constexpr int kWatched = 50;
  // Progress since the last call, from the state there.
  struct Progress {
    bool halved = false;     // the imbalance
    bool stagnates = false;  // the imbalance has not halved, and no node has moved noticeably
  };
  Progress progress(const ResidualNorms& now);
  void forget_progress() { last_imbalance_ = HUGE_VAL; }

  double sum_of_ranks(double x) const;
  // Strain energy and potential over all ranks, J.
  double potential(const State& s) const;
  // True if the residual is small enough for the exact tangent.
  bool tangent_trusted(const ResidualNorms& n) const;

  void displace(int attempt, double fraction, State& s) const;

  System& system_;
  State& state_;
  State trial_;
  DeferredError error_;
  Handle<SNES, SNESDestroy> snes_;
  VecHandle x_, f_;  // unknown and residual of the SNES
  VecHandle u_, r_;  // an increment and a residual, with the present ghosts
  MatHandle J_;
  KspHandle ksp_;
  std::vector<double> local_, zero_;  // 3 * local blocks: the increment; zeros
  double length_ = 0;                 // m, length of the longest element
  double longest_ = 0;                // m, longest line; for bodies alone a suitable length
  int layout_ = 0;                    // how often build() has created the vectors
  // The obstacle on the path to the last blocked trial, and that trial; nullopt on all ranks: none.
  std::optional<advice::StepFinding> blocked_by_;
  State blocked_;

 private:
  std::vector<Vec3> last_places_;     // places of owned nodes at the last test of the progress
  double last_imbalance_ = HUGE_VAL;  // relative imbalance at that test
};

}  // namespace hawser
