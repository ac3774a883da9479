// The part of the class Dynamics that goes on after a feeder has let go of a node or taken hold of one.
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/solve/dynamics.hpp"

namespace hawser {
namespace {

constexpr int kMostSettling = 8;   // iterations
constexpr double kFarthest = 0.1;  // m that a node may settle by in one; where a line is slack it stays

}  // namespace

void Dynamics::hand_over(const std::function<std::optional<Moved>()>& change,
                         const std::function<std::vector<Support>()>& supports) {
  const auto forces = [this] {
    State s = committed_.s;
    s.mean = {};
    system_.residual(s.view(last_step_), r_.get());
  };
  forces();
  const std::vector<double> mean = system_.mean_forces(), all = system_.reactions();
  const std::optional<Moved> moved = change();
  const LocalMesh& m = system_.mesh();
  int settles = -1;
  if (const int n = moved ? m.find(moved->node) : -1; n >= 0) {
    const size_t i = static_cast<size_t>(n);
    State& s = committed_.s;
    s.x[i] = moved->x, s.v[i] = moved->v, s.a[i] = committed_.ax[i] = moved->a;
    if (moved->free) settles = moved->node;
  }
  MPI_Allreduce(MPI_IN_PLACE, &settles, 1, MPI_INT, MPI_MAX, system_.comm());
  system_.spread(committed_.s);
  system_.spread(committed_.ax);
  system_.support(supports(), BodyMotion(system_.supports().motion()));
  if (settles >= 0) settle(settles);
  forces();
  const auto add = [](std::vector<double>& to, const std::vector<double>& now,
                      const std::vector<double>& before) {
    for (size_t i = 0; i < to.size(); ++i) to[i] += now[i] - before[i];
  };
  add(mean_.q, system_.mean_forces(), mean), add(mean_.f, system_.mean_forces(), mean);
  add(reactions_, system_.reactions(), all);
  copied_ = loaded_ = false, expected_ = -1;
}

// Newton's method for its position alone: the sag of the element that it divides, and the part of the tension
// that is its own weight's.
void Dynamics::settle(int node) {
  const LocalMesh& m = system_.mesh();
  const int n = m.find(node);
  const bool own = n >= 0 && n < m.owned;
  const std::vector<double> zero(3 * static_cast<size_t>(m.blocks()), 0);
  for (int i = 0; i < kMostSettling; ++i) {
    State s = committed_.s;
    s.mean = {};
    system_.residual(s.view(last_step_), r_.get());
    system_.tangent(s.view(last_step_), {1, 0, 0}, zero, false, J_.get());
    double going = 0;
    if (own) {
      const int block = m.block[static_cast<size_t>(n)];
      const PetscInt first = 3 * m.global_block[static_cast<size_t>(block)];
      const PetscInt rows[3] = {first, first + 1, first + 2};
      PetscScalar k[9];
      check(MatGetValues(J_.get(), 3, rows, 3, rows, k));
      const PetscScalar* r = nullptr;
      check(VecGetArrayRead(r_.get(), &r));
      const Vec3 force(r[3 * block], r[3 * block + 1], r[3 * block + 2]);
      check(VecRestoreArrayRead(r_.get(), &r));
      const Mat3 K = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(k);
      const Vec3 step = -K.inverse() * force;
      if (step.allFinite() && step.norm() < kFarthest)
        committed_.s.x[static_cast<size_t>(n)] += step, going = step.norm();
    }
    MPI_Allreduce(MPI_IN_PLACE, &going, 1, MPI_DOUBLE, MPI_MAX, system_.comm());
    system_.spread(committed_.s);
    if (going < 1e-12) break;
  }
}

}  // namespace hawser
