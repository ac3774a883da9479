// The class StaticSearch: Newton's method with a line search on the energy, which begins with soft lines and
// leaves unstable equilibria.
#include "static_search.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/system/imbalance.hpp"

namespace hawser {
namespace {

constexpr double kArmijo = 1e-4;
constexpr double kRounding = 1e-10;  // relative difference of energies below which it is rounding
constexpr double kFirstShift = 1e-3;
// Ratio of axial stiffness to load at the start; its factor from level to level.
constexpr double kSoft = 300, kStiffening = 30;
constexpr int kMaxTrials = 30, kMaxEscapes = 3, kMaxPolishing = 4;
// A push ends where the forces that drive it vanish first: number of its trials up to the longest step, and
// the relative accuracy of that place.
constexpr int kPartsOfPush = 16;
constexpr double kEndOfPush = 0.1;
constexpr double kSamePlace = 1e-6;  // relative to the longest line, for the side to which bodies are pushed
// Relative shift of the tangent whose stability is judged: eigenvalues of slack parts, which are round-off,
// are below it.
constexpr double kStabilityShift = 1e-7;
// Limits of the relative shift, and the one above which a search without descent ends.
constexpr double kMinShift = 1e-9, kMaxShift = 1e7, kShiftAtEnd = 1e6;
// Factor of a shortened step below which the energy may have a kink, the distance of its sides as a fraction
// of the longest element, and the change of slope between them as a fraction of the slope at the state.
constexpr double kShortened = 0.25, kWidth = 1e-8, kJump = 0.1;
constexpr int kSlow = 100;        // iterations without a halved residual that end a level of soft lines
constexpr int kMaxBlocked = 100;  // most steps of a descent that blocking lines may shorten

}  // namespace

StaticSearch::StaticSearch(System& system, const StaticsSettings& settings, State& state,
                           const RelaxationSettings* relaxation)
    : StaticTrial(system, state), settings_(settings), relaxation_(relaxation) {
  SNESLineSearch line = nullptr;
  check(SNESGetLineSearch(snes_.get(), &line));
  check(SNESLineSearchSetType(line, SNESLINESEARCHSHELL));
  check(SNESLineSearchShellSetUserFunc(line, search, this));
  // If a tangent is singular, the next one has a larger shift.
  check(SNESSetMaxLinearSolveFailures(snes_.get(), PETSC_MAX_INT));
  check(SNESSetTolerances(snes_.get(), 0, 0, 0, settings.max_iterations + 1, PETSC_DEFAULT));
}

StaticsReport StaticSearch::run(From from) {
  const State start = state_;
  if (from == From::start_shape) stiffen_by_levels();
  State last_equilibrium;  // the equilibrium that was left last
  double push = 0;         // m, distance from it at which relaxation began
  int pushes_of_lines = 0;
  int pushes_of_bodies = 0;
  for (;;) {
    descend(settings_.tolerance);
    const Stability found = judge();
    report_.negative_eigenvalues = found.negative;
    // Friction has an unsymmetric tangent; the inertia of its symmetric part does not decide on stability.
    if (settings_.starts_near || report_.negative_eigenvalues <= 0) break;
    // The same holds for drag. An equilibrium is therefore stable if relaxation returns to within the
    // distance of the perturbation.
    if (push > 0 && distance_from(last_equilibrium) < push) {
      report_.negative_eigenvalues = -1;
      --report_.escapes;
      break;
    }
    push = 0;
    if (found.by_bodies) {
      // Every body may have to be pushed off on its own.
      const int most = kMaxEscapes * system_.mesh().mesh->body_nodes();
      if (!found.motion || pushes_of_bodies++ == most || !push_from_equilibrium(found.motion.get(), start))
        break;
      ++report_.escapes;
      continue;
    }
    if (pushes_of_lines == kMaxEscapes || system_.mesh().mesh->lines.empty()) break;
    ++pushes_of_lines;
    ++report_.escapes;
    last_equilibrium = state_;
    push_state(pushes_of_lines);
    if (!relaxation_) continue;
    const double pushed = distance_from(last_equilibrium);
    if (relax_from_push()) push = pushed;
  }
  polish();
  return report_;
}

Stability StaticSearch::judge() {
  use_tangent(TangentKind::exact, kStabilityShift);
  weights_.stabilisation = 0;
  tangent();
  // Frees the factors, so that they are not in memory together with those of the inertia.
  check(KSPReset(ksp_.get()));
  return stability(system_, state_.at_rest(), J_.get());
}

bool StaticSearch::push_from_equilibrium(Vec motion, const State& start) {
  const State equilibrium = state_;
  const double first = sign_towards(start, motion);
  for (const double sign : {first, -first}) {
    check(VecCopy(motion, u_.get()));
    check(VecScale(u_.get(), sign));
    push_along();
    const double pushed = distance_from(equilibrium);
    try {
      if (relaxation_) relax_from_push();
      descend(settings_.tolerance);
      if (distance_from(equilibrium) > 0.5 * pushed) return true;
    } catch (const RelaxationStepsUsed&) {
      throw;
    } catch (const SolveError&) {  // nothing stops this motion
      if (relaxation_ && sign != first) throw;
      blocked_by_.reset();
    }
    state_ = equilibrium;
    system_.update_ghosts(state_);
    prepare_again();
  }
  residual();
  return false;
}

double StaticSearch::sign_towards(const State& start, Vec motion) {
  system_.gather_with_ghosts(motion, local_);
  const LocalMesh& mesh = system_.mesh();
  double along = 0;
  double square = 0;
  for (int n = 0; n < mesh.owned; ++n) {
    if (mesh.node(n).body < 0) continue;
    const double* u = local_.data() + 3 * mesh.block[n];
    const Vec3 x(u);
    const Vec3 turn = longest_ * Vec3(u + 3);
    along +=
        x.dot(start.x[n] - state_.x[n]) + longest_ * turn.dot(log_so3(state_.q[n].conjugate() * start.q[n]));
    square += x.squaredNorm() + turn.squaredNorm();
  }
  all_reduce(system_.comm(), MPI_SUM, along);
  all_reduce(system_.comm(), MPI_SUM, square);
  return along < -kSamePlace * longest_ * std::sqrt(square) ? -1 : 1;
}

void StaticSearch::push_along() {
  system_.gather_with_ghosts(u_.get(), local_);
  const auto forces_drive = [&](double factor) {
    move_trial(factor);
    if (!path_is_clear()) return false;
    system_.residual(trial_.at_rest(), r_.get());
    return slope_at_trial() < 0;
  };
  const double longest = 1 / relative_size();
  double under = 0;
  double beyond = longest / kPartsOfPush;
  while (under < longest && forces_drive(beyond)) {
    under = beyond;
    beyond += longest / kPartsOfPush;
  }
  for (int trial = 0; trial < kMaxTrials && under < longest && beyond - under > kEndOfPush * beyond;
       ++trial) {
    const double factor = 0.5 * (under + beyond);
    (forces_drive(factor) ? under : beyond) = factor;
  }
  move_trial(under);
  accept_trial();
}

void StaticSearch::check_start() {
  residual();
  if (!report_.norms.finite()) throw SolveError(failure(advice::StaticsEnds::forces_beyond_numbers));
}

void StaticSearch::residual() {
  system_.residual(state_.at_rest(), r_.get());
  report_.norms = system_.norms(r_.get());
}

void StaticSearch::tangent() {
  system_.tangent(state_.at_rest(), weights_, zero_, !exact_, J_.get());
  add_slopes_of_vertical_moments();
}

// With the moment m of a body in its axes and n = R^T e_z,
//   d(n.m) = n.dm + (m x n).d phi,   d n = n x d phi.
// dm alone gives the first part, n (m x n)' adds the second. Hydrostatics has no moment about the vertical,
// n.m = 0, and the sum is zero; the first part alone is not. A body without stiffness in yaw would balance it
// by a large rotation about the vertical. In equilibrium m and the addition are zero.
void StaticSearch::add_slopes_of_vertical_moments() {
  const LocalMesh& mesh = system_.mesh();
  if (!mesh.mesh->has_frames()) return;
  const PetscScalar* r = nullptr;
  check(VecGetArrayRead(r_.get(), &r));
  for (int node = 0; node < mesh.owned; ++node) {
    if (mesh.node(node).body < 0) continue;
    const int block = mesh.block[node] + 1;
    const Eigen::Map<const Vec3> m(r + 3 * block);
    const Vec3 n = state_.q[node].conjugate() * Vec3::UnitZ();
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> slope = n * m.cross(n).transpose();
    const PetscInt row = mesh.global_block[block];
    check(MatSetValuesBlocked(J_.get(), 1, &row, 1, &row, slope.data(), ADD_VALUES));
  }
  check(VecRestoreArrayRead(r_.get(), &r));
  check(MatAssemblyBegin(J_.get(), MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(J_.get(), MAT_FINAL_ASSEMBLY));
}

void StaticSearch::stiffen_by_levels() {
  residual();
  const double stiff = system_.axial_stiffness();
  const double load = system_.dead_load();
  if (load == 0 || tangent_trusted(report_.norms)) return;
  for (double soft = kSoft * load; soft < stiff; soft *= kStiffening) {
    system_.limit_axial_stiffness(soft);
    descend(1e-4);
  }
  if (system_.limit_axial_stiffness(stiff)) descend(1e-4);  // with yielding, from the elastic equilibrium
  system_.restore_sections();
}

void StaticSearch::descend(double tolerance) {
  tolerance_ = tolerance;
  shift_ = kFirstShift;
  blocked_steps_ = 0;
  forget_progress();
  stagnates_ = false;
  slow_ = 0;
  least_residual_ = HUGE_VAL;
  kinks_.clear();
  iterations_before_ = report_.iterations;
  const SNESConvergedReason reason = solve();
  if (reason >= 0) return;
  using enum advice::StaticsEnds;
  throw_no_equilibrium(failure(reason != SNES_DIVERGED_MAX_IT ? no_descent
                               : stagnates_                   ? stagnation
                                                              : too_many_iterations));
}

void StaticSearch::begin_iteration(int iteration) {
  const bool others = prepare();  // pairs of lines that may touch change with the state
  system_.residual(state_.at_rest(), r_.get());
  if (others) report_.norms = system_.norms(r_.get());
  if (others || layout_ != kinks_layout_) kinks_.clear();
  kinks_layout_ = layout_;
  check(VecCopy(r_.get(), f_.get()));
  energy_ = potential(state_);
  report_.iterations = iterations_before_ + iteration;
  if (settings_.progress) settings_.progress(report_);
  least_residual_ = std::min(least_residual_, report_.norms.relative());
}

// Selects the tangent of the iteration, too.
SNESConvergedReason StaticSearch::test_convergence(int iteration) {
  begin_iteration(iteration);
  if (report_.norms.small(tolerance_)) return SNES_CONVERGED_FNORM_RELATIVE;
  if (!kinks_.empty()) {
    kinks_.evaluate(system_, state_, trial_);
    if (kinks_.norms(system_, f_.get()).small(tolerance_)) return SNES_CONVERGED_FNORM_RELATIVE;
  }
  if (iteration % kWatched == 0) {
    const Progress since = progress(report_.norms);
    slow_ = since.halved ? 0 : slow_ + kWatched;
    // A level of soft lines only gives the next one its start, and slides slowly to it on the facets of a
    // mesh.
    if (slow_ >= kSlow && tolerance_ > settings_.tolerance && is_round_off())
      return SNES_CONVERGED_FNORM_RELATIVE;
    // Relaxation, which follows, often moves a line that Newton's method hardly moves.
    stagnates_ = settings_.relaxation != RelaxationUse::never && since.stagnates && !is_round_off();
  }
  if (stagnates_ || iteration >= settings_.max_iterations) return SNES_DIVERGED_MAX_IT;
  const bool close = tangent_trusted(report_.norms);
  use_tangent(close ? TangentKind::exact : TangentKind::convex, close && shift_ < 1e-5 ? 0 : shift_);
  return SNES_CONVERGED_ITERATING;
}

PetscErrorCode StaticSearch::search(SNESLineSearch search, void* self) {
  auto& s = *static_cast<StaticSearch*>(self);
  return s.error_.capture([&] {
    Vec y = nullptr;
    PetscReal size = 0;
    check(SNESLineSearchGetVecs(search, nullptr, nullptr, &y, nullptr, nullptr));
    if (!s.advance(y)) return;
    check(VecNorm(s.r_.get(), NORM_2, &size));
    check(SNESLineSearchSetNorms(search, 0, size, 0));
  });
}

bool StaticSearch::advance(Vec y) {
  const bool close = exact_;
  const double slope = set_direction(y);
  const double largest = largest_factor();
  Descent descent = find_descent(slope, largest, close);
  search_for_kink(descent, slope, close);
  if (descent.accepted) accept_trial();
  if (descent.searched) residual();
  count_blocked(descent.blocked);
  if ((!descent.accepted && shift_ > kShiftAtEnd) || blocked_steps_ > kMaxBlocked)
    stop_search();
  else
    adapt_shift(descent, close || largest == 1);
  return descent.accepted;
}

double StaticSearch::set_direction(Vec y) {
  if (!kinks_.empty()) kinks_.combine(ksp_.get(), r_.get(), y);
  const double slope = downhill(y);
  return kinks_.empty() ? slope : std::max(slope, kinks_.slope(u_.get()));
}

StaticSearch::Descent StaticSearch::find_descent(double slope, double first, bool close) {
  Descent out;
  out.bracket = {0, slope, 0, 0};
  for (double factor = first; out.trials < kMaxTrials && !out.accepted; factor *= 0.5) {
    ++out.trials;
    out.factor = factor;
    move_trial(factor);
    if (!path_is_clear()) {
      out.blocked = true;
      continue;
    }
    const double e = potential(trial_);
    system_.residual(trial_.at_rest(), r_.get());
    const ResidualNorms n = system_.norms(r_.get());
    if (!std::isfinite(e) || !std::isfinite(n.force)) continue;
    const double trial_slope = slope_at_trial();
    out.bracket.narrow(factor, trial_slope, slope);
    // Forces without a potential may raise the energy near the solution. The residual must then be smaller
    // than any before, which prevents cycles.
    out.accepted = energy_falls(e, slope, trial_slope, factor) || (close && n.relative() < least_residual_) ||
                   n.small(tolerance_);
    if (out.accepted) report_.norms = n;
  }
  return out;
}

// If the difference of the energies is lost in rounding, the trapezoidal rule on their slopes at both ends of
// the step replaces it.
bool StaticSearch::energy_falls(double energy, double slope, double trial_slope, double factor) const {
  const bool flat = std::abs(energy - energy_) <= kRounding * std::abs(energy_);
  const double rise = flat ? 0.5 * factor * (slope + trial_slope) : energy - energy_;
  return slope < 0 && rise <= kArmijo * factor * slope;
}

void StaticSearch::Bracket::narrow(double factor, double trial_slope, double slope) {
  if (trial_slope > 0)
    *this = {0, slope, factor, trial_slope};
  else if (factor < beyond)
    *this = {factor, trial_slope, beyond, rises};
}

void StaticSearch::search_for_kink(Descent& descent, double slope, bool close) {
  descent.searched =
      close && slope < 0 && descent.bracket.rises > 0 && (!descent.accepted || descent.factor <= kShortened);
  if (!descent.searched) return;
  const bool kink = stop_at_kink(descent.bracket, slope);
  if (descent.accepted && !kink) move_trial(descent.factor);  // back to the trial before the search
  descent.accepted |= kink;
}

// If lines block step after step, they approach each other further, and the search cannot continue.
void StaticSearch::count_blocked(bool blocked) {
  if (!blocked) blocked_by_.reset();
  blocked_steps_ += blocked;
}

// A residual that very stiff lines cannot reduce.
bool StaticSearch::is_round_off() const { return report_.norms.small(100 * tolerance_); }

void StaticSearch::stop_search() {
  residual();
  check(SNESSetConvergedReason(snes_.get(),
                               is_round_off() ? SNES_CONVERGED_FNORM_RELATIVE : SNES_DIVERGED_LINE_SEARCH));
}

void StaticSearch::adapt_shift(const Descent& descent, bool trusted) {
  const bool at_once = descent.accepted && descent.trials == 1;
  const double factor = at_once && trusted ? 0.2 : at_once ? 1 : 4;
  shift_ = std::clamp(factor * shift_, kMinShift, kMaxShift);
  if (!descent.accepted) shift_ *= 10;
}

bool StaticSearch::stop_at_kink(Bracket bracket, double slope) {
  double far = 0;
  for (const double x : local_) far = std::max(far, std::abs(x));
  all_reduce(system_.comm(), MPI_MAX, far);
  const double width = std::min(1e-3 * bracket.beyond, kWidth * length_ / far);
  while (bracket.beyond - bracket.under > width) {
    const double middle = 0.5 * (bracket.under + bracket.beyond);
    move_trial(middle);
    system_.residual(trial_.at_rest(), r_.get());
    const double trial_slope = slope_at_trial();
    (trial_slope > 0 ? bracket.beyond : bracket.under) = middle;
    (trial_slope > 0 ? bracket.rises : bracket.falls) = trial_slope;
  }
  const bool kink = bracket.rises - bracket.falls > kJump * std::abs(slope);
  if (kink) {
    std::vector<double> from_state(local_);
    for (double& x : from_state) x *= bracket.beyond - bracket.under;
    kinks_.add(from_state, r_.get());
    move_trial(bracket.under);
  }
  return kink;
}

void StaticSearch::polish() {
  for (int i = 0; i < kMaxPolishing; ++i) {
    residual();
    use_tangent(TangentKind::exact, 0);
    newton(u_.get());
    downhill(u_.get());
    if (largest_factor() < 1) break;
    move_trial(1);
    if (!path_is_clear()) break;
    system_.residual(trial_.at_rest(), r_.get());
    // The residual is reduced below its round-off, too: for nearly inextensible lines the bound of the
    // round-off can be as large as the pull of an anchor.
    const auto size = [](ResidualNorms n) {
      n.round_off = 0;
      return n.relative();
    };
    if (!(size(system_.norms(r_.get())) < 0.5 * size(report_.norms))) break;
    accept_trial();
    ++report_.iterations;
  }
  residual();  // so that the reactions are those of the state
}

void StaticSearch::use_tangent(TangentKind kind, double shift) {
  exact_ = kind == TangentKind::exact;
  tangent_shift_ = shift;
  PetscInt unknowns = 0;
  check(VecGetSize(u_.get(), &unknowns));
  const double unit = report_.norms.force_scale / std::sqrt(static_cast<double>(unknowns)) / length_;
  weights_.shift_position = shift * unit;
  weights_.shift_rotation = shift * unit * length_ * length_;
  weights_.stabilisation = std::min(1.0, shift / kFirstShift);
}

void StaticSearch::newton(Vec y) {
  tangent();
  check(KSPSetOperators(ksp_.get(), J_.get(), J_.get()));
  check(KSPSolve(ksp_.get(), r_.get(), y));
}

double StaticSearch::downhill(Vec y) {
  PetscScalar rise = 0;
  check(VecDot(y, r_.get(), &rise));
  if (exact_ && !(rise > 0)) {
    use_tangent(TangentKind::convex, std::max(tangent_shift_, 1e-6));
    newton(y);
    check(VecDot(y, r_.get(), &rise));
  }
  check(VecCopy(y, u_.get()));
  check(VecScale(u_.get(), -1));
  system_.gather_with_ghosts(u_.get(), local_);
  return -rise;
}

double StaticSearch::slope_at_trial() const {
  PetscScalar slope = 0;
  check(VecDot(u_.get(), r_.get(), &slope));
  return slope;
}

double StaticSearch::distance_from(const State& from) const {
  double far = 0;
  for (size_t n = 0; n < static_cast<size_t>(system_.mesh().owned); ++n) {
    far = std::max(far, (state_.x[n] - from.x[n]).norm());
    if (system_.mesh().node(static_cast<int>(n)).body >= 0)
      far = std::max(far, state_.q[n].angularDistance(from.q[n]) * longest_);
  }
  return all_reduce(system_.comm(), MPI_MAX, far);
}

bool StaticSearch::relax_from_push() {
  const RelaxationReport r = relax(system_, *relaxation_, state_);
  report_.iterations += r.iterations;
  report_.relaxation_steps += r.steps;
  prepare_again();
  return r.steps > 0;
}

void StaticSearch::prepare_again() {
  build();
  local_ = zero_;
  trial_ = state_;
  prepare();
}

std::string StaticSearch::failure(advice::StaticsEnds how) const {
  return advice::no_equilibrium(how, settings_.max_iterations, imbalance(system_, r_.get(), report_.norms));
}

}  // namespace hawser
