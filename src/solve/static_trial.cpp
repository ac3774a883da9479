// The class StaticTrial: the linear system of a static step, limits of its length, the test that no line
// passes through another, and the push away from an unstable equilibrium.
#include "hawser/solve/static_trial.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/advice/statics.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/terms/line_candidates.hpp"

namespace hawser {
namespace {
constexpr double kBodies = 20;  // m, replaces the length of lines in limits if there are none
constexpr double kNear = 1e-2;  // residual over its scale below which the exact tangent is tried
constexpr int kMaxHalvings = 30;
// A search stagnates if kWatched steps move no node by kStagnation times its line (a body: the longest line)
// and do not halve the imbalance. A slack line in a heap, or a line on the facets of a mesh, would move
// slowly without reaching the tolerance.
constexpr double kStagnation = 1e-4;
}  // namespace

StaticTrial::StaticTrial(System& system, State& state) : system_(system), state_(state), trial_(state) {
  length_ = std::max(length_, system.mesh().mesh->longest_element());
  for (const LineSpan& l : system.mesh().mesh->lines) longest_ = std::max(longest_, l.length);
  if (length_ == 0) length_ = 0.05 * kBodies;
  if (longest_ == 0) longest_ = kBodies;
  check(SNESCreate(system.comm(), snes_.out()));
  check(SNESSetOptionsPrefix(snes_.get(), "statics_"));
  build();
  check(VecDuplicate(u_.get(), x_.out()));
  check(VecDuplicate(u_.get(), f_.out()));
  check(SNESSetFunction(
      snes_.get(), f_.get(),
      [](SNES, Vec x, Vec f, void* self) {
        auto& s = *static_cast<StaticTrial*>(self);
        return s.error_.capture([&] {
          check(VecCopy(x, s.u_.get()));
          s.system_.gather_with_ghosts(s.u_.get(), s.local_);
          s.residual();
          check(VecCopy(s.r_.get(), f));
        });
      },
      this));
  check(SNESSetConvergenceTest(
      snes_.get(),
      [](SNES, PetscInt it, PetscReal, PetscReal, PetscReal, SNESConvergedReason* reason, void* self) {
        auto& s = *static_cast<StaticTrial*>(self);
        return s.error_.capture([&] { *reason = s.test_convergence(static_cast<int>(it)); });
      },
      this, nullptr));
  check(SNESSetFromOptions(snes_.get()));
  check(SNESSetType(snes_.get(), SNESNEWTONLS));
  SNESLineSearch search = nullptr;
  check(SNESGetLineSearch(snes_.get(), &search));
  check(SNESLineSearchSetType(search, SNESLINESEARCHBASIC));
  local_ = zero_;
  prepare();
}

SNESConvergedReason StaticTrial::solve() {
  check(VecZeroEntries(x_.get()));
  error_.check(SNESSolve(snes_.get(), nullptr, x_.get()));
  SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
  check(SNESGetConvergedReason(snes_.get(), &reason));
  return reason;
}

void StaticTrial::build() {
  ++layout_;
  u_ = system_.create_vector();
  check(VecDuplicate(u_.get(), r_.out()));
  J_ = system_.create_matrix();
  check(SNESSetJacobian(
      snes_.get(), J_.get(), J_.get(),
      [](SNES, Vec, Mat, Mat, void* self) {
        auto& s = *static_cast<StaticTrial*>(self);
        return s.error_.capture([&] { s.tangent(); });
      },
      this));
  check(KSPCreate(system_.comm(), ksp_.out()));
  configure_linear_solver(ksp_.get(), system_, "statics_");
  check(SNESSetKSP(snes_.get(), ksp_.get()));
  zero_.assign(3 * static_cast<size_t>(system_.mesh().blocks()), 0);
}

bool StaticTrial::prepare() {
  const CouplingChange c = system_.update_couplings(state_.at_rest(), 0);
  if (c == CouplingChange::layout_changed) {
    build();
    system_.update_ghosts(state_);
    trial_ = state_;
  }
  system_.prepare(state_.at_rest(), 0);
  return c != CouplingChange::unchanged;
}

double StaticTrial::sum_of_ranks(double x) const {
  all_reduce(system_.comm(), MPI_SUM, x);
  return x;
}

double StaticTrial::potential(const State& s) const {
  const Energy e = system_.energy(s.at_rest());
  return sum_of_ranks(e.strain + e.potential);
}

// The residual is compared with dead loads, not with internal forces: a straight compressed line that is
// longer than its span is in balance except for its weight.
bool StaticTrial::tangent_trusted(const ResidualNorms& n) const {
  const double load = system_.dead_load() / std::sqrt(static_cast<double>(system_.mesh().mesh->nodes()));
  return load > 0 ? n.force < kNear * load && n.moment < kNear * std::max(n.moment_scale, load * length_)
                  : n.relative() < kNear;
}

double StaticTrial::relative_size() const {
  double x = 0, turn = 0;
  const LocalMesh& m = system_.mesh();
  for (int n = 0; n < m.owned; ++n) {
    const double* p = local_.data() + 3 * m.block[n];
    x = std::max(x, Eigen::Map<const Vec3>(p).norm());
    if (m.rotates(n)) turn = std::max(turn, Eigen::Map<const Vec3>(p + 3).norm());
  }
  double largest = std::max(x / (0.05 * longest_), turn / 0.5);
  all_reduce(system_.comm(), MPI_MAX, largest);
  return largest;
}

void StaticTrial::move_trial(double factor) {
  std::vector<double> u(local_);
  for (double& x : u) x *= factor;
  retract(system_.mesh(), state_, u.data(), trial_);
  system_.tied_nodes().move_with_frames(trial_);
}

bool StaticTrial::path_is_clear() {
  const auto passes = [this](const Verdict& v) {
    if (!v.accepted()) {
      blocked_by_ = v.because;
      blocked_ = trial_;
    }
    return v.accepted();
  };
  const Verdict verdict = system_.check_step(trial_.at_rest());
  if (verdict.kind != Verdict::Kind::prepare_again) return passes(verdict);
  const LocalMesh& m = system_.mesh();
  // The velocities of this path lead to the trial in 1 s. Lists of candidates predict several steps; of this
  // length these take 1 s, so that the lists cover the path.
  const double h = 1 / CandidateSettings{}.steps;
  if (system_.update_couplings(straight_path(m, state_, trial_, 1).at_rest(), h) ==
      CouplingChange::layout_changed) {
    // build() creates u_ again; the increment is transferred to the new layout.
    std::vector<double> u(local_.begin(), local_.begin() + 3 * m.owned_blocks);
    build();
    system_.update_ghosts(state_);
    system_.update_ghosts(trial_);
    if (!u.empty()) {
      PetscScalar* p = nullptr;
      check(VecGetArray(u_.get(), &p));
      std::copy(u.begin(), u.end(), p);
      check(VecRestoreArray(u_.get(), &p));
    }
    system_.gather_with_ghosts(u_.get(), local_);
  }
  system_.prepare(state_.at_rest(), 0);
  return passes(system_.check_step(trial_.at_rest()));
}

void StaticTrial::throw_no_equilibrium(const std::string& why) {
  if (!blocked_by_) throw SolveError(why);
  system_.update_ghosts(blocked_);
  if (system_.raise_stiffness_where_blocked(blocked_.at_rest())) throw StiffnessRaised();
  throw PathBlocked(advice::path_blocked(first_text(system_.comm(), advice::clause(*blocked_by_))));
}

StaticTrial::Progress StaticTrial::progress(const ResidualNorms& now) {
  const LocalMesh& mesh = system_.mesh();
  double far = 0;  // of the length
  for (size_t n = 0; n < last_places_.size(); ++n) {
    const Node& node = mesh.node(static_cast<int>(n));
    const double length = node.body < 0 ? mesh.mesh->lines[node.line].length : longest_;
    far = std::max(far, (state_.x[n] - last_places_[n]).norm() / length);
  }
  all_reduce(system_.comm(), MPI_MAX, far);
  const bool halved = now.relative() <= 0.5 * last_imbalance_;
  last_places_.assign(state_.x.begin(), state_.x.begin() + mesh.owned);
  last_imbalance_ = now.relative();
  return {halved, !halved && far < kStagnation};
}

void StaticTrial::push_state(int attempt) {
  double fraction = 1;
  for (int k = 0; k < kMaxHalvings; ++k, fraction *= 0.5) {
    trial_ = state_;
    displace(attempt, fraction, trial_);
    if (!path_is_clear()) continue;
    accept_trial();
    return;
  }
}

void StaticTrial::displace(int attempt, double fraction, State& s) const {
  const LocalMesh& m = system_.mesh();
  for (int n = 0; n < m.nodes(); ++n) {
    const size_t i = n;
    const Node& node = m.node(i);
    if (node.body >= 0) continue;
    const double L = m.mesh->lines[node.line].length;
    const double z = node.arc / L;
    const double bump =
        fraction * 0.01 * attempt * L * std::sin(M_PI * z) * (1 + 0.3 * std::sin(9 * z + attempt));
    Vec3 d = bump * Vec3(0.31, 0.52, -0.79);
    const unsigned char held = system_.tied_nodes().held()[m.block[i]];
    for (int c = 0; c < 3; ++c)
      if (held >> c & 1) d[c] = 0;
    s.x[i] += d;
    // A node that is turned by half a turn against its neighbours is a saddle point of rotations, so
    // rotations are perturbed as well.
    const size_t b = m.block[i];
    if (!m.rotates(n) || system_.tied_nodes().held()[b + 1]) continue;
    const double angle = fraction * 0.05 * attempt;
    s.q[i] = s.q[i] * exp_so3(angle * Vec3(0.1 * std::sin(5 * z), std::sin(37 * z + 1), std::cos(41 * z)));
  }
}

}  // namespace hawser
