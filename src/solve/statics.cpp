// The order of the search for static equilibrium (docs/theory/statics.md):
//   find_equilibrium
//     restart_when_stiffened  from the start, when contact was too soft to keep a line out of a volume
//       raise_until_enough    from the equilibrium, while it requires stiffer contact
//         try_methods         from the start, with the next method when one fails
//           StaticSearch      Newton's descent
//           relax_then_newton
//           relax_with_friction
#include "hawser/solve/statics.hpp"

#include "hawser/advice/statics.hpp"
#include "hawser/advice/steps.hpp"
#include "hawser/base/error.hpp"
#include "hawser/solve/relaxation.hpp"
#include "static_search.hpp"

namespace hawser {
namespace {

constexpr int kMaxRaises = 100;

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

StaticsReport relax_then_newton(System& system, const StaticsSettings& settings, State& state) {
  RelaxationSettings r;
  r.max_steps = settings.relaxation_steps;
  pass_on_progress(settings, r);
  RelaxationReport relaxed;
  const State from = state;
  try {
    relaxed = relax(system, r, state);
  } catch (const RelaxationStepsUsed&) {
    throw;
  } catch (const SolveError&) {  // the start shape may have been in a plane or have had another symmetry
    state = from;
    system.update_ghosts(state);
    r.pushed = 1;
    relaxed = relax(system, r, state);
  }
  r.pushed = 0;
  for (;;) {
    const State at_rest = state;
    try {
      StaticsReport report =
          StaticSearch(system, settings, state, &r).run(StaticSearch::From::near_equilibrium);
      report.iterations += relaxed.iterations;
      report.relaxation_steps += relaxed.steps;
      return report;
    } catch (const RelaxationStepsUsed&) {
      throw;
    } catch (const SolveError&) {
      // Newton's iteration needs a start nearer to the equilibrium.
      r.tolerance *= 1e-2;
      if (r.tolerance < settings.tolerance) throw;
    }
    state = at_rest;
    system.update_ghosts(state);
    const RelaxationReport more = relax(system, r, state);
    relaxed.steps += more.steps;
    relaxed.iterations += more.iterations;
  }
}

// Friction forces depend on the path, which Newton's iteration of statics does not have, so relaxation is
// used. If contact was too soft on that path, lines were pulled into volumes, and friction would hold them
// while they are pressed out again. The path is therefore repeated from the start with the stiffness required
// at its end.
StaticsReport relax_with_friction(System& system, const StaticsSettings& settings, const StaticsStart& start,
                                  State& state) {
  RelaxationSettings r;
  r.max_steps = settings.relaxation_steps;
  r.tolerance = settings.tolerance;
  r.friction = true;
  pass_on_progress(settings, r);
  StaticsReport report;
  for (int round = 0;; ++round) {
    const RelaxationReport relaxed = relax(system, r, state);
    report.iterations += relaxed.iterations;
    report.relaxation_steps += relaxed.steps;
    report.norms = relaxed.norms;
    report.remaining = relaxed.remaining;
    if (!system.adapt_stiffness(state.at_rest())) return report;
    if (round == kMaxRaises) throw SolveError(advice::automatic_stiffness_unsettled());
    start.restore(state);
  }
}

enum class Method { newton, relaxation };

// The methods to try, in this order.
std::vector<Method> methods(const StaticsSettings& settings) {
  if (settings.relaxation == RelaxationUse::never) return {Method::newton};
  if (settings.starts_near) return {Method::newton, Method::relaxation};
  if (settings.relaxation == RelaxationUse::always) return {Method::relaxation};
  if (settings.relaxation == RelaxationUse::first) return {Method::relaxation, Method::newton};
  return {Method::newton, Method::relaxation};
}

// For a search that no relaxation follows: Newton's descent continues while it hardly moves the lines.
StaticsSettings without_relaxation(StaticsSettings settings) {
  settings.relaxation = RelaxationUse::never;
  return settings;
}

StaticsReport try_methods(System& system, const StaticsSettings& settings, const StaticsStart& start,
                          State& state) {
  if (settings.friction) return relax_with_friction(system, settings, start, state);
  const std::vector<Method> order = methods(settings);
  std::vector<std::string> failures;
  for (const Method method : order) {
    if (!failures.empty()) start.restore(state);
    const bool last = failures.size() + 1 == order.size();
    try {
      if (method == Method::relaxation) return relax_then_newton(system, settings, state);
      return StaticSearch(system, last ? without_relaxation(settings) : settings, state)
          .run(settings.starts_near ? StaticSearch::From::near_equilibrium : StaticSearch::From::start_shape);
    } catch (const PathBlocked& blocked) {
      if (last || settings.starts_near) throw;
      failures.emplace_back(blocked.what());
    } catch (const SolveError& failure) {
      if (order.size() == 1) throw;
      failures.emplace_back(failure.what());
    }
  }
  throw SolveError(advice::second_failure(failures.front(), failures.back()));
}

// Raises the contact stiffness until the equilibrium requires no more.
StaticsReport raise_until_enough(System& system, const StaticsSettings& settings, const StaticsStart& start,
                                 State& state) {
  StaticsReport report = try_methods(system, settings, start, state);
  for (int round = 0; system.adapt_stiffness(state.at_rest()); ++round) {
    if (round == kMaxRaises) throw SolveError(advice::automatic_stiffness_unsettled());
    const StaticsReport more =
        StaticSearch(system, without_relaxation(settings), state).run(StaticSearch::From::near_equilibrium);
    report.iterations += more.iterations;
    report.escapes += more.escapes;
    report.negative_eigenvalues = more.negative_eigenvalues;
    report.norms = more.norms;
  }
  return report;
}

// If contact is far too soft, lines would be pulled through volumes. Such steps are rejected; if the step
// becomes too short, the contact stiffness is raised and the search begins again.
StaticsReport restart_when_stiffened(System& system, const StaticsSettings& settings, State& state) {
  const StaticsStart start(system, state);
  for (;;) {
    try {
      return raise_until_enough(system, settings, start, state);
    } catch (const StiffnessRaised&) {
      start.restore(state);
    }
  }
}

}  // namespace

StaticsStart::StaticsStart(System& system, const State& state) : system_(system), state_(state) {
  for (const auto& term : system.terms()) history_.push_back(term->save());
}

void StaticsStart::restore(State& state) const {
  system_.restore_sections();
  state = state_;
  for (size_t i = 0; i < history_.size(); ++i) system_.terms()[i]->restore(history_[i]);
  system_.update_ghosts(state);
}

StaticsReport find_equilibrium(System& system, const StaticsSettings& settings, State& state) {
  const size_t n = state.x.size();
  for (auto* a : {&state.v, &state.a, &state.w, &state.alpha}) a->assign(n, Vec3::Zero());
  StaticSearch(system, settings, state).check_start();
  const StaticsReport report = restart_when_stiffened(system, settings, state);
  if (const auto overstretched = system.overstretched(state.at_rest()))
    throw SolveError(advice::overstretched_in_statics(*overstretched));
  if (const auto line = system.lost_in_rounding(state.at_rest()))
    throw SolveError(advice::tension_lost_in_statics(*line));
  system.commit(state.at_rest());
  return report;
}

}  // namespace hawser
