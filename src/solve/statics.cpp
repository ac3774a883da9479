// The search for static equilibrium: soft lines first, Newton's descent with line search, leaving unstable
// equilibria, dynamic relaxation where Newton fails, raising of contact stiffness.
#include "hawser/solve/statics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/solve/relaxation.hpp"
#include "hawser/solve/static_trial.hpp"
#include "hawser/system/imbalance.hpp"

namespace hawser {
namespace {

constexpr double kArmijo = 1e-4;
constexpr double kSoft = 300, kStiffening = 30;  // axial stiffness over load at the start, and a stage on
constexpr int kMostRaises = 100;
constexpr const char* kUnsettled =
    "statics: the automatic stiffness of contact does not settle; give the volumes a normal_stiffness";
constexpr int kHalvings = 30, kMaxEscapes = 3, kPolish = 4;
constexpr double kNegative =
    1e-7;  // shift that eigenvalues of what lies slack, nothing but round-off, stay below
// Iterations after which energies that differ by round-off alone no longer pass for going down: a slack chain
// whose elements tighten and loosen in turn would go round for ever.
constexpr int kRound = 20;
constexpr int kMostCut = 100;  // steps of a descent that lines in their way may cut short

class Search : StaticTrial {
 public:
  Search(System& system, const StaticsSettings& settings, State& state)
      : StaticTrial(system, state), settings_(settings) {}
  // Leaves false equilibria by dynamic relaxation.
  Search(System& system, const StaticsSettings& settings, const RelaxationSettings& relaxation, State& state)
      : StaticTrial(system, state), settings_(settings), relaxation_(&relaxation) {}

  // again: from an equilibrium in which little has changed.
  StaticsReport run(bool again = false) {
    StaticsReport report;
    if (!again) approach(report);
    for (;;) {
      descend(report, settings_.tolerance);
      Weights weights;
      set_shift(kNegative, report.norms, weights);
      system_.tangent(state_.view(0), weights, zero_, false, J_.get());
      report.negative_eigenvalues = negative_eigenvalues(J_.get());
      // Friction's tangent is unsymmetric: the inertia of its symmetric part says nothing.
      if (settings_.near || report.negative_eigenvalues <= 0 || report.escapes == kMaxEscapes) break;
      ++report.escapes;
      leave(report.escapes);
      if (relaxation_) rest(report);
    }
    polish(report);
    return report;
  }

  // Nothing leads out of forces whose squares are beyond all numbers.
  void check_start() {
    system_.residual(state_.view(0), r_.get());
    const ResidualNorms norms = system_.norms(r_.get());
    if (!norms.finite()) throw SolveError("statics: " + imbalance(system_, r_.get(), norms));
  }

 private:
  // Where the axial stiffness is far above the forces, equilibrium is found with a soft line first.
  void approach(StaticsReport& report) {
    system_.residual(state_.view(0), r_.get());
    const ResidualNorms norms = system_.norms(r_.get());
    const double stiff = system_.axial_stiffness(), load = system_.dead_load();
    if (load == 0 || near(norms)) return;
    for (double soft = kSoft * load; soft < stiff; soft *= kStiffening) {
      system_.soften(soft);
      descend(report, 1e-4);
    }
    system_.soften(HUGE_VAL);
  }
  void descend(StaticsReport& report, double tolerance) {
    system_.residual(state_.view(0), r_.get());
    ResidualNorms norms = system_.norms(r_.get());
    double energy = 0, shift = 1e-3;
    int cut = 0;
    for (int it = 0;; ++it, ++report.iterations) {
      if (prepare()) {  // contact candidates move with the line
        system_.residual(state_.view(0), r_.get());
        norms = system_.norms(r_.get());
      }
      report.norms = norms;
      if (settings_.told) settings_.told(report);
      energy = potential(state_);  // and so does what moments are measured from
      if (norms.small(tolerance)) return;
      if (it >= settings_.max_iterations) throw SolveError(failure(norms, "too many iterations"));
      const bool close = near(norms);
      const double slope = direction(close, close && shift < 1e-5 ? 0 : shift, norms);
      double factor = limit();
      const bool full = factor == 1;
      bool taken = false, blocked = false;
      int halvings = 0;
      for (; halvings < kHalvings && !taken; ++halvings, factor *= taken ? 1 : 0.5) {
        step(factor);
        if (!clear()) {
          blocked = true;
          continue;
        }
        const double e = potential(trial_);
        system_.residual(trial_.view(0), r_.get());
        const ResidualNorms n = system_.norms(r_.get());
        if (!std::isfinite(e) || !std::isfinite(n.force)) continue;
        const bool flat = std::abs(e - energy) <= 1e-10 * std::abs(energy);
        const bool down = slope < 0 && e <= energy + kArmijo * factor * slope && !(flat && it >= kRound);
        if (down || ((flat || close) && n.relative() < norms.relative()) || n.small(tolerance)) {
          taken = true;
          take();
          norms = n, energy = e;
        }
      }
      // Cut short again and again by lines that would pass through each other: they come ever nearer, and
      // there is no way on.
      cut += blocked;
      if ((!taken && shift > 1e6) || cut > kMostCut) {
        system_.residual(state_.view(0), r_.get());
        if (norms.small(100 * tolerance)) return;  // round-off of very stiff lines
        throw SolveError(failure(norms, blocked ? "lines would pass through each other" : "no descent"));
      }
      shift = std::clamp(taken && halvings <= 1 && (full || close) ? 0.2 * shift
                         : taken && halvings <= 1                  ? shift
                                                                   : 4 * shift,
                         1e-9, 1e7);
      if (!taken) shift *= 10;
    }
  }

  // On to round-off: what the tolerance leaves depends on the iterations taken, these on rounding and so on
  // the number of ranks, and a soft line beside stiff ones shows it.
  void polish(StaticsReport& report) {
    for (int i = 0; i < kPolish; ++i) {
      direction(true, 0, report.norms);
      if (limit() < 1) break;
      step(1);
      if (!clear()) break;
      system_.residual(trial_.view(0), r_.get());
      const ResidualNorms n = system_.norms(r_.get());
      if (!(n.relative() < 0.5 * report.norms.relative())) break;
      take();
      report.norms = n;
      ++report.iterations;
    }
    system_.residual(state_.view(0), r_.get());  // the reactions are those of the state
  }

  // A tension's worth of stiffness over an element for a unit of shift.
  void set_shift(double shift, const ResidualNorms& norms, Weights& w) const {
    PetscInt unknowns = 0;
    check(VecGetSize(u_.get(), &unknowns));
    const double unit = norms.force_scale / std::sqrt(static_cast<double>(unknowns)) / length_;
    w.shift_position = shift * unit;
    w.shift_rotation = shift * unit * length_ * length_;
  }

  // Newton direction into local_; returns its slope on the energy.
  double direction(bool exact, double shift, const ResidualNorms& norms) {
    Weights w;
    set_shift(shift, norms, w);
    system_.residual(state_.view(0), r_.get());
    system_.tangent(state_.view(0), w, zero_, !exact, J_.get());
    check(KSPSetOperators(ksp_.get(), J_.get(), J_.get()));
    check(KSPSolve(ksp_.get(), r_.get(), u_.get()));
    check(VecScale(u_.get(), -1));
    PetscScalar slope = 0;
    check(VecDot(u_.get(), r_.get(), &slope));
    if (exact && !(slope < 0)) return direction(false, std::max(shift, 1e-6), norms);
    system_.gather(u_.get(), local_);
    return slope;
  }

  // By dynamic relaxation from where it was pushed to.
  void rest(StaticsReport& report) {
    const RelaxationReport r = relax(system_, *relaxation_, state_);
    report.iterations += r.iterations, report.relaxation_steps += r.steps;
    build();
    local_ = zero_;
    trial_ = state_;
    prepare();
  }

  std::string failure(const ResidualNorms& n, const char* why) const {
    return fmt::format("statics: {}: {}", why, imbalance(system_, r_.get(), n));
  }

  const StaticsSettings& settings_;
  const RelaxationSettings* relaxation_ = nullptr;
};

// Steps of relaxation are told as statics is.
void tell_of(const StaticsSettings& settings, RelaxationSettings& r) {
  if (!settings.told) return;
  r.told = [told = settings.told](const RelaxationReport& now) {
    StaticsReport report;
    report.iterations = now.iterations, report.relaxation_steps = now.steps, report.norms = now.norms;
    told(report);
  };
}

StaticsReport relaxed(System& system, const StaticsSettings& settings, State& state) {
  RelaxationSettings r;
  r.max_steps = settings.relaxation_steps;
  tell_of(settings, r);
  RelaxationReport rest;
  const State from = state;
  try {
    rest = relax(system, r, state);
  } catch (const SolveError&) {  // a shape in a plane, or another symmetry, may have been in the way
    state = from;
    system.spread(state);
    r.pushed = 1;
    rest = relax(system, r, state);
  }
  for (r.pushed = 0;; r.tolerance *= 1e-2) {  // Newton's iteration may want to start nearer
    State near = state;
    try {
      StaticsReport report = Search(system, settings, r, near).run(true);
      state = std::move(near);
      report.iterations += rest.iterations, report.relaxation_steps += rest.steps;
      return report;
    } catch (const SolveError&) {
      if (r.tolerance < settings.tolerance) throw;
      system.spread(state);
      const RelaxationReport more = relax(system, r, state);
      rest.steps += more.steps, rest.iterations += more.iterations;
    }
  }
}

// Friction's forces belong to the way taken: Newton's iteration of statics has none. Where contact was too
// soft on that way, lines were drawn into it and friction would hold them as they are pressed out again: it
// is taken once more from its start with the stiffness that its end asks for.
StaticsReport against_friction(System& system, const StaticsSettings& settings, State& state) {
  RelaxationSettings r;
  r.max_steps = settings.relaxation_steps, r.tolerance = settings.tolerance, r.friction = true;
  tell_of(settings, r);
  const State from = state;
  std::vector<std::vector<HistoryRecord>> history;
  for (const auto& term : system.terms()) history.push_back(term->save());
  StaticsReport report;
  for (int round = 0;; ++round) {
    const RelaxationReport rest = relax(system, r, state);
    report.iterations += rest.iterations, report.relaxation_steps += rest.steps, report.norms = rest.norms;
    if (!system.stiffen(state.view(0))) return report;
    if (round == kMostRaises) throw SolveError(kUnsettled);
    state = from;
    for (size_t i = 0; i < history.size(); ++i) system.terms()[i]->restore(history[i]);
    system.spread(state);
  }
}

StaticsReport first_equilibrium(System& system, const StaticsSettings& settings, State& state) {
  Search(system, settings, state).check_start();
  if (settings.friction) return against_friction(system, settings, state);
  if (settings.near || settings.relaxation == RelaxationUse::never)
    return Search(system, settings, state).run(settings.near);
  if (settings.relaxation == RelaxationUse::always) return relaxed(system, settings, state);
  State from = state;
  try {
    return Search(system, settings, state).run();
  } catch (const SolveError& newton) {
    system.soften(HUGE_VAL);
    state = std::move(from);
    system.spread(state);
    try {
      return relaxed(system, settings, state);
    } catch (const SolveError& relaxation) {
      throw SolveError(fmt::format("{}; after that, {}", newton.what(), relaxation.what()));
    }
  }
}

}  // namespace

StaticsReport solve_statics(System& system, const StaticsSettings& settings, State& state) {
  const size_t n = state.x.size();
  for (auto* a : {&state.v, &state.a, &state.w, &state.alpha}) a->assign(n, Vec3::Zero());
  StaticsReport report = first_equilibrium(system, settings, state);
  for (int round = 0; system.stiffen(state.view(0)); ++round) {
    if (round == kMostRaises) throw SolveError(kUnsettled);
    const StaticsReport more = Search(system, settings, state).run(true);
    report.iterations += more.iterations, report.escapes += more.escapes;
    report.negative_eigenvalues = more.negative_eigenvalues, report.norms = more.norms;
  }
  if (std::string why = system.overstretched(state.view(0)); !why.empty())
    throw SolveError("statics: " + why + ": is the load, the length or the EA in another unit?");
  if (const std::string why = system.lost_in_rounding(state.view(0)); !why.empty())
    throw SolveError("statics: " + why);
  system.commit(state.view(0));
  return report;
}

}  // namespace hawser
