// What searches for an equilibrium share: a state, a trial beside it, an increment and its linear system, and
// the question whether lines would pass through each other on the way. Configurations are re-based at every
// step, so rotations of any size are met by small increments.
#pragma once

#include <string>
#include <vector>

#include "hawser/solve/linear_solver.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

class StaticTrial {
 public:
  // Prepares the system for the state, which outlives this. Collective, as everything here is.
  StaticTrial(System& system, State& state);

 protected:
  // Anew what depends on ghosts and on the matrix's pattern.
  void build();
  // Once before every step. True: other pairs of lines may touch, so forces are not what they were.
  bool prepare();
  // Longest fraction of the increment local_ that keeps displacements below 5 % of the longest line and turns
  // below half a radian.
  double limit() const;
  // trial = state moved by `factor` times local_.
  void step(double factor);
  // Whether no line goes through another or through a volume on the straight way from the state to the trial,
  // nor deeper into one than its law is for; else blocked_ says what does. Where the candidates were not
  // chosen for that way they are chosen anew.
  bool clear();
  // Where automatic contact was too soft to keep the state from such a way: true if it is stiffer now, and
  // forces are to be asked for again.
  bool stiffen();
  // Push off a saddle: a fixed, rank-independent displacement field without symmetry, larger with `attempt`
  // (1, 2, ...); less of it where lines would pass through each other.
  void leave(int attempt);
  void take() { std::swap(state_.x, trial_.x), std::swap(state_.q, trial_.q); }

  double sum(double x) const;
  // Strain energy and potential over all ranks, J.
  double potential(const State& s) const;
  // Close enough for the exact tangent.
  bool near(const ResidualNorms& n) const;

  void push(int attempt, double share, State& s) const;
  bool passes(const Verdict& verdict);

  System& system_;
  State& state_;
  State trial_;
  VecHandle u_, r_;
  MatHandle J_;
  KspHandle ksp_;
  std::vector<double> local_, zero_;  // 3 * local blocks: an increment; nothing
  double length_ = 0;                 // m, of the longest element
  std::string blocked_;               // what was in the way of the last trial that was not clear, in words
};

}  // namespace hawser
