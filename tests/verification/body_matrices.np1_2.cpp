// A body with full 6x6 matrices of mass, stiffness and damping: statics, periods and decays against the
// solution of the 6x6 system, and the energy balance on a support that moves.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <array>

#include "hawser/base/mpi.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/solve/natural_modes.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::body_matrices {
namespace {

using run::Simulation;

const Vec3 kCentre(0.3, -0.2, -0.4);  // m, of the mass
const Vec3 kPlace(5, -3, 2);
const Vec3 kTurn(0, 0, 30);  // deg

Mat3 axes() { return exp_so3(Vec3(kTurn * M_PI / 180)).toRotationMatrix(); }

// About the body's origin: not that of a rigid body, and with couplings of all freedoms.
Mat6 symmetric(const Vec6& diagonal, double coupling) {
  Mat6 m = diagonal.asDiagonal();
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < i; ++j)
      m(i, j) = m(j, i) = coupling * std::cos(1.0 + i + 2.0 * j) * std::sqrt(diagonal[i] * diagonal[j]);
  return m;
}
Mat6 mass() { return symmetric((Vec6() << 1500, 2600, 4000, 700, 900, 600).finished(), 0.15); }
Mat6 stiffness() { return symmetric((Vec6() << 3000, 5000, 9000, 4000, 6000, 2000).finished(), 0.12); }

std::string rows(const Mat6& m) {
  std::string out;
  for (int i = 0; i < 6; ++i)
    out += fmt::format("{}[{}, {}, {}, {}, {}, {}]", i > 0 ? ", " : "[", m(i, 0), m(i, 1), m(i, 2), m(i, 3),
                       m(i, 4), m(i, 5));
  return out + "]";
}
std::string list(const Vec3& v) { return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]); }

std::string body(const std::string& more, const std::string& motion = "") {
  return fmt::format(
      "hawser: 1\nbodies:\n  raft:\n    position: {}\n    rotation_deg: {}\n{}    floating:\n      mass: "
      "1000\n"
      "      centre_of_mass: {}\n      mass_matrix: {{rows: {}}}\n      stiffness_matrix: {}\n{}",
      list(kPlace), list(kTurn), motion, list(kCentre), rows(mass()), rows(stiffness()), more);
}

model::Case read(const std::string& text) {
  return io::read_case_text(text, testing::TempDir() + "raft.yaml");
}

// Displacement and rotation of the body's origin from rest, axes of the body at rest.
Vec6 displacement(const Vec3& x, const Quat& q) {
  Vec6 out;
  out << axes().transpose() * (x - q * kCentre - kPlace), log_so3(Quat(axes()).conjugate() * q);
  return out;
}

using Modes = Eigen::GeneralizedSelfAdjointEigenSolver<Mat6>;

TEST(BodyMatrices, Periods) {
  Simulation s(PETSC_COMM_WORLD, read(body("")));
  s.solve_statics();
  const std::vector<NaturalMode> modes = natural_modes(s.system(), s.state().at_rest(), 6);
  const Modes exact(stiffness(), mass());
  ASSERT_EQ(modes.size(), 6u);
  for (size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(modes[k].squared / exact.eigenvalues()[static_cast<int>(k)], 1, 1e-7) << k;
}

// C xi = F for small forces at the origin; the weight acts, since the springs carry it.
TEST(BodyMatrices, Statics) {
  const Vec3 force(3e-3, -2e-3, 5e-3);
  const Vec3 moment(1e-3, 2e-3, -1.5e-3);
  const auto rest = [&](const std::string& loads) {
    Simulation s(PETSC_COMM_WORLD, read(body(loads)));
    s.solve_statics();
    Vec6 out;
    for (int k = 0; k < 6; ++k)
      out[k] = from_owner(s, [&](size_t n) { return displacement(s.state().x[n], s.state().q[n])[k]; });
    return out;
  };
  Vec6 load;
  load << axes().transpose() * force, axes().transpose() * moment;
  const Vec6 exact = stiffness().ldlt().solve(load);
  const Vec6 found =
      rest(fmt::format("      loads: [{{force: {}, moment: {}}}]\n", list(force), list(moment)));
  EXPECT_LT((found - exact).norm(), 1e-5 * exact.norm());
  Vec6 weight = Vec6::Zero();
  weight.head<3>() = Vec3(0, 0, -1);
  weight.tail<3>() = kCentre.cross(Vec3(0, 0, -1));
  const Vec6 sag = stiffness().ldlt().solve(weight);
  const Vec6 sunk = rest("      weight: true\nenvironment: {gravity: 1e-6}\n");
  EXPECT_LT((sunk - 1e-3 * sag).norm(), 1e-5 * 1e-3 * sag.norm());
}

// Damping 2 a M: a motion in the mode phi of the velocity v is phi v exp(-a t) sin(w t)/w, w² = omega² - a².
TEST(BodyMatrices, Decays) {
  const Modes modes(stiffness(), mass());
  constexpr double kRate = 0.08;
  constexpr double kSpeed = 1e-6;
  for (const int k : {0, 3}) {
    const Vec6 shape = modes.eigenvectors().col(k) / modes.eigenvectors().col(k).norm();
    const double omega = std::sqrt(modes.eigenvalues()[k] - kRate * kRate);
    const double step = 2 * M_PI / omega / 400;
    const Vec3 spin = kSpeed * shape.tail<3>();
    const Vec3 velocity = axes() * (kSpeed * shape.head<3>() + spin.cross(kCentre));
    Simulation s(
        PETSC_COMM_WORLD,
        read(body(fmt::format("      damping_matrix: {}\n      velocity: {}\n      angular_velocity: {}\n"
                              "statics: false\ndynamics: {{duration: {}, step: {}, rho_infinity: 1}}\n",
                              rows(2 * kRate * mass()), list(velocity), list(spin), 1200 * step, step))));
    Dynamics& d = s.dynamics();
    d.start(s.state());
    const int node = s.local().find(s.mesh().body_node(0));
    const bool here = s.local().owns(node);
    const auto sum = [&] {
      const Energy e = s.system().energy(d.committed_kinematics());
      return e.kinetic + e.strain + e.damping - e.work;
    };
    const double first = sum();
    double off = 0, unbalanced = 0;
    integrate(d, 1200 * step, 1200 * step, [&](const StepInfo& i) {
      unbalanced = std::max(unbalanced, std::abs(sum() - first));
      if (!here) return;
      const Kinematics now = d.committed_kinematics();
      const size_t n = static_cast<size_t>(node);
      const Vec6 exact = kSpeed * shape * std::exp(-kRate * i.time) * std::sin(omega * i.time) / omega;
      off = std::max(off, (displacement(now.x[n], now.q[n]) - exact).norm() * omega / kSpeed);
    });
    std::vector<double> all = {off, here ? unbalanced / first : 0};
    all_reduce(PETSC_COMM_WORLD, MPI_MAX, all);
    printf("decay of mode %d: %.1e off, energy %.1e off\n", k, all[0], all[1]);
    // The period of the scheme is too long by (omega h)²/12 = 2e-5 of 19 rad.
    EXPECT_LT(all[0], 5e-4);
    EXPECT_LT(all[1], 1e-4);
  }
}

// Large motions on a support that moves and turns: the energy balance has an error of second order in the
// step.
TEST(BodyMatrices, MovingSupport) {
  std::vector<double> off;
  for (const double step : {0.02, 0.01}) {
    Simulation s(
        PETSC_COMM_WORLD,
        read(body(fmt::format("      damping_matrix: {}\nstatics: false\n"
                              "dynamics: {{duration: 8, step: {}, rho_infinity: 1}}\n",
                              rows(0.3 * stiffness()), step),
                  "    motion: {harmonic: {amplitude: [1, 0.5, 0.7], rotation_amplitude_deg: [20, -30, 40], "
                  "period: 5}}\n")));
    Dynamics& d = s.dynamics();
    d.start(s.state());
    const bool here = s.local().owns(s.local().find(s.mesh().body_node(0)));
    const auto sum = [&] {
      const Energy e = s.system().energy(d.committed_kinematics());
      return std::array{e.kinetic + e.strain + e.damping - e.work, std::abs(e.work), e.damping};
    };
    const double first = sum()[0];
    double worst = 0, work = 0;
    integrate(d, 8, 8, [&](const StepInfo&) {
      worst = std::max(worst, std::abs(sum()[0] - first));
      work = std::max(work, sum()[1]);
    });
    std::vector<double> all = {here ? worst : 0, here ? work : 0, here ? sum()[2] : 0};
    all_reduce(PETSC_COMM_WORLD, MPI_MAX, all);
    printf("moving support, steps of %g s: energy %.1e J off of %.4g J, dissipated %.4g J\n", step, all[0],
           all[1], all[2]);
    EXPECT_GT(all[2], 100);
    EXPECT_LT(all[0], 1e-3 * all[1]);
    off.push_back(all[0]);
  }
  EXPECT_NEAR(off[0] / off[1], 4, 1);
}

}  // namespace
}  // namespace hawser::test::body_matrices
