// The class Dynamics: Newton's iteration of a time step, reuse of old tangents, accelerations at the start,
// and commitment of an accepted step. Acceptance is decided in step_decision.cpp.
#include "hawser/solve/dynamics.hpp"

#include <petscdm.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/steps.hpp"
#include "hawser/base/error.hpp"

namespace hawser {

namespace {

// Relative residual at which iterations are counted. Step control uses the number of iterations to this
// coarse residual plus one. The number to the final tolerance may differ by one between numbers of ranks
// because of rounding.
constexpr double kCounted = 1e-5;
// Where iterations repeat, or have stagnated at their limit, Newton's method gets kOnKinks more with secants
// (kink_stiffness.hpp), since a line may lie on kinks between facets. Stagnation below the limit does not
// suffice: iterations in which contact sticks and slips stagnate temporarily, and secants make them slower
// (decision 036).
constexpr int kOnKinks = 24;
constexpr int kMaxRaises = 40;  // Most raises of penalty stiffness within one try of a step.
// Arguments of SNESSetLagJacobian: compute no new tangent; compute one at the next iteration only.
constexpr PetscInt kKeepTangent = -1, kNextTangent = -2;
// Growth of the residual beyond which Newton's iteration has diverged. Contact alone may raise the residual
// by a factor of 1e4.
constexpr double kDivergenceRatio = 1e10;
// The old tangent is kept only if the residual falls by this factor in one iteration and two iterations are
// expected to reach the tolerance. Otherwise a new tangent is cheaper.
constexpr double kChordRate = 0.1;

// True if iterations with the old tangent, which cost a fourth of those with a new one, are expected to reach
// the tolerance. Newton's error falls as e1 = C e0²; with the old tangent it then falls as e2 = 2 C e0 e1
// (chord method: Kelley 1995, Iterative Methods for Linear and Nonlinear Equations, section 5.4). `before`
// and `now` are relative residuals. `by_old_tangent`: the iteration from `before` to `now` used the old
// tangent, too.
bool old_tangent_suffices(double before, double now, bool by_old_tangent, double tolerance) {
  const double rate = (by_old_tangent ? 1 : 2) * now / before;
  return rate < kChordRate && now * rate * rate < tolerance;
}

}  // namespace

Dynamics::Dynamics(System& system, const DynamicsSettings& settings)
    : system_(system), settings_(settings), alpha_(settings.rho_infinity), control_(settings.step) {
  length_ = system.mesh().mesh->longest_element();
  check(TSCreate(system_.comm(), ts_.out()));
  check(TSSetOptionsPrefix(ts_.get(), "dynamics_"));
  check(TSSetProblemType(ts_.get(), TS_NONLINEAR));
  lie_alpha_attach(ts_.get(), this);
  check(TSGetSNES(ts_.get(), &snes_));
  check(SNESSetType(snes_, SNESNEWTONLS));
  SNESLineSearch search = nullptr;
  check(SNESGetLineSearch(snes_, &search));
  check(SNESLineSearchSetType(search, SNESLINESEARCHBASIC));
  check(SNESSetTolerances(snes_, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT,
                          settings_.max_iterations + kOnKinks, PETSC_DEFAULT));
  check(SNESSetConvergenceTest(snes_, converged, this, nullptr));
  build();
  lie_alpha_options(ts_.get());
  // judge_iteration() requests each new tangent. The linear solver detects it by the state of the matrix.
  check(SNESSetLagJacobian(snes_, kKeepTangent));
}

// Creates everything that depends on the ghosts and on the pattern of the matrix.
void Dynamics::build() {
  copied_ = false;
  u_ = system_.create_vector();
  check(VecDuplicate(u_.get(), r_.out()));
  J_ = system_.create_matrix();
  // PETSc duplicates its work vectors from the solution of the TS and keeps them, so they are cleared here.
  DM dm = nullptr;
  check(TSGetDM(ts_.get(), &dm));
  check(DMClearGlobalVectors(dm));
  check(TSSetSolution(ts_.get(), u_.get()));
  check(SNESReset(snes_));
  check(SNESSetFunction(snes_, r_.get(), residual, this));
  check(SNESSetJacobian(snes_, J_.get(), J_.get(), tangent, this));
  KspHandle ksp;
  check(KSPCreate(system_.comm(), ksp.out()));
  check(SNESSetKSP(snes_, ksp.get()));
  configure_linear_solver(ksp.get(), system_, "dynamics_");
}

void Dynamics::prepare(double h, const State* end) {
  const auto update_couplings = [&](const State& s) {
    return system_.update_couplings(step_origin(s, h), h);
  };
  if ((end ? update_couplings(straight_path(system_.mesh(), committed_.s, *end, h))
           : update_couplings(committed_.s)) == CouplingChange::layout_changed) {
    build();
    system_.update_ghosts(committed_.s);
    system_.update_ghosts(committed_.ax);
    if (has_directors(system_.mesh())) {
      system_.update_ghosts(committed_.aw);
      system_.update_ghosts(committed_.ad);
    }
    const size_t size = 3 * static_cast<size_t>(system_.mesh().blocks());
    reactions_.resize(size, 0);
    for (auto* rows : {&mean_.q, &mean_.f}) rows->resize(system_.mean_forces().size(), 0);
  }
  system_.prepare(step_origin(committed_.s, h), h);
  round_off_step_ = h;
}

void Dynamics::update_trial(Vec u) {
  const bool changed = system_.gather_with_ghosts(u, local_u_);
  if (trial_current_ && !changed) return;
  alpha_trial(system_.mesh(), system_.tied_nodes(), alpha_, h_, committed_, local_u_, trial_);
  trial_current_ = true;
}

void Dynamics::set_increment(const std::vector<double>& u) {
  PetscScalar* p = nullptr;
  check(VecGetArray(u_.get(), &p));
  std::copy(u.begin(), u.begin() + 3 * system_.mesh().owned_blocks, p);
  check(VecRestoreArray(u_.get(), &p));
  trial_current_ = false;
}

PetscErrorCode Dynamics::residual(SNES, Vec u, Vec r, void* self) {
  auto& d = *static_cast<Dynamics*>(self);
  return d.error_.capture([&] {
    d.update_trial(u);
    d.system_.residual(d.trial_.s.after_step(d.h_), r, d.mean_history_);
  });
}

// SNES evaluates the residual at u before the tangent, so trial_ already belongs to u.
PetscErrorCode Dynamics::tangent(SNES, Vec, Mat J, Mat, void* self) {
  auto& d = *static_cast<Dynamics*>(self);
  return d.error_.capture([&] {
    d.system_.tangent(d.trial_.s.after_step(d.h_), alpha_weights(d.alpha_, d.h_), d.local_u_, false, J);
    d.kinks_.add_to(d.system_, J);
  });
}

PetscErrorCode Dynamics::converged(SNES snes, PetscInt it, PetscReal, PetscReal, PetscReal fnorm,
                                   SNESConvergedReason* reason, void* self) {
  auto& d = *static_cast<Dynamics*>(self);
  return d.error_.capture([&] { *reason = d.judge_iteration(snes, static_cast<int>(it), fnorm); });
}

SNESConvergedReason Dynamics::judge_iteration(SNES snes, int it, double fnorm) {
  if (!std::isfinite(fnorm)) return SNES_DIVERGED_FNORM_NAN;
  Vec r = nullptr;
  check(SNESGetFunction(snes, &r, nullptr, nullptr));
  const double before = norms_.relative();  // one iteration ago
  norms_ = system_.norms(r);
  // The norms are square roots of sums of squares; the sums overflow before the residual does.
  if (!norms_.finite()) return SNES_DIVERGED_FNORM_NAN;
  if (it == 0) first_ = std::max({fnorm, norms_.force_scale, norms_.moment_scale});
  if (fnorm > kDivergenceRatio * first_ && first_ > 0) return SNES_DIVERGED_DTOL;
  const double tolerance = settings_.tolerance;
  if (counted_ < 0 && norms_.small(std::max(tolerance, kCounted))) counted_ = it;
  if (fnorm == 0) return SNES_CONVERGED_FNORM_ABS;
  if (it > 0 && norms_.small(tolerance)) return SNES_CONVERGED_FNORM_RELATIVE;
  const bool on_kinks = kinks_.observe(local_u_.data(), r, norms_.relative());
  if (on_kinks && kinks_.norms_without_jumps(system_, r, length_).small(tolerance))
    return SNES_CONVERGED_FNORM_RELATIVE;
  if (!on_kinks && it >= settings_.max_iterations) return SNES_DIVERGED_MAX_IT;
  old_tangent_ =
      !on_kinks && it > 0 && old_tangent_suffices(before, norms_.relative(), old_tangent_, tolerance);
  if (!old_tangent_) check(SNESSetLagJacobian(snes, kNextTangent));
  return SNES_CONVERGED_ITERATING;
}

// Runs Newton's method from u_. The iteration count of a try is the largest over its penalty raises.
void Dynamics::solve_once() {
  old_tangent_ = false;
  counted_ = -1;
  kinks_.clear(settings_.max_iterations);
  error_.check(SNESSolve(snes_, nullptr, u_.get()));
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  PetscInt its = 0;
  check(SNESGetConvergedReason(snes_, &reason));
  check(SNESGetIterationNumber(snes_, &its));
  attempt_.solved = reason > 0;
  // On kinks the step is judged by the iterations before the cycle.
  int counted = counted_ < 0 ? static_cast<int>(its) : counted_ + 1;
  if (kinks_.active()) counted = std::min(kinks_.smooth_iterations(), settings_.step.hard_iterations);
  attempt_.info.iterations = std::max(attempt_.info.iterations, counted);
}

int Dynamics::try_step(double h) {
  h_ = h;
  if (h != round_off_step_) system_.update_round_off(step_origin(committed_.s, h), h);
  round_off_step_ = h;
  // trial_ needs the values that a step does not change (rotations of cable nodes). After the first copy it
  // has those of the previous step.
  if (!copied_) trial_ = committed_;
  copied_ = true;
  alpha_mean_history(alpha_, mean_, mean_history_);
  alpha_predict(system_.mesh(), system_.tied_nodes(), h, committed_, local_u_);
  set_increment(local_u_);
  system_.revert_stiffness();
  attempt_.info.iterations = 0;
  for (int round = 0;; ++round) {
    solve_once();
    if (!attempt_.solved) break;
    update_trial(u_.get());
    if (!system_.adapt_stiffness(trial_.s.after_step(h_))) break;
    attempt_.solved = round < kMaxRaises;
    if (!attempt_.solved) break;
  }
  return attempt_.info.iterations;
}

void Dynamics::commit() {
  // Adds the work of prescribed ends: reactions by the trapezoidal rule, mean forces by their mean.
  const std::vector<double>& now = system_.reactions();
  const std::vector<double>& mean = system_.mean_forces();
  const LocalMesh& m = system_.mesh();
  const auto entry = [](const std::vector<double>& rows, size_t i) { return rows.empty() ? 0 : rows[i]; };
  const auto add_work = [&](const auto& force) {
    for (const TiedNode& s : system_.tied_nodes().nodes()) {
      if (s.node >= m.owned || s.frame >= 0) continue;
      const size_t b = 3 * static_cast<size_t>(m.block[static_cast<size_t>(s.node)]);
      const int n = m.rotates(s.node) ? 6 : 3;
      for (int c = 0; c < n; ++c)
        if ((c < 3 ? s.position_mask >> c : s.rotation_mask >> (c - 3)) & 1)
          support_work_ += force(b + static_cast<size_t>(c)) * local_u_[b + static_cast<size_t>(c)];
    }
  };
  add_work([&](size_t i) { return 0.5 * (reactions_[i] - entry(mean_.f, i)); });
  alpha_mean_advance(alpha_, mean, mean_);
  add_work([&](size_t i) { return 0.5 * (now[i] - entry(mean_.f, i)) + entry(mean, i); });
  reactions_ = now;
  std::swap(committed_, trial_);
  last_step_ = h_;
  round_off_step_ = -1;
  system_.commit(committed_.s.after_step(h_));
}

bool Dynamics::end_step() {
  commit();
  attempt_.info.time = committed_.s.time;
  attempt_.info.h = h_;
  return observer_(attempt_.info);
}

NodeValue Dynamics::largest_acceleration_change() const {
  NodeValue largest;  // After commit() trial_ is the previously committed state.
  for (size_t n = 0; n < static_cast<size_t>(system_.mesh().owned); ++n) {
    const double change = (committed_.ax[n] - trial_.ax[n]).norm();
    if (change > largest.value) largest = {change, system_.mesh().global[n]};
  }
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE_INT, MPI_MAXLOC, system_.comm());
  return largest;
}

// Solves M a = -r for a, ghosts included: M is in J_, the residual r (internal minus external forces) in r_.
// Throws SolveError when M is singular.
std::vector<double> Dynamics::accelerations() {
  KSP ksp = nullptr;
  check(SNESGetKSP(snes_, &ksp));
  check(KSPSetOperators(ksp, J_.get(), J_.get()));
  check(KSPSolve(ksp, r_.get(), u_.get()));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(ksp, &reason));
  PetscReal size = 0;
  check(VecNorm(u_.get(), NORM_INFINITY, &size));
  if (reason < 0 || !std::isfinite(size)) throw SolveError(advice::no_mass(committed_.s.time));
  std::vector<double> out;
  system_.gather_with_ghosts(u_.get(), out);
  for (double& a : out) a = -a;
  return out;
}

void Dynamics::start(const State& state) {
  committed_.s = state;
  copied_ = false;
  const size_t n = state.x.size();
  State& s = committed_.s;
  s.a.assign(n, Vec3::Zero());
  s.alpha.assign(n, Vec3::Zero());
  s.directors.clear();
  s.director_weight = 0;
  system_.tied_nodes().rates(s.time, s);
  system_.tied_nodes().move_with_frames(s);
  last_step_ = 0;
  const double h = control_.proposal();
  prepare(h);
  if (const auto line = system_.lost_in_rounding(s.at_rest()))
    throw SolveError(advice::tension_lost_at(s.time, *line));
  s.mean = {};
  system_.residual(s.at_start(h), r_.get());
  mean_.q = mean_.f = system_.mean_forces();
  const std::vector<double> zero(3 * static_cast<size_t>(system_.mesh().blocks()), 0);
  system_.tangent(s.at_start(h), {0, 0, 1}, zero, false, J_.get());
  const std::vector<double> a = accelerations();
  for (size_t i = 0; i < s.x.size(); ++i) {
    const double* p = a.data() + 3 * system_.mesh().block[i];
    s.a[i] += Eigen::Map<const Vec3>(p);
    if (system_.mesh().rotates(static_cast<int>(i))) s.alpha[i] += Eigen::Map<const Vec3>(p + 3);
  }
  system_.tied_nodes().move_with_frames(s);
  alpha_start(system_.mesh(), committed_);
  system_.residual(s.at_start(h), r_.get());
  reactions_ = system_.reactions();
}

void Dynamics::resume(const AlphaState& state, std::vector<double> reactions, const RestartData& data) {
  committed_ = state;
  copied_ = false;
  reactions_ = std::move(reactions);
  control_.restore(data.step_proposal, data.step_wait, data.step_impact_period, data.step_resolved_until);
  last_step_ = data.last_step;
  support_work_ = data.support_work;
  mean_ = data.mean;
  for (auto* rows : {&mean_.q, &mean_.f}) rows->resize(system_.mean_forces().size());
  prepare(control_.proposal());
}

void Dynamics::run(double until, const std::function<double(double)>& next_stop, const Observer& observer) {
  if (committed_.s.time >= until - 1e-12 * std::max(1.0, until)) return;
  next_stop_ = [&, until](double t) { return std::min(next_stop(t), until); };
  observer_ = observer;
  check(TSSetTime(ts_.get(), committed_.s.time));
  check(TSSetTimeStep(ts_.get(), control_.proposal()));
  check(TSSetMaxTime(ts_.get(), until));
  check(TSSetMaxSteps(ts_.get(), PETSC_MAX_INT));
  check(TSSetStepNumber(ts_.get(), 0));
  error_.check(TSSolve(ts_.get(), nullptr));
}

}  // namespace hawser
