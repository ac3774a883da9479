// The class StaticSearch: Newton's descent to a static equilibrium. SNES iterates (SNESNEWTONLS); the line
// search is a SNESLINESEARCHSHELL that moves the state itself, so that the unknown of the SNES, the increment
// from the state, is zero before every iteration.
#pragma once

#include <string>

#include "hawser/advice/statics.hpp"
#include "hawser/solve/kink.hpp"
#include "hawser/solve/relaxation.hpp"
#include "hawser/solve/stability.hpp"
#include "hawser/solve/static_trial.hpp"
#include "hawser/solve/statics.hpp"

namespace hawser {

class StaticSearch : StaticTrial {
 public:
  // relaxation: unstable equilibria are left by relaxation; null: by Newton's descent.
  StaticSearch(System& system, const StaticsSettings& settings, State& state,
               const RelaxationSettings* relaxation = nullptr);

  // From a start shape the search begins with soft lines, from a state near an equilibrium it does not.
  // Throws SolveError, or what throw_no_equilibrium() throws.
  enum class From { start_shape, near_equilibrium };
  StaticsReport run(From from);
  // Throws SolveError if the squares of the forces at the start overflow, from which no step can recover.
  void check_start();

 private:
  void residual() override;  // at the state, because the increment is always zero
  void tangent() override;
  SNESConvergedReason test_convergence(int iteration) override;
  // Prepares the terms, and evaluates residual and energy of the state.
  void begin_iteration(int iteration);
  static PetscErrorCode search(SNESLineSearch search, void* self);

  // If the axial stiffness is far above the forces, finds the equilibrium with softer lines first, and that
  // of lines that yield with elastic lines first.
  void stiffen_by_levels();
  void descend(double tolerance);
  // Moves the state along Newton's direction y as far as the energy or, near the solution, the residual
  // decreases. Returns whether it moved. Sets the reason if the search ends.
  bool advance(Vec y);
  // Factors of the increment at which the energy falls and rises, and its slopes there.
  struct Bracket {
    double under = 0, falls = 0, beyond = 0, rises = 0;
    // Adds the slope at a factor smaller than all before. `slope`: that at the state.
    void narrow(double factor, double trial_slope, double slope);
  };
  // Outcome of a search along the increment.
  struct Descent {
    bool accepted = false;  // the trial is accepted
    bool blocked = false;   // by lines that a longer step would cross
    bool searched = false;  // for a kink
    int trials = 0;
    double factor = 1;  // of the increment, in the last trial
    Bracket bracket;
  };
  // Sets the increment from Newton's direction y, combined with the sides of known kinks. Returns the slope
  // of the energy along it.
  double set_direction(Vec y);
  // Halves the increment, beginning with the factor `first`, until a trial is accepted. close: the tangent is
  // exact.
  Descent find_descent(double slope, double first, bool close);
  bool energy_falls(double energy, double slope, double trial_slope, double factor) const;
  // Near the solution, where a step was shortened much: continues to the near side of a kink, if there is
  // one.
  void search_for_kink(Descent& descent, double slope, bool close);
  void count_blocked(bool blocked);
  // Ends the search: converged to round-off, or without descent.
  bool is_round_off() const;
  void stop_search();
  // Shift of the next tangent. trusted: the step was not limited, or the tangent is exact.
  void adapt_shift(const Descent& descent, bool trusted);
  // Searches the bracket for a kink of the energy. If there is one, sets trial_ and r_ to its near side and
  // adds the other one to kinks_. `slope` is the slope at the state. Returns whether there is one.
  bool stop_at_kink(Bracket bracket, double slope);
  // Iterates down to round-off. A residual within the tolerance depends on the number of iterations, and that
  // on rounding and the number of ranks; it would be visible in a soft line beside stiff ones.
  void polish();
  // Selects the next tangent: exact, or convex. A unit of shift is the stiffness of a typical tension over an
  // element. The fraction `stabilisation` of K is proportional to the shift, up to 1.
  enum class TangentKind { exact, convex };
  void use_tangent(TangentKind kind, double shift);
  void newton(Vec y);
  // Completes the tangent of each body to that of its moment about the vertical.
  void add_slopes_of_vertical_moments();
  // Sets local_ and u_ to -y for Newton's direction y. If an exact tangent leads uphill, y is computed again
  // with the convex one. Returns the slope of the energy along it.
  double downhill(Vec y);
  // Slope of the energy along the increment at the trial, whose residual is in r_.
  double slope_at_trial() const;
  // Stability of the state, an equilibrium.
  Stability judge();
  // Pushes bodies off an unstable equilibrium along this motion or against it, first towards the start, and
  // descends. Returns whether this has led to another equilibrium; if not, the state is the same as before.
  // Throws SolveError if relaxation finds no rest in either direction.
  bool push_from_equilibrium(Vec motion, const State& start);
  // -1 if the start is on the other side of the bodies than their motion, else 1.
  double sign_towards(const State& start, Vec motion);
  // Moves the state along u_ as far as the forces drive it, at most by the longest step.
  void push_along();
  // Dynamic relaxation from the perturbed state. Returns whether it took any steps.
  bool relax_from_push();
  // Prepares the search for a state that was moved outside of it.
  void prepare_again();
  // Largest distance of a node from its place in that state, m, or rotation of a body times the length of the
  // longest line. Collective.
  double distance_from(const State& from) const;
  std::string failure(advice::StaticsEnds how) const;

  const StaticsSettings& settings_;
  const RelaxationSettings* relaxation_;
  StaticsReport report_;
  double tolerance_ = 0, energy_ = 0;  // tolerance of the residual; energy of the state, J
  double least_residual_ = 0;          // least relative residual of this descent
  KinkSides kinks_;
  int kinks_layout_ = 0;  // layout_ of the vectors in kinks_
  double shift_ = 0;      // of the next iteration
  bool exact_ = false;
  double tangent_shift_ = 0;  // shift of the tangent
  Weights weights_;
  int iterations_before_ = 0;  // iterations before this descent
  bool stagnates_ = false;     // this descent hardly moves
  int slow_ = 0;               // iterations of this descent in which the residual has not halved
  int blocked_steps_ = 0;      // steps of this descent that blocking lines shortened
};

}  // namespace hawser
