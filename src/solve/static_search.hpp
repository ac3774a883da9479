// The class StaticSearch: Newton's descent to a static equilibrium. SNES iterates (SNESNEWTONLS); the line
// search is a SNESLINESEARCHSHELL that moves the state itself, so that the unknown of the SNES, the increment
// from the state, is zero before every iteration.
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
               const RelaxationSettings* relaxation = nullptr);

  // again: from an equilibrium in which little has changed. Throws SolveError, or as throw_no_equilibrium()
  // does.
  StaticsReport run(bool again = false);
  // Nothing leads out of forces whose squares are beyond all numbers: SolveError.
  void check_start();

 private:
  void residual() override;  // at the state, where the increment is always zero
  void tangent() override;
  SNESConvergedReason check_step(int iteration) override;
  static PetscErrorCode search(SNESLineSearch search, void* self);

  // Where the axial stiffness is far above the forces, equilibrium is found with a soft line first, and that
  // of lines that yield with elastic ones.
  void approach();
  void descend(double tolerance);
  // Moves the state along Newton's direction y: as far as the energy falls or, near the end, the residual.
  // Whether it moved; why the search ends, where it does.
  bool advance(Vec y);
  // On to round-off: what the tolerance leaves depends on the iterations taken, these on rounding and so on
  // the number of ranks, and a soft line beside stiff ones shows it.
  void polish();
  // The tangent to come: exact, or convex; a tension's worth of stiffness over an element for a unit of
  // shift. With the shift goes how much stiffer K is.
  void use_tangent(bool exact, double shift);
  void newton(Vec y);
  // A direction of Newton's, from u = -y, to local_; where an exact tangent leads upwards y is made anew with
  // the convex one. Its slope on the energy.
  double downhill(Vec y);
  // Of the energy at the trial along the increment, whose residual is in r_.
  double slope_at_trial() const;
  // By dynamic relaxation from where it was pushed to; whether that moved it.
  bool rest();
  // m, of the node that is farthest from where it was there. Collective.
  double away(const State& from) const;
  std::string failure(const char* why) const;

  const StaticsSettings& settings_;
  const RelaxationSettings* relaxation_;
  StaticsReport report_;
  double tolerance_ = 0, energy_ = 0;  // of the residual; J, of the state
  double shift_ = 0;                   // that the next iteration takes
  bool exact_ = false;
  double used_ = 0;  // shift of the tangent
  Weights weights_;
  int begun_ = 0;  // iterations before this descent
  int cut_ = 0;    // its steps that lines in their way cut short
};

}  // namespace hawser
