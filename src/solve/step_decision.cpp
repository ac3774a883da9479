// What becomes of a step that was tried: the one place where it is accepted, tried again or given up.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/solve/dynamics.hpp"
#include "hawser/system/imbalance.hpp"

namespace hawser {

// In this order: did Newton's iteration converge, does a rotation tell which way it went, is all that acts in
// the step known (candidates, tunnelling, penetration), are impacts resolved, is the local error
// small, does no event happen within it, is the result one that the lines can bear.
Verdict Dynamics::judge(double h, Attempt& a) {
  using Kind = Verdict::Kind;
  if (!a.solved)
    return {Kind::shorter, "Newton's iteration does not converge: " + imbalance(system_, r_.get(), norms_)};
  const Kinematics trial = trial_.s.view(h);
  const NodeValue turn = alpha_turn(system_.mesh(), local_u_);
  double most[2] = {alpha_error(system_.mesh(), alpha_, h, committed_, trial_), turn.value};
  MPI_Allreduce(MPI_IN_PLACE, most, 2, MPI_DOUBLE, MPI_MAX, system_.comm());
  a.error = most[0];
  if (most[1] > M_PI) {
    a.solved = false;  // a rotation beyond half a turn is another one
    NodeValue worst = turn;
    MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, system_.comm());
    return {Kind::shorter,
            fmt::format("{}, turns by {:.3g} rad in it, and a step follows half a turn at most",
                        system_.mesh().mesh->place(worst.node), worst.value)};
  }
  if (Verdict v = system_.judge(trial); !v.accepted()) {
    a.solved = false;
    return v;
  }
  if (control_.divides(h) && !system_.resolves_impacts(trial)) {
    a.solved = false;
    return {Kind::shorter, "it does not resolve an impact that its start did not show"};
  }
  if (!control_.accurate(h, a.error))
    return {Kind::shorter, fmt::format("its local error of {:.3g} m is too large", a.error)};
  if (conditions_ && !control_.shortest(h)) {
    const std::vector<double> g = conditions_(trial);
    if (std::any_of(g.begin(), g.end(), [](double value) { return value > 1; })) {
      a.solved = false;
      return {Kind::shorter, "an event happens within it"};
    }
  }
  if (const std::string why = system_.overstretched(trial); !why.empty())
    return {Kind::stop,
            fmt::format("at t = {:.6g} s {}: does something pull at once that should have a 'ramp'?",
                        trial.time, why)};
  return {};
}

StepInfo Dynamics::take_step(double until) {
  const double t = committed_.s.time;
  prepare(control_.proposal());  // tries can only be shorter
  StepLimit limit;
  if (control_.limited()) {
    limit = system_.longest_step(committed_.s.view(last_step_), {committed_.ax, alpha_stored(alpha_)},
                                 control_.proposal());
    control_.follow_impact(t, limit.period);
  }
  StepInfo info;
  for (bool prepared_anew = false;;) {
    const double h = control_.next(t, std::min(next_stop_(t), until), limit.longest);
    Attempt a = attempt(h);
    const Verdict verdict = judge(h, a);
    switch (verdict.kind) {
      case Verdict::Kind::accept:
        accept(h);
        control_.accepted(h, a.iterations, a.error);
        info.time = committed_.s.time, info.h = h, info.iterations = a.iterations, info.error = a.error;
        return info;
      case Verdict::Kind::stop:
        throw SolveError(verdict.because);
      case Verdict::Kind::prepare_anew:
        // How old a list of candidates is must not show in the steps: a restart makes a new one.
        if (!prepared_anew) {
          prepared_anew = true;
          prepare(h, &trial_.s);
          continue;
        }
        [[fallthrough]];
      case Verdict::Kind::shorter:
        ++info.rejected;
        if (!control_.rejected(h, !a.solved, a.error))
          throw SolveError(
              fmt::format("stopped at t = {:.6g} s: the shortest step ({:.3g} s) cannot be taken: {}", t, h,
                          verdict.because));
    }
  }
}

}  // namespace hawser
