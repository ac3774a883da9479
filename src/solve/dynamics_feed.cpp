// The class Dynamics: continuation of the motion after a feeder has released or absorbed a node.
#include <Eigen/LU>

#include "hawser/base/mpi.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/solve/dynamics.hpp"

namespace hawser {
namespace {

constexpr int kMaxBalanceIterations = 8;  // Most Newton iterations in balance_node().
// m and rad: a larger correction of the node in balance_node() is not applied; it occurs where the line is
// slack.
constexpr double kFarthest = 0.1;

}  // namespace

void Dynamics::transfer_node(FunctionRef<std::optional<Moved>()> change,
                             FunctionRef<std::vector<TiedNode>()> nodes) {
  const auto forces = [this] {
    State s = committed_.s;
    s.mean = {};
    system_.residual(step_origin(s, control_.proposal()), r_.get());
  };
  prepare(control_.proposal());  // for the committed state, which has not changed
  forces();
  std::vector<double> mean = system_.mean_forces();
  std::vector<double> all = system_.reactions();
  const std::optional<Moved> moved = change();
  const LocalMesh& m = system_.mesh();
  int node_to_balance = -1;
  if (const int n = moved ? m.find(moved->node) : -1; n >= 0) {
    const size_t i = static_cast<size_t>(n);
    State& s = committed_.s;
    s.x[i] = moved->x;
    s.v[i] = moved->v;
    s.a[i] = committed_.ax[i] = moved->a;
    if (m.rotates(n)) {
      s.q[i] = moved->q;
      s.w[i] = moved->w;
      s.alpha[i] = committed_.aw[i] = moved->alpha;
      s.directors[i] = committed_.ad[i] = director_acceleration(moved->q, moved->w, moved->alpha);
    }
    if (moved->free) node_to_balance = moved->node;
  }
  all_reduce(system_.comm(), MPI_MAX, node_to_balance);
  system_.update_ghosts(committed_.s);
  system_.update_ghosts(committed_.ax);
  if (has_directors(m)) {
    system_.update_ghosts(committed_.aw);
    system_.update_ghosts(committed_.ad);
  }
  system_.tie(nodes(), BodyMotion(system_.tied_nodes().motion()));
  prepare(control_.proposal());  // The feed point is at another element, which can touch other bodies.
  mean.resize(mean_.q.size(), 0);
  all.resize(reactions_.size(), 0);
  if (node_to_balance >= 0) balance_node(node_to_balance);
  forces();
  const auto add = [](std::vector<double>& to, const std::vector<double>& now,
                      const std::vector<double>& before) {
    for (size_t i = 0; i < to.size(); ++i) to[i] += now[i] - before[i];
  };
  add(mean_.q, system_.mean_forces(), mean);
  add(mean_.f, system_.mean_forces(), mean);
  add(reactions_, system_.reactions(), all);
  copied_ = trial_current_ = false;
  round_off_step_ = -1;
}

// Finds the position (and rotation) at which the forces on this node alone are in balance, by Newton's
// method. This accounts for the sag of the element that the node divides and for the part of the tension that
// the element's own weight causes.
void Dynamics::balance_node(int node) {
  const LocalMesh& m = system_.mesh();
  const int n = m.find(node);
  const bool owned = n >= 0 && n < m.owned;
  const std::vector<double> zero(3 * static_cast<size_t>(m.blocks()), 0);
  for (int i = 0; i < kMaxBalanceIterations; ++i) {
    State s = committed_.s;
    s.mean = {};
    const Kinematics at = step_origin(s, control_.proposal());
    system_.residual(at, r_.get());
    system_.tangent(at, {1, 0, 0}, zero, false, J_.get());
    double change = 0;
    if (owned) {
      const int block = m.block[static_cast<size_t>(n)];
      const int size = m.rotates(n) ? 6 : 3;
      PetscInt rows[6];
      for (int k = 0; k < size; ++k) rows[k] = 3 * m.global_block[static_cast<size_t>(block + k / 3)] + k % 3;
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, 6, 6> K(size, size);
      check(MatGetValues(J_.get(), size, rows, size, rows, K.data()));
      const PetscScalar* r = nullptr;
      check(VecGetArrayRead(r_.get(), &r));
      const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1> force =
          Eigen::Map<const Eigen::VectorXd>(r + 3 * block, size);
      check(VecRestoreArrayRead(r_.get(), &r));
      const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1> step = -K.partialPivLu().solve(force);
      if (step.allFinite() && step.norm() < kFarthest) {
        committed_.s.x[static_cast<size_t>(n)] += step.head<3>();
        change = step.norm();
        Quat& q = committed_.s.q[static_cast<size_t>(n)];
        if (size == 6) q = (q * exp_so3(step.tail<3>())).normalized();
      }
    }
    all_reduce(system_.comm(), MPI_MAX, change);
    system_.update_ghosts(committed_.s);
    if (change < 1e-12) break;
  }
}

}  // namespace hawser
