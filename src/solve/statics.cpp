// The search for static equilibrium: Newton's descent, dynamic relaxation if it fails, and raises of contact
// stiffness.
#include "hawser/solve/statics.hpp"

#include <cmath>

#include "hawser/advice/statics.hpp"
#include "hawser/advice/steps.hpp"
#include "hawser/base/error.hpp"
#include "hawser/solve/relaxation.hpp"
#include "static_search.hpp"

namespace hawser {
namespace {

constexpr int kMostRaises = 100;

// Passes the progress of relaxation to the settings of statics.
void pass_on_progress(const StaticsSettings& settings, RelaxationSettings& r) {
  if (!settings.progress) return;
  r.progress = [progress = settings.progress](const RelaxationReport& now) {
    StaticsReport report;
    report.iterations = now.iterations;
    report.relaxation_steps = now.steps;
    report.norms = now.norms;
    progress(report);
  };
}

StaticsReport relaxed(System& system, const StaticsSettings& settings, State& state) {
  RelaxationSettings r;
  r.max_steps = settings.relaxation_steps;
  pass_on_progress(settings, r);
  RelaxationReport rest;
  const State from = state;
  try {
    rest = relax(system, r, state);
  } catch (const SolveError&) {  // the start shape may have been in a plane or have had another symmetry
    state = from;
    system.spread(state);
    r.pushed = 1;
    rest = relax(system, r, state);
  }
  r.pushed = 0;
  for (;;) {
    State near = state;
    try {
      StaticsReport report = StaticSearch(system, settings, near, &r).run(true);
      state = std::move(near);
      report.iterations += rest.iterations;
      report.relaxation_steps += rest.steps;
      return report;
    } catch (const SolveError&) {
      // Newton's iteration needs a start nearer to the equilibrium.
      r.tolerance *= 1e-2;
      if (r.tolerance < settings.tolerance) throw;
    }
    system.spread(state);
    const RelaxationReport more = relax(system, r, state);
    rest.steps += more.steps;
    rest.iterations += more.iterations;
  }
}

// The start of the search, to which it can return.
class Start {
 public:
  Start(System& system, const State& state) : system_(system), state_(state) {
    for (const auto& term : system.terms()) history_.push_back(term->save());
  }
  void again(State& state) const {
    system_.soften(HUGE_VAL);
    state = state_;
    for (size_t i = 0; i < history_.size(); ++i) system_.terms()[i]->restore(history_[i]);
    system_.spread(state);
  }

 private:
  System& system_;
  State state_;
  std::vector<std::vector<CheckpointRecord>> history_;
};

// Friction forces depend on the path, which Newton's iteration of statics does not have, so relaxation is
// used. If contact was too soft on that path, lines were pulled into volumes, and friction would hold them
// while they are pressed out again. The path is therefore repeated from the start with the stiffness required
// at its end.
StaticsReport against_friction(System& system, const StaticsSettings& settings, const Start& start,
                               State& state) {
  RelaxationSettings r;
  r.max_steps = settings.relaxation_steps;
  r.tolerance = settings.tolerance;
  r.friction = true;
  pass_on_progress(settings, r);
  StaticsReport report;
  for (int round = 0;; ++round) {
    const RelaxationReport rest = relax(system, r, state);
    report.iterations += rest.iterations;
    report.relaxation_steps += rest.steps;
    report.norms = rest.norms;
    if (!system.raise_stiffness(state.view(0))) return report;
    if (round == kMostRaises) throw SolveError(advice::automatic_stiffness_unsettled());
    start.again(state);
  }
}

enum class Method { newton, relaxation };

// The methods to try, in this order.
std::vector<Method> methods(const StaticsSettings& settings) {
  if (settings.relaxation == RelaxationUse::never) return {Method::newton};
  if (settings.near) return {Method::newton, Method::relaxation};
  if (settings.relaxation == RelaxationUse::always) return {Method::relaxation};
  if (settings.relaxation == RelaxationUse::first) return {Method::relaxation, Method::newton};
  return {Method::newton, Method::relaxation};
}

StaticsReport first_equilibrium(System& system, const StaticsSettings& settings, const Start& start,
                                State& state) {
  if (settings.friction) return against_friction(system, settings, start, state);
  const std::vector<Method> order = methods(settings);
  std::vector<std::string> failures;
  for (const Method method : order) {
    if (!failures.empty()) start.again(state);
    const bool last = failures.size() + 1 == order.size();
    try {
      if (method == Method::relaxation) return relaxed(system, settings, state);
      return StaticSearch(system, settings, state).run(settings.near);
    } catch (const PathBlocked& blocked) {
      if (last || settings.near) throw;
      failures.emplace_back(blocked.what());
    } catch (const SolveError& failure) {
      if (order.size() == 1) throw;
      failures.emplace_back(failure.what());
    }
  }
  throw SolveError(advice::second_failure(failures.front(), failures.back()));
}

// Raises the contact stiffness until the equilibrium requires no more.
StaticsReport stiff_equilibrium(System& system, const StaticsSettings& settings, const Start& start,
                                State& state) {
  StaticsReport report = first_equilibrium(system, settings, start, state);
  for (int round = 0; system.raise_stiffness(state.view(0)); ++round) {
    if (round == kMostRaises) throw SolveError(advice::automatic_stiffness_unsettled());
    const StaticsReport more = StaticSearch(system, settings, state).run(true);
    report.iterations += more.iterations;
    report.escapes += more.escapes;
    report.negative_eigenvalues = more.negative_eigenvalues;
    report.norms = more.norms;
  }
  return report;
}

// If contact is far too soft, lines would be pulled through volumes. Such steps are rejected; if the step
// becomes too short, the contact stiffness is raised and the search begins again.
StaticsReport outside_volumes(System& system, const StaticsSettings& settings, State& state) {
  const Start start(system, state);
  for (;;) {
    try {
      return stiff_equilibrium(system, settings, start, state);
    } catch (const StiffnessRaised&) {
      start.again(state);
    }
  }
}

}  // namespace

StaticsReport find_equilibrium(System& system, const StaticsSettings& settings, State& state) {
  const size_t n = state.x.size();
  for (auto* a : {&state.v, &state.a, &state.w, &state.alpha}) a->assign(n, Vec3::Zero());
  StaticSearch(system, settings, state).check_start();
  const StaticsReport report = outside_volumes(system, settings, state);
  if (const auto found = system.overstretched(state.view(0)))
    throw SolveError(advice::overstretched_in_statics(*found));
  if (const auto found = system.lost_in_rounding(state.view(0)))
    throw SolveError(advice::tension_lost_in_statics(*found));
  system.commit(state.view(0));
  return report;
}

}  // namespace hawser
