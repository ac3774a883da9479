// The loop of dynamic relaxation: fictitious mass and its changes, implicit pseudo-time steps, kinetic
// damping at peaks of the kinetic energy, and the test for motion that only creeps.
#include "hawser/solve/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/base/gather.hpp"
#include "hawser/solve/static_trial.hpp"
#include "hawser/system/imbalance.hpp"

namespace hawser {
namespace {

constexpr int kMostIterations = 12, kEasyIterations = 4;  // of Newton, a step
constexpr double kReduction = 1e-4;                       // of the imbalance, before a step counts as solved
constexpr double kHopeless = 1e6;                         // growth of it from which Newton does not come back
constexpr double kHeavier = 4, kLighter = 0.5;
// Accepted steps in a row after which an earlier rejection no longer explains a failure: the mass is then
// lower than before that rejection.
constexpr int kFree = 4;
constexpr double kFirst = 0.002;    // of the longest line, that the first step may bring
constexpr double kHeaviest = 1e12;  // mass over that of the start at which nothing moves any more
// So many steps, tried again or not, that bring no node by this share of the longest line and do not take
// half of the imbalance: what lies in a heap creeps on for ever.
constexpr int kWatched = 50;
constexpr double kCreep = 1e-4;

// The pseudo-time's step is 1, so velocities are increments and the mass is a stiffness: N/m at positions,
// N m at rotations.
class Relaxation : StaticTrial {
 public:
  Relaxation(System& system, const RelaxationSettings& settings, State& state)
      : StaticTrial(system, state), settings_(settings) {
    momentum_.assign(3 * static_cast<size_t>(system.mesh().owned_blocks), 0);
    for (const LineSpan& l : system.mesh().mesh->lines) longest_ = std::max(longest_, l.length);
    turns_.assign(system.mesh().owned_blocks, 0);
    for (int n = 0; n < system.mesh().owned; ++n)
      if (system.mesh().rotates(n)) turns_[system.mesh().block[n] + 1] = 1;
    check(SNESSetTolerances(snes_.get(), 0, 0, 0, kMostIterations, PETSC_DEFAULT));
  }

  RelaxationReport run() {
    RelaxationReport report;
    double least = 0, kinetic = 0;
    int free = 0;  // steps since one was rejected
    if (settings_.pushed > 0) perturb(settings_.pushed);
    while (true) {
      prepare();
      system_.residual(state_.view(0), r_.get());
      report.norms = system_.norms(r_.get());
      if (settings_.progress) settings_.progress(report);
      if (report.norms.small(settings_.tolerance)) return report;
      if (mass_ == 0) mass_ = least = first_mass(report.norms);
      if (report.steps + report.rejected >= settings_.max_steps || mass_ > kHeaviest * least ||
          !std::isfinite(report.norms.relative()) || creeps(report))
        throw_no_equilibrium(fmt::format("statics: no rest after {} steps of dynamic relaxation: {}",
                                         report.steps, imbalance(system_, r_.get(), report.norms)));
      const int iterations = attempt(report.norms);
      report.iterations += std::abs(iterations);
      if (iterations <= 0) {
        ++report.rejected;
        free = 0;
        weigh(kHeavier);
        continue;
      }
      ++report.steps;
      accept_trial();
      if (++free > kFree) blocked_by_.clear();
      if (iterations <= kEasyIterations) weigh(kLighter);
      if (settings_.friction) {
        system_.commit(state_.view(0));
        continue;
      }
      if (viscous_) {
        std::fill(momentum_.begin(), momentum_.end(), 0.0);
        continue;
      }
      copy_momentum();
      const double now = kinetic_energy();
      if (now < kinetic) {
        std::fill(momentum_.begin(), momentum_.end(), 0.0);
        kinetic = 0;
      } else {
        kinetic = now;
      }
    }
  }

 private:
  double first_mass(const ResidualNorms& n) const {
    const double nodes = static_cast<double>(system_.mesh().mesh->nodes.size());
    const double force = std::max(n.force, n.moment / std::max(length_, 1e-300));
    return force / std::sqrt(nodes) / (kFirst * longest_);
  }
  // Looks back every so many steps. What does not come nearer to rest with its momentum goes on without it,
  // and the other way round: drag has no potential and can feed a motion that kinetic damping does not end.
  bool creeps(const RelaxationReport& report) {
    const int tried = report.steps + report.rejected;
    if (tried % kWatched != 0) return false;
    double far = 0;
    for (size_t n = 0; n < last_places_.size(); ++n)
      far = std::max(far, (state_.x[n] - last_places_[n]).norm());
    all_reduce(system_.comm(), MPI_MAX, far);
    const bool nearer = tried == 0 || report.norms.relative() <= 0.5 * left_;
    const bool stuck = !nearer && far < kCreep * longest_;
    if (!nearer) viscous_ = !viscous_;
    last_places_.assign(state_.x.begin(), state_.x.begin() + system_.mesh().owned);
    left_ = report.norms.relative();
    return stuck;
  }
  // Another mass stands for another step in time: what moves goes on at its speed.
  void weigh(double factor) {
    mass_ *= factor;
    for (double& p : momentum_) p /= std::sqrt(factor);
  }
  double mass(size_t block) const { return turns_[block] ? mass_ * length_ * length_ : mass_; }

  double kinetic_energy() const {
    double e = 0;
    for (size_t i = 0; i < momentum_.size(); ++i) e += 0.5 * mass(i / 3) * momentum_[i] * momentum_[i];
    return sum(e);
  }
  void copy_momentum() {
    std::copy(local_.begin(), local_.begin() + static_cast<std::ptrdiff_t>(momentum_.size()),
              momentum_.begin());
  }

  // Of the trial, with the force of inertia. What is far too far, or not a number, has none.
  void residual() override {
    if (!(limit() > 0.1)) {
      check(SNESSetFunctionDomainError(snes_.get()));
      return;
    }
    step(1);
    system_.residual(trial_.view(0), r_.get());
    PetscScalar* r = nullptr;
    check(VecGetArray(r_.get(), &r));
    for (size_t i = 0; i < momentum_.size(); ++i)
      if (!(system_.tied_nodes().held()[i / 3] >> (i % 3) & 1))
        r[i] += mass(i / 3) * (local_[i] - momentum_[i]);
    check(VecRestoreArray(r_.get(), &r));
  }
  void tangent() override {
    Weights weights;
    weights.shift_position = mass_;
    weights.shift_rotation = mass_ * length_ * length_;
    system_.tangent(trial_.view(0), weights, local_, false, J_.get());
  }
  SNESConvergedReason check_step(int iteration) override {
    const ResidualNorms norms = system_.norms(r_.get());
    if (iteration == 0) {
      hopeless_ = kHopeless * std::max(norms.relative(), 1e-6);
      return SNES_CONVERGED_ITERATING;
    }
    if (!std::isfinite(norms.force) || norms.relative() > hopeless_) return SNES_DIVERGED_DTOL;
    return norms.relative() > goal_ ? SNES_CONVERGED_ITERATING : SNES_CONVERGED_FNORM_RELATIVE;
  }

  // One step: Newton's iterations, or minus them where it failed.
  int attempt(const ResidualNorms& at_rest) {
    const double before = potential(state_) + kinetic_energy();
    goal_ = std::max(1e-3 * settings_.tolerance, kReduction * at_rest.relative());
    const bool solved = solve() > 0;
    PetscInt solutions = 0;
    check(SNESGetLinearSolveIterations(snes_.get(), &solutions));
    const int it = std::max(1, static_cast<int>(solutions));
    if (!solved || limit() < 1 || !path_is_clear()) return -it;
    if (settings_.friction) return it;  // it has no potential
    // The exact step of a convex potential takes energy out; one that brings some has gone elsewhere.
    double motion = 0;
    for (size_t i = 0; i < momentum_.size(); ++i) motion += 0.5 * mass(i / 3) * local_[i] * local_[i];
    const double after = potential(trial_) + sum(motion);
    return after <= before + 1e-6 * std::abs(before) ? it : -it;
  }

  const RelaxationSettings& settings_;
  std::vector<double> momentum_;  // of owned components
  std::vector<char> turns_;       // by owned block: rotations
  double mass_ = 0, longest_ = 0;
  bool viscous_ = false;            // without momentum
  double goal_ = 0, hopeless_ = 0;  // relative imbalance of a step that is solved, of one that has failed
  std::vector<Vec3> last_places_;   // places of owned nodes when creeps() last looked
  double left_ = 0;                 // and the imbalance then, of its contributions
};

}  // namespace

RelaxationReport relax(System& system, const RelaxationSettings& settings, State& state) {
  return Relaxation(system, settings, state).run();
}

}  // namespace hawser
