// The class Dynamics: decision whether a trial step is accepted, repeated or fails. StepControl
// (step_control.cpp) proposes lengths; begin_step() and next_try() provide the limits by terms, outputs and
// events.
#include <algorithm>
#include <cmath>
#include <utility>

#include "hawser/advice/steps.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/angle_between.hpp"
#include "hawser/solve/dynamics.hpp"
#include "hawser/system/imbalance.hpp"

namespace hawser {
namespace {

// Describes the beam element that is bent most in the accepted state, if by more than 60 degrees; empty if
// there is none. Such an element cannot represent the shape of the line, and shorter steps help only for a
// short time. Collective.
std::string folded_element(const System& system, const Kinematics& state) {
  constexpr double kFolded = M_PI / 3;  // rad between the ends: the element is folded
  constexpr double kKept = M_PI / 9;    // rad: the most that is recommended in one element
  struct {
    double turn = 0, length = 0;  // rad, m
    int node = -1;
  } worst;
  const LocalMesh& mesh = system.mesh();
  for (const LocalElement& e : mesh.elements) {
    if (!mesh.element(e).beam) continue;
    const Vec3 from = state.q[e.first] * Vec3::UnitX();
    const Vec3 to = state.q[e.second] * Vec3::UnitX();
    const double turn = angle_between(from, to);
    if (turn > worst.turn) worst = {turn, mesh.element(e).length, mesh.global[e.first]};
  }
  if (!broadcast_largest(system.comm(), worst.turn, kFolded, worst)) return {};
  return advice::folded_element({.place = mesh.mesh->place(worst.node),
                                 .turn = worst.turn,
                                 .length = worst.length,
                                 .sufficient = worst.length * kKept / worst.turn});
}

// First end of a beam element whose relative end rotation passed half a turn in the step; -1: none on this
// rank. The element then measures the rotation in the other direction, so that its strain jumps. The
// quaternions of the rotations, with w >= 0 of q and -q, are then more than a right angle apart.
int turned_over(const LocalMesh& mesh, const Kinematics& before, const Kinematics& after) {
  const auto turn = [](const Kinematics& state, const LocalElement& e) -> Quat {
    const Quat q = state.q[e.first].conjugate() * state.q[e.second];
    return q.w() < 0 ? Quat(-q.coeffs()) : q;
  };
  for (const LocalElement& e : mesh.elements)
    if (mesh.element(e).beam && turn(before, e).dot(turn(after, e)) < 0) return mesh.global[e.first];
  return -1;
}

}  // namespace

// Checks in this order: Newton's iteration converged; no rotation is ambiguous (more than half a turn in
// the step, or within a beam element); the terms have found all contacts of the step (candidates, tunnelling,
// penetration); impacts are resolved. All but the first share one reduction over the ranks; unresolved
// impacts need two more, and a rotation of more than half a turn one.
Verdict Dynamics::check_step() {
  using Kind = Verdict::Kind;
  if (!attempt_.solved) return {Kind::shorter, imbalance(system_, r_.get(), norms_)};
  const Kinematics trial = trial_.s.after_step(h_);
  const NodeValue turn = alpha_turn(system_.mesh(), local_u_);
  const int local_node = turned_over(system_.mesh(), committed_kinematics(), trial);
  double error = alpha_error(system_.mesh(), alpha_, h_, committed_, trial_, settings_.error_weight);
  double largest_turn = turn.value;
  double node_turned_over = local_node;
  double beyond = system_.overstretch(trial).beyond;
  RankMax maxima;
  for (double* number : {&error, &largest_turn, &node_turned_over, &beyond}) maxima.add(*number);
  Verdict verdict = system_.check_step(trial, control_.may_shorten(h_), std::move(maxima));
  attempt_.info.error = error;
  attempt_.overstretched = beyond > 0;
  if (largest_turn > M_PI) {  // The same orientation would have another increment, in the opposite direction.
    NodeValue worst = turn;
    MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, system_.comm());
    return {Kind::shorter,
            advice::TurnsTooFar{system_.mesh().mesh->place(static_cast<int>(worst.node)), worst.value}};
  }
  if (node_turned_over >= 0)
    return {Kind::shorter,
            advice::ElementTurnsOver{system_.mesh().mesh->place(static_cast<int>(node_turned_over))}};
  return verdict;
}

// Length of a try from the committed state, towards the next output or the event that is searched for.
double Dynamics::next_try() const {
  const double t = committed_.s.time;
  return control_.next(t, std::min(next_stop_(t), t + attempt_.event), attempt_.allowed);
}

double Dynamics::begin_step() {
  prepare(control_.proposal());  // The terms are prepared for the longest try; later tries are shorter.
  attempt_ = {};
  // Evaluated at the committed state, before the terms have evaluated a trial.
  if (events_) attempt_.at_start = events_(committed_kinematics());
  if (control_.respects_term_limits()) {
    const StepLimit limit = system_.longest_step(committed_kinematics(),
                                                 {committed_.ax, alpha_stored(alpha_)}, control_.proposal());
    control_.limit_by_impact(committed_.s.time, limit.period, limit.decay);
    attempt_.allowed = limit.longest;
  }
  return next_try();
}

// Checks in this order: the trial is valid (check_step), it is accurate, it does not pass an event, no line
// is overstretched.
Dynamics::Decision Dynamics::decide() {
  Verdict verdict = check_step();
  const double error = attempt_.info.error;
  const bool inaccurate = verdict.accepted() && !control_.accurate(h_, error);
  if (inaccurate) verdict = {Verdict::Kind::shorter, advice::ErrorTooLarge{error}};
  switch (verdict.kind) {
    case Verdict::Kind::accept:
      if (events_ && !control_.is_shortest(h_)) {
        attempt_.event = attempt_.search.next(h_, control_.shortest_length(),
                                              events_(trial_.s.after_step(h_)), attempt_.at_start);
        // The length is changed only to meet the event, not because the step failed.
        if (attempt_.event != h_) {
          ++attempt_.info.rejected;
          return {false, next_try()};
        }
      }
      if (attempt_.overstretched)
        throw SolveError(
            advice::overstretched_at(trial_.s.time, *system_.overstretched(trial_.s.after_step(h_))));
      control_.after_accepted_step(h_, attempt_.info.iterations, error);
      return {true, control_.proposal()};
    case Verdict::Kind::prepare_again:
      // The age of a candidate list must not influence the steps, because a restart makes a new list. So the
      // step is first prepared again, once, and not shortened.
      if (!attempt_.prepared_again) {
        attempt_.prepared_again = true;
        prepare(h_, &trial_.s);
        return {false, next_try()};
      }
      break;
    case Verdict::Kind::shorter:
      break;
    case Verdict::Kind::stop:
      throw SolveError(first_text(system_.comm(), advice::clause(verdict.because)));
  }
  ++attempt_.info.rejected;
  attempt_.search = {};
  attempt_.event = HUGE_VAL;  // A shorter step may not reach the event.
  const auto why = inaccurate ? StepControl::Rejection::inaccurate : StepControl::Rejection::invalid;
  if (control_.after_rejected_step(h_, why, error)) return {false, next_try()};
  const std::string because = first_text(system_.comm(), advice::clause(verdict.because));
  throw SolveError(advice::shortest_step_fails(committed_.s.time, h_, because,
                                               folded_element(system_, committed_kinematics())));
}

}  // namespace hawser
