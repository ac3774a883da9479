// What searches for an equilibrium share: a state, a trial beside it, an increment and its linear system, and
// the question whether lines would pass through each other on the way. Configurations are re-based at every
// step, so rotations of any size are met by small increments.
#pragma once

#include <string>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/system.hpp"

namespace hawser {

// No step leads on past a line or a volume: the sentence says which.
struct InTheWay : SolveError {
  using SolveError::SolveError;
};
// Thrown, the same on all ranks, where contact is stiffer than the search began with: it begins again.
struct StiffenedOnTheWay {};

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
  // Whether, on the straight way from the state to the trial, no line goes through another or through a
  // volume, nor deeper into a volume than its contact law is for. Where the candidates were not chosen for
  // that way they are chosen anew.
  bool clear();
  // Throws what statics ends with where no step leads on: if something was in the way, InTheWay, or
  // StiffenedOnTheWay where automatic contact can be made stiffer; else SolveError with that sentence.
  [[noreturn]] void give_up(const std::string& why);
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

  System& system_;
  State& state_;
  State trial_;
  VecHandle u_, r_;
  MatHandle J_;
  KspHandle ksp_;
  std::vector<double> local_, zero_;  // 3 * local blocks: an increment; nothing
  double length_ = 0;                 // m, of the longest element
  // What was in the way of the last trial that was not clear, in words, and that trial; empty: nothing.
  std::string in_the_way_;
  State blocked_;
};

}  // namespace hawser
