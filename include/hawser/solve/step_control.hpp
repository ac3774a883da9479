// How long the next step is. Pure bookkeeping: no PETSc, no MPI; the same decisions on every rank because
// it is fed with global numbers only.
#pragma once

namespace hawser {

struct StepSettings {
  double fixed = 0;            // s; > 0: this step, halved only when a step fails
  double first = 0.01;         // s, first automatic step
  double longest = 0.1;        // s
  double shortest = 1e-6;      // s
  double error_tolerance = 0;  // m, local error a step; 0: not controlled
  int easy_iterations = 4;     // the step may grow when Newton needed no more
  int hard_iterations = 8;     // and shrinks when it needed more
};

class StepControl {
 public:
  explicit StepControl(const StepSettings& settings);

  // Step from t towards `stop` (an output time or the end), which is hit exactly: the way there is divided
  // into equal steps not longer than the wish, nor, when steps are automatic, than `cap`.
  double next(double t, double stop, double cap) const;
  bool automatic() const { return s_.fixed <= 0; }
  // Whether a converged step is accurate enough; a step at the shortest length always is.
  bool accurate(double h, double error) const;

  void accepted(double h, int iterations, double error);
  // A failed (or inaccurate) step. False when it was the shortest already.
  bool rejected(double h, bool diverged, double error);

  double wish() const { return wish_; }
  void restore(double wish, int wait) { wish_ = wish, wait_ = wait; }
  int wait() const { return wait_; }

 private:
  StepSettings s_;
  double wish_ = 0;
  int wait_ = 0;  // accepted steps before the step may grow again after a failure
};

}  // namespace hawser
