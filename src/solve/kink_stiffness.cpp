// The class KinkStiffness: corrections of rank one by node, and when the iteration ends.
#include "hawser/solve/kink_stiffness.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

// The iteration stagnates if kStale iterations in a row have not halved the least residual.
constexpr int kStale = 2;
constexpr double kAlmost = 1e-2;  // relative residual above which the state is far from equilibrium
// The iteration cycles if it repeats its last relative residuals, kLongestCycle of them at most, within
// kEqual of their size.
constexpr double kEqual = 1e-3;
constexpr int kLongestCycle = 3;
// cos of the angle between r and d below which their product is rounding.
constexpr double kRounding = 1e-8;
constexpr double kWithin = 1e-7;  // of the longest element: distance from a kink at which a node lies on it

}  // namespace

void KinkStiffness::clear(int patience) {
  blocks_.clear();
  last_.clear();
  residuals_.clear();
  patience_ = patience;
  stale_ = smooth_ = 0;
  active_ = false;
}

int KinkStiffness::cycle() const {
  const auto repeats = [](double now, double before) { return std::abs(now - before) <= kEqual * before; };
  const auto last = residuals_.rbegin();
  for (int length = 2; length <= kLongestCycle; ++length)
    if (residuals_.rend() - last >= 2 * length && std::equal(last, last + length, last + length, repeats))
      return length;
  return 0;
}

bool KinkStiffness::observe(const double* u, Vec r, double relative) {
  PetscInt size = 0;
  check(VecGetLocalSize(r, &size));
  const std::vector<double> before(std::move(last_));
  last_.assign(u, u + size);
  const auto halves = [relative](double earlier) { return relative <= 0.5 * earlier; };
  stale_ = std::all_of(residuals_.begin(), residuals_.end(), halves) ? 0 : stale_ + 1;
  residuals_.push_back(relative);
  if (!active_) {
    const int iterations = static_cast<int>(residuals_.size());
    const int length = cycle();
    const bool stagnates = iterations > patience_ && stale_ >= kStale;
    active_ = relative < kAlmost && (length > 0 || stagnates);
    smooth_ = std::max(iterations - (length > 0 ? 2 * length : kStale), 1);
  }
  if (!active_) return false;
  blocks_.resize(static_cast<size_t>(size) / 3);
  const PetscScalar* p = nullptr;
  check(VecGetArrayRead(r, &p));
  for (size_t b = 0; b < blocks_.size(); ++b) {
    Block& k = blocks_[b];
    const Eigen::Map<const Vec3> now(last_.data() + 3 * b);
    const Eigen::Map<const Vec3> then(before.data() + 3 * b);
    const Eigen::Map<const Vec3> residual(p + 3 * b);
    const Vec3 d = now - then;
    k.distance += d.norm();
    const double rise = residual.dot(d);
    if (!(rise > kRounding * residual.norm() * d.norm())) continue;
    k.S += residual * residual.transpose() / rise;
    k.jump = k.S * d;
    k.distance = d.norm();
    ++k.rises;
  }
  check(VecRestoreArrayRead(r, &p));
  return true;
}

void KinkStiffness::add_to(const System& system, Mat J) const {
  if (!active_) return;
  for (size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].rises == 0) continue;
    const PetscInt row = system.mesh().global_block[b];
    check(MatSetValuesBlocked(J, 1, &row, 1, &row, blocks_[b].S.data(), ADD_VALUES));
  }
  check(MatAssemblyBegin(J, MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(J, MAT_FINAL_ASSEMBLY));
}

ResidualNorms KinkStiffness::norms_without_jumps(const System& system, Vec r, double length) const {
  const double within = kWithin * length;
  VecHandle without_jumps;
  check(VecDuplicate(r, without_jumps.out()));
  check(VecCopy(r, without_jumps.get()));
  PetscScalar* p = nullptr;
  check(VecGetArray(without_jumps.get(), &p));
  for (size_t b = 0; b < blocks_.size(); ++b) {
    const Block& k = blocks_[b];
    if (k.rises < 2 || k.distance > within) continue;
    Eigen::Map<Vec3> residual(p + 3 * b);
    residual -= std::clamp(residual.dot(k.jump) / k.jump.squaredNorm(), 0.0, 1.0) * k.jump;
  }
  check(VecRestoreArray(without_jumps.get(), &p));
  return system.norms(without_jumps.get());
}

}  // namespace hawser
