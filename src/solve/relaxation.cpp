// The loop of dynamic relaxation: the fictitious mass and its changes, implicit steps in pseudo-time, kinetic
// damping at peaks of the kinetic energy, and the test for stagnation.
#include "hawser/solve/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/advice/statics.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/solve/kink_stiffness.hpp"
#include "hawser/solve/static_trial.hpp"
#include "hawser/system/imbalance.hpp"

namespace hawser {
namespace {

// Newton iterations of a step: limit; number up to which the mass decreases
constexpr int kMaxIterations = 12, kEasyIterations = 4;
constexpr int kMaxOnKinks = 24;      // limit where Newton's iteration has to find kinks
constexpr double kReduction = 1e-4;  // of the imbalance, for a step to count as solved
// The same with friction of contact after kMaxIterations: forces may jump at kinks whose secants converge
// slowly. The next step includes what is left.
constexpr double kReductionOnKinks = 0.1;
// Growth of the imbalance beyond which Newton's iteration has diverged.
constexpr double kDivergenceRatio = 1e6;
// Factors of the mass after a rejected step, and after one of few iterations.
constexpr double kHeavier = 4, kLighter = 0.5;
// After this number of accepted steps in a row an earlier rejection no longer explains a failure, because the
// mass is then lower than before that rejection.
constexpr int kForgetsRejection = 4;
// Residual, as a fraction of the largest tension of its line, that may remain with friction if lines no
// longer move: far below the friction forces, whose coefficients are hardly known to a tenth.
constexpr double kMayRemain = 5e-3;
constexpr double kFirstMove = 0.002;  // fraction of the longest line by which the first step may move nodes
constexpr double kHeaviest = 1e12;    // ratio of the mass to the first one at which motion is negligible
// Lengths of the longest line: a body that has slid or fallen so far does not come to rest.
constexpr double kMaxSlide = 10;

// The step of pseudo-time is 1, so velocities are increments and the mass is a stiffness: N/m at positions, N
// m at rotations.
class Relaxation : StaticTrial {
 public:
  Relaxation(System& system, const RelaxationSettings& settings, State& state)
      : StaticTrial(system, state),
        settings_(settings),
        start_(state.x.begin(), state.x.begin() + system.mesh().owned) {
    momentum_.assign(3 * static_cast<size_t>(system.mesh().owned_blocks), 0);
    turns_.assign(system.mesh().owned_blocks, 0);
    for (int n = 0; n < system.mesh().owned; ++n)
      if (system.mesh().rotates(n)) turns_[system.mesh().block[n] + 1] = 1;
    check(SNESSetTolerances(snes_.get(), 0, 0, 0, kMaxOnKinks, PETSC_DEFAULT));
  }

  RelaxationReport run() {
    RelaxationReport report;
    double smallest = 0, kinetic = 0;
    int free = 0;  // steps since the last rejection
    if (settings_.pushed > 0) push_state(settings_.pushed);
    while (true) {
      prepare();
      system_.residual(state_.at_rest(), r_.get());
      report.norms = system_.norms(r_.get());
      if (settings_.progress) settings_.progress(report);
      if (report.norms.small(settings_.tolerance)) return report;
      if (mass_ == 0) mass_ = smallest = first_mass(report.norms);
      const bool all_used = report.steps + report.rejected >= settings_.max_steps;
      if (all_used || mass_ > kHeaviest * smallest || !std::isfinite(report.norms.relative()))
        throw_no_rest(report, all_used);
      if (test_progress(report)) {
        if (settings_.friction) report.remaining = small_remainder(report.norms);
        if (!report.remaining) throw_no_rest(report, all_used);
        return report;
      }
      const int iterations = attempt(report.norms);
      report.iterations += std::abs(iterations);
      if (iterations <= 0) {
        ++report.rejected;
        free = 0;
        scale_mass(kHeavier);
        continue;
      }
      ++report.steps;
      accept_trial();
      if (++free > kForgetsRejection) blocked_by_.reset();
      if (iterations <= kEasyIterations) scale_mass(kLighter);
      if (kinks_.active() && rests_on_kinks(report)) return report;
      if (settings_.friction) {
        system_.commit(state_.at_rest());
        check_bodies();
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
    const double nodes = static_cast<double>(system_.mesh().mesh->nodes());
    const double force = std::max(n.force, n.moment / std::max(length_, 1e-300));
    return force / std::sqrt(nodes) / (kFirstMove * longest_);
  }
  // Every kWatched steps, tried again or not: returns true if the iteration stagnates. If the imbalance has
  // not halved, relaxation continues without momentum if it had it, and vice versa: drag has no potential and
  // can feed a motion that kinetic damping does not end.
  bool test_progress(const RelaxationReport& report) {
    const int tried = report.steps + report.rejected;
    if (tried % kWatched != 0) return false;
    const Progress since = progress(report.norms);
    if (!since.halved) viscous_ = !viscous_;
    return since.stagnates;
  }
  // The residual of the node that is furthest from equilibrium relative to the tension of its line (a moment:
  // as a pair of forces on the longest element); nullopt if it is too large to remain. Collective.
  std::optional<advice::Imbalance> small_remainder(const ResidualNorms& norms) const {
    const LocalMesh& m = system_.mesh();
    const std::vector<LineTension> lines = system_.line_tensions(state_.at_rest());
    struct Remainder {
      double ratio = 0, force = 0, tension = 0;
      int node = 0;
    } worst;
    const PetscScalar* r = nullptr;
    check(VecGetArrayRead(r_.get(), &r));
    for (int n = 0; n < m.owned; ++n) {
      const PetscScalar* at = r + 3 * m.block[n];
      double force = Eigen::Map<const Vec3>(at).norm();
      if (m.rotates(n)) force = std::max(force, Eigen::Map<const Vec3>(at + 3).norm() / length_);
      const Node& node = m.node(n);
      const double tension = node.body < 0 ? lines[static_cast<size_t>(node.line)].tension : 0;
      const double ratio = force / std::max(kMayRemain * tension, settings_.tolerance * norms.force_scale);
      if (ratio > worst.ratio) worst = {ratio, force, tension, m.global[n]};
    }
    check(VecRestoreArrayRead(r_.get(), &r));
    Remainder largest;
    for (const Remainder& of_rank : gather_all(system_.comm(), std::vector{worst}))
      if (of_rank.ratio > largest.ratio) largest = of_rank;
    if (largest.ratio > 1) return std::nullopt;
    return advice::Imbalance{
        .place = m.mesh->place(largest.node), .value = largest.force, .scale = largest.tension};
  }
  // Throws SolveError if a body slides or falls without end.
  void check_bodies() const {
    const LocalMesh& m = system_.mesh();
    struct {
      double far;
      int node;
    } farthest{0, -1};
    for (size_t n = 0; n < start_.size(); ++n) {
      const double far = (state_.x[n] - start_[n]).norm();
      if (m.node(n).body >= 0 && far > farthest.far) farthest = {far, m.global[n]};
    }
    MPI_Allreduce(MPI_IN_PLACE, &farthest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, system_.comm());
    if (farthest.far > kMaxSlide * longest_)
      throw SolveError(advice::body_moves_on(m.mesh->place(farthest.node), farthest.far));
  }
  [[noreturn]] void throw_no_rest(const RelaxationReport& report, bool all_used) {
    check_bodies();
    try {
      throw_no_equilibrium(advice::no_rest(report.steps, imbalance(system_, r_.get(), report.norms)));
    } catch (const SolveError& failure) {
      if (all_used) throw RelaxationStepsUsed(failure.what());
      throw;
    }
  }
  // Changes the mass. This is equivalent to another step of time, so increments are scaled to keep the speed.
  void scale_mass(double factor) {
    mass_ *= factor;
    for (double& p : momentum_) p /= std::sqrt(factor);
  }
  double mass(size_t block) const { return turns_[block] ? mass_ * length_ * length_ : mass_; }

  double kinetic_energy() const {
    double e = 0;
    for (size_t i = 0; i < momentum_.size(); ++i) e += 0.5 * mass(i / 3) * momentum_[i] * momentum_[i];
    return sum_of_ranks(e);
  }
  void copy_momentum() {
    std::copy(local_.begin(), local_.begin() + static_cast<std::ptrdiff_t>(momentum_.size()),
              momentum_.begin());
  }

  // Residual of the trial with inertia forces. An increment that is far too large, or is not a number, is a
  // domain error.
  void residual() override {
    if (!(largest_factor() > 0.1)) {
      check(SNESSetFunctionDomainError(snes_.get()));
      return;
    }
    move_trial(1);
    system_.residual(trial_.at_rest(), r_.get());
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
    system_.tangent(trial_.at_rest(), weights, local_, false, J_.get());
    kinks_.add_to(system_, J_.get());
  }
  SNESConvergedReason test_convergence(int iteration) override {
    const ResidualNorms norms = system_.norms(r_.get());
    if (iteration == 0) {
      divergence_limit_ = kDivergenceRatio * std::max(norms.relative(), 1e-6);
      return SNES_CONVERGED_ITERATING;
    }
    if (!std::isfinite(norms.force) || norms.relative() > divergence_limit_) return SNES_DIVERGED_DTOL;
    if (norms.relative() <= goal_) return SNES_CONVERGED_FNORM_RELATIVE;
    if (settings_.friction && iteration >= kMaxIterations &&
        norms.relative() <= goal_ * (kReductionOnKinks / kReduction))
      return SNES_CONVERGED_FNORM_RELATIVE;
    if (!kinks_.observe(local_.data(), r_.get(), norms.relative()))
      return iteration < kMaxIterations ? SNES_CONVERGED_ITERATING : SNES_DIVERGED_MAX_IT;
    const double goal = std::max(goal_, settings_.tolerance);
    return kinks_.norms_without_jumps(system_, r_.get(), length_).small(goal) ? SNES_CONVERGED_FNORM_RELATIVE
                                                                              : SNES_CONVERGED_ITERATING;
  }

  // True if the residual of the accepted state consists of jumps of forces only.
  bool rests_on_kinks(RelaxationReport& report) {
    system_.residual(state_.at_rest(), r_.get());
    if (!kinks_.norms_without_jumps(system_, r_.get(), length_).small(settings_.tolerance)) return false;
    report.norms = system_.norms(r_.get());
    if (settings_.friction) system_.commit(state_.at_rest());
    return true;
  }

  // Tries one step. Returns the number of Newton iterations, or minus that number if the step failed.
  int attempt(const ResidualNorms& at_rest) {
    const double before = potential(state_) + kinetic_energy();
    goal_ = std::max(1e-3 * settings_.tolerance, kReduction * at_rest.relative());
    kinks_.clear();
    const bool solved = solve() > 0;
    PetscInt solutions = 0;
    check(SNESGetLinearSolveIterations(snes_.get(), &solutions));
    const int it = kinks_.active() ? kinks_.smooth_iterations() : std::max(1, static_cast<int>(solutions));
    if (!solved || largest_factor() < 1 || !path_is_clear()) return -it;
    if (settings_.friction) return it;  // friction has no potential
    // An exact step of a convex potential reduces the energy. If the energy has grown, the step has led
    // elsewhere.
    double motion = 0;
    for (size_t i = 0; i < momentum_.size(); ++i) motion += 0.5 * mass(i / 3) * local_[i] * local_[i];
    const double after = potential(trial_) + sum_of_ranks(motion);
    return after <= before + 1e-6 * std::abs(before) ? it : -it;
  }

  const RelaxationSettings& settings_;
  std::vector<double> momentum_;  // of owned components
  std::vector<char> turns_;       // by owned block: whether it is a rotation
  double mass_ = 0;
  KinkStiffness kinks_;
  bool viscous_ = false;  // momentum is dropped after each step
  // relative imbalance at which a step is solved, and at which it has failed
  double goal_ = 0, divergence_limit_ = 0;
  const std::vector<Vec3> start_;  // places of owned nodes where relaxation began
};

}  // namespace

RelaxationReport relax(System& system, const RelaxationSettings& settings, State& state) {
  return Relaxation(system, settings, state).run();
}

}  // namespace hawser
