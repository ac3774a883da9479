// Two bodies coupled by a full matrix of mass and damping: their motion on any number of ranks against an
// integration by Runge and Kutta.
#include <gtest/gtest.h>

#include "hawser/base/mpi.hpp"
#include "hawser/kernels/rigid_body.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::coupled_bodies {
namespace {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12, Eigen::RowMajor>;

// Positive definite; no entry is 0.
Mat12 made_up(double scale, int seed) {
  Mat12 G;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) G(i, j) = std::sin(1.7 * i + 2.3 * j * j + seed) + (i == j);
  return scale * G * G.transpose();
}

// The force A a + B v on the rates of both bodies, (v_1, w_1, v_2, w_2).
class Joined final : public ForceTerm, public CouplesFixedNodes {
 public:
  Joined(const LocalMesh& mesh, const Mat12& A, const Mat12& B) : mesh_(mesh), A_(A), B_(B) {}
  std::string_view checkpoint_key() const override { return "joined"; }
  void list_couplings(Couplings& to) const override { to.add({0, 0}, {1, 1}); }
  void evaluate(const Kinematics& trial, Assembler& assembler) override {
    Vec12 a, v;
    std::array<int, 4> blocks{};
    for (const int body : {0, 1}) {
      const int n = mesh_.find(body);
      if (n < 0) return;
      a.segment<6>(6 * body) << trial.a[n], trial.alpha[n];
      v.segment<6>(6 * body) << trial.v[n], trial.w[n];
      blocks[2 * body] = mesh_.block[n];
      blocks[2 * body + 1] = mesh_.block[n] + 1;
    }
    const Vec12 f = A_ * a + B_ * v;
    for (const int body : {0, 1})
      assembler.add(std::span(blocks).subspan(2 * body, 2), blocks, f.segment<6>(6 * body), {},
                    B_.middleRows<6>(6 * body), A_.middleRows<6>(6 * body));
  }

 private:
  const LocalMesh& mesh_;
  Mat12 A_, B_;
};

Vec12 rates(const run::Simulation& s, const Kinematics& state) {
  std::vector<double> all(12, 0);
  for (const int body : {0, 1})
    if (const int n = s.local().find(body); s.local().owns(n))
      for (int k = 0; k < 3; ++k) {
        all[6 * body + k] = state.v[n][k];
        all[6 * body + 3 + k] = state.w[n][k];
      }
  all_reduce(PETSC_COMM_WORLD, MPI_SUM, all);
  return Eigen::Map<const Vec12>(all.data());
}

// The motion is so slow that gyroscopic moments are negligible: (M + A) y' = -B y, integrated by Runge and
// Kutta.
TEST(CoupledBodies, AFullMatrixOfMassAndDamping) {
  model::Case c;
  for (const char* name : {"one", "other"}) {
    model::Body& b = c.bodies.emplace_back();
    b.name = name;
    b.position = {name[0] == 't' ? 9.0 : 0.0, 0, 0};
    model::BodyMass& m = b.mass.emplace();
    m.mass = 8;
    m.inertia = {3, 5, 4};
    m.weight = false;
  }
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.duration = 1;
  c.dynamics.step = 0.01;
  c.dynamics.rho_infinity = 1;
  const Mat12 A = made_up(0.3, 1);
  const Mat12 B = made_up(5, 2);
  run::Simulation s(PETSC_COMM_WORLD, c);
  s.system().add(std::make_unique<Joined>(s.local(), A, B));
  Vec12 y;
  for (int i = 0; i < 12; ++i) y[i] = 1e-5 * std::cos(1.0 + 3 * i);
  const Vec12 start = y;
  for (const int body : {0, 1})
    if (const int n = s.local().find(body); n >= 0) {
      s.state().v[n] = y.segment<3>(6 * body);
      s.state().w[n] = y.segment<3>(6 * body + 3);
    }
  Dynamics& d = s.dynamics();
  d.start(s.state());
  int most = 0;
  integrate(d, 1, 1, [&](const StepInfo& i) { most = std::max(most, i.iterations); });
  Mat12 M = A;
  for (const int body : {0, 1}) M.diagonal().segment<6>(6 * body) += (Vec6() << 8, 8, 8, 3, 5, 4).finished();
  const Mat12 decay = -M.inverse() * B;
  constexpr double h = 1e-3;
  for (int n = 0; n < 1000; ++n) {
    const Vec12 k1 = decay * y;
    const Vec12 k2 = decay * (y + h / 2 * k1);
    const Vec12 k3 = decay * (y + h / 2 * k2);
    const Vec12 k4 = decay * (y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const Vec12 found = rates(s, d.committed_kinematics());
  printf("rates of two joined bodies: %.2e of %.2e at the start, error %.1e, at most %d iterations\n",
         y.norm(), start.norm(), (found - y).norm(), most);
  EXPECT_LT((found - y).norm(), 1e-4 * start.norm());
  EXPECT_LT(y.norm(), 0.7 * start.norm());
  EXPECT_LE(most, 2);  // the equations are nearly linear: the tangent contains both matrices in full
}

}  // namespace
}  // namespace hawser::test::coupled_bodies
