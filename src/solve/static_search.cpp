// Newton's descent with line search, soft lines first, and how unstable equilibria are left.
#include "static_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/system/imbalance.hpp"

namespace hawser {
namespace {

constexpr double kArmijo = 1e-4;
constexpr double kSoft = 300, kStiffening = 30;  // axial stiffness over load at the start, and a stage on
constexpr int kHalvings = 30, kMaxEscapes = 3, kPolish = 4;
constexpr double kNegative =
    1e-7;  // shift that eigenvalues of what lies slack, nothing but round-off, stay below
// Iterations after which energies that differ by round-off alone no longer pass for going down: a slack chain
// whose elements tighten and loosen in turn would go round for ever.
constexpr int kRound = 20;
constexpr int kMostCut = 100;  // steps of a descent that lines in their way may cut short

}  // namespace

StaticsReport StaticSearch::run(bool again) {
  StaticsReport report;
  if (!again) approach(report);
  for (;;) {
    descend(report, settings_.tolerance);
    Weights weights;
    set_shift(kNegative, report.norms, weights);
    system_.tangent(state_.view(0), weights, zero_, false, J_.get());
    check(KSPReset(ksp_.get()));  // its factors need not be in memory beside those of the inertia
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

void StaticSearch::check_start() {
  system_.residual(state_.view(0), r_.get());
  const ResidualNorms norms = system_.norms(r_.get());
  if (!norms.finite()) throw SolveError("statics: " + imbalance(system_, r_.get(), norms));
}

void StaticSearch::approach(StaticsReport& report) {
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

void StaticSearch::descend(StaticsReport& report, double tolerance) {
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
    if (it >= settings_.max_iterations) give_up(failure(norms, "too many iterations"));
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
    // Cut short again and again by what lines would pass through: they come ever nearer, and there is no way
    // on.
    if (!blocked) in_the_way_.clear();
    cut += blocked;
    if ((!taken && shift > 1e6) || cut > kMostCut) {
      system_.residual(state_.view(0), r_.get());
      if (norms.small(100 * tolerance)) return;  // round-off of very stiff lines
      give_up(failure(norms, "no descent"));
    }
    shift = std::clamp(taken && halvings <= 1 && (full || close) ? 0.2 * shift
                       : taken && halvings <= 1                  ? shift
                                                                 : 4 * shift,
                       1e-9, 1e7);
    if (!taken) shift *= 10;
  }
}

void StaticSearch::polish(StaticsReport& report) {
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

void StaticSearch::set_shift(double shift, const ResidualNorms& norms, Weights& w) const {
  PetscInt unknowns = 0;
  check(VecGetSize(u_.get(), &unknowns));
  const double unit = norms.force_scale / std::sqrt(static_cast<double>(unknowns)) / length_;
  w.shift_position = shift * unit;
  w.shift_rotation = shift * unit * length_ * length_;
}

double StaticSearch::direction(bool exact, double shift, const ResidualNorms& norms) {
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

void StaticSearch::rest(StaticsReport& report) {
  const RelaxationReport r = relax(system_, *relaxation_, state_);
  report.iterations += r.iterations, report.relaxation_steps += r.steps;
  build();
  local_ = zero_;
  trial_ = state_;
  prepare();
}

std::string StaticSearch::failure(const ResidualNorms& n, const char* why) const {
  return fmt::format("statics: {}: {}", why, imbalance(system_, r_.get(), n));
}

}  // namespace hawser
