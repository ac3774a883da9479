// What multipliers do in a step (docs/theory/contact-models.md#in-motion): their forces act in it alone,
// evenly, and are not carried by the scheme, and what they hold at its end does not move on along the normal.
#include <fmt/format.h>

#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/solve/dynamics.hpp"

namespace hawser {

namespace {
constexpr int kStops = 3;  // each leaves a millionth of the speed: the stiffness of ForceTerm::stop
}  // namespace

// Of the masses in J_ under the forces -r_: minus the accelerations, with ghosts, to gathered_. Throws
// SolveError when the masses cannot be solved with.
void Dynamics::solve_masses() {
  KSP ksp = nullptr;
  check(SNESGetKSP(snes_, &ksp));
  check(KSPSetOperators(ksp, J_.get(), J_.get()));
  check(KSPSolve(ksp, r_.get(), u_.get()));
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  check(KSPGetConvergedReason(ksp, &reason));
  PetscReal size = 0;
  check(VecNorm(u_.get(), NORM_INFINITY, &size));
  if (reason < 0 || !std::isfinite(size))
    throw SolveError(
        fmt::format("at t = {:.6g} s forces give no accelerations: some part of a line has no mass (is a "
                    "rotary_inertia zero?)",
                    committed_.s.time));
  system_.gather(u_.get(), gathered_);
}

// The accelerations of the start are those of all forces; the scheme carries them without the multipliers'.
void Dynamics::start_held(double h) {
  committed_.hx.clear(), committed_.hw.clear();
  if (!system_.augments()) return;
  const State& s = committed_.s;
  const std::vector<double> zero(3 * static_cast<size_t>(system_.mesh().blocks()), 0);
  system_.residual(s.view(h), r_.get(), System::Part::multipliers);
  system_.tangent(s.view(h), {0, 0, 1}, zero, false, J_.get());
  solve_masses();
  for (double& c : gathered_) c = -c;
  alpha_start_held(system_.mesh(), gathered_, committed_);
}

// As in the step before; where nothing moves that is what it will be.
void Dynamics::expect_held() {
  held_v_.clear(), held_w_.clear();
  if (!system_.augments()) return;
  held_v_ = committed_.hx, held_w_ = committed_.hw;
  held_v_.resize(committed_.s.x.size(), Vec3::Zero()), held_w_.resize(committed_.s.x.size(), Vec3::Zero());
  const double of_c = alpha_held_speed(alpha_, h_);
  for (Vec3& v : held_v_) v *= of_c;
  for (Vec3& w : held_w_) w *= of_c;
}

void Dynamics::add_held(double sign) {
  State& s = trial_.s;
  for (size_t n = 0; n < held_v_.size(); ++n) {
    s.v[n] += sign * held_v_[n];
    if (system_.mesh().rotates(static_cast<int>(n))) s.w[n] += sign * held_w_[n];
  }
}

// Ends a try whose multipliers have settled. True: with the speeds that it ends with the forces are not those
// that were solved with, and it is to be solved again with these. What dampers feel of a node that lies still
// would else be a speed that it does not have.
bool Dynamics::let_go() {
  if (!system_.augments()) return false;
  add_held(-1);
  State& s = trial_.s;
  s.hold_weight = 1;
  const std::vector<Vec3> v = s.v, w = s.w;
  const std::vector<double> zero(3 * static_cast<size_t>(system_.mesh().blocks()), 0);
  const Weights masses{0, 0, 1};
  system_.residual(s.view(h_), r_.get(), System::Part::multipliers);
  PetscReal size = 0;
  check(VecNorm(r_.get(), NORM_INFINITY, &size));
  trial_.hx.clear(), trial_.hw.clear();
  if (size > 0) {
    system_.tangent(s.view(h_), masses, zero, false, J_.get());
    solve_masses();
    for (double& c : gathered_) c = -c;
    alpha_hold(system_.mesh(), alpha_, h_, gathered_, trial_);
    system_.tangent(s.view(h_), masses, zero, false, J_.get(), true);
    for (int i = 0; i < kStops; ++i) {
      system_.residual(s.view(h_), r_.get(), System::Part::stops);
      solve_masses();
      for (size_t n = 0; n < s.x.size(); ++n) {
        const double* p = gathered_.data() + 3 * system_.mesh().block[n];
        s.v[n] -= Eigen::Map<const Vec3>(p);
        if (system_.mesh().rotates(static_cast<int>(n))) s.w[n] -= Eigen::Map<const Vec3>(p + 3);
      }
    }
    loaded_ = false;
  }
  for (size_t n = 0; n < v.size(); ++n) held_v_[n] = s.v[n] - v[n], held_w_[n] = s.w[n] - w[n];
  system_.residual(s.view(h_), r_.get(), carried_);  // the reactions
  if (system_.norms(r_.get()).small(settings_.tolerance)) return false;
  put(local_u_);
  return true;
}

}  // namespace hawser
