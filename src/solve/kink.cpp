// The class KinkSides: residuals on the sides of a kink, and their combination that descends along it.
#include "hawser/solve/kink.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

constexpr size_t kMaxSides = 4;

double dot(Vec a, Vec b) {
  PetscScalar x = 0;
  check(VecDot(a, b, &x));
  return x;
}

// G_ij = a_i'b_j, made symmetric.
Eigen::MatrixXd products(const std::vector<Vec>& a, const std::vector<Vec>& b) {
  const auto n = static_cast<Eigen::Index>(a.size());
  Eigen::MatrixXd G(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) G(i, j) = dot(a[i], b[j]);
  return 0.5 * (G + G.transpose());
}

}  // namespace

Eigen::VectorXd smallest_combination(const Eigen::MatrixXd& G) {
  const auto n = G.rows();
  const double unit = std::max(G.diagonal().maxCoeff(), 1e-300);
  Eigen::VectorXd best = Eigen::VectorXd::Unit(n, 0);
  double smallest = G(0, 0);
  for (unsigned set = 1; set < 1U << n; ++set) {
    std::vector<Eigen::Index> members;
    for (Eigen::Index i = 0; i < n; ++i)
      if (set >> i & 1) members.push_back(i);
    // G l + mu = 0, sum l = 1 for the members of the set.
    const auto m = static_cast<Eigen::Index>(members.size());
    Eigen::MatrixXd A = Eigen::MatrixXd::Ones(m + 1, m + 1);
    A.topLeftCorner(m, m) = G(members, members) / unit;
    A(m, m) = 0;
    const Eigen::VectorXd x = A.fullPivLu().solve(Eigen::VectorXd::Unit(m + 1, m));
    if (!x.allFinite() || x.head(m).minCoeff() < 0 || std::abs(x.head(m).sum() - 1) > 1e-9) continue;
    Eigen::VectorXd l = Eigen::VectorXd::Zero(n);
    l(members) = x.head(m);
    const double value = l.dot(G * l);
    if (value >= smallest) continue;
    smallest = value;
    best = l;
  }
  return best;
}

void KinkSides::add(const std::vector<double>& from_state, Vec like) {
  if (sides_.size() == kMaxSides) sides_.erase(sides_.begin());
  sides_.push_back({from_state, {}});
  check(VecDuplicate(like, sides_.back().r.out()));
}

void KinkSides::evaluate(System& system, const State& state, State& trial) {
  for (Side& side : sides_) {
    retract(system.mesh(), state, side.from_state.data(), trial);
    system.tied_nodes().move_with_frames(trial);
    system.residual(trial.at_rest(), side.r.get());
  }
}

ResidualNorms KinkSides::norms(const System& system, Vec r) const {
  std::vector<Vec> all{r};
  for (const Side& side : sides_) all.push_back(side.r.get());
  const Eigen::VectorXd l = smallest_combination(products(all, all));
  VecHandle sum;
  check(VecDuplicate(r, sum.out()));
  check(VecZeroEntries(sum.get()));
  check(VecMAXPY(sum.get(), static_cast<PetscInt>(all.size()), l.data(), all.data()));
  return system.norms(sum.get());
}

void KinkSides::combine(KSP solver, Vec r, Vec y) const {
  std::vector<Vec> all{r};
  std::vector<Vec> solutions{y};
  std::vector<VecHandle> owned(sides_.size());
  for (size_t i = 0; i < sides_.size(); ++i) {
    all.push_back(sides_[i].r.get());
    check(VecDuplicate(y, owned[i].out()));
    check(KSPSolve(solver, all.back(), owned[i].get()));
    solutions.push_back(owned[i].get());
  }
  const Eigen::VectorXd l = smallest_combination(products(all, solutions));
  check(VecScale(y, l[0]));
  check(VecMAXPY(y, static_cast<PetscInt>(owned.size()), l.data() + 1, solutions.data() + 1));
}

double KinkSides::slope(Vec u) const {
  double largest = -HUGE_VAL;
  for (const Side& side : sides_) largest = std::max(largest, dot(side.r.get(), u));
  return largest;
}

}  // namespace hawser
