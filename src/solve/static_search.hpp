// The class StaticSearch: Newton's descent to a static equilibrium.
#pragma once

#include <string>

#include "hawser/solve/relaxation.hpp"
#include "hawser/solve/static_trial.hpp"
#include "hawser/solve/statics.hpp"

namespace hawser {

class StaticSearch : StaticTrial {
 public:
  // relaxation: leaves false equilibria by it; null: by Newton's descent.
  StaticSearch(System& system, const StaticsSettings& settings, State& state,
               const RelaxationSettings* relaxation = nullptr)
      : StaticTrial(system, state), settings_(settings), relaxation_(relaxation) {}

  // again: from an equilibrium in which little has changed. Throws SolveError, or as give_up() does.
  StaticsReport run(bool again = false);
  // Nothing leads out of forces whose squares are beyond all numbers: SolveError.
  void check_start();

 private:
  // Where the axial stiffness is far above the forces, equilibrium is found with a soft line first.
  void approach(StaticsReport& report);
  void descend(StaticsReport& report, double tolerance);
  // On to round-off: what the tolerance leaves depends on the iterations taken, these on rounding and so on
  // the number of ranks, and a soft line beside stiff ones shows it.
  void polish(StaticsReport& report);
  // A tension's worth of stiffness over an element for a unit of shift.
  void set_shift(double shift, const ResidualNorms& norms, Weights& w) const;
  // Newton direction into local_; returns its slope on the energy.
  double direction(bool exact, double shift, const ResidualNorms& norms);
  // By dynamic relaxation from where it was pushed to.
  void rest(StaticsReport& report);
  std::string failure(const ResidualNorms& n, const char* why) const;

  const StaticsSettings& settings_;
  const RelaxationSettings* relaxation_;
};

}  // namespace hawser
