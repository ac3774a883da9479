// Platforms by hydrodynamic coefficients: heave decay of a hemisphere, radiation coupling of two bodies,
// equilibrium under load, natural modes.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "hawser/io/case_reader.hpp"
#include "hawser/kernels/radiation_memory.hpp"
#include "hawser/solve/natural_modes.hpp"
#include "verification/platform_rig.hpp"

namespace hawser::test::platforms {
namespace {

using platform_rig::coefficients;
using platform_rig::motion;
using run::Simulation;

// A hemisphere of radius 5 m and 261.8 t in 1000 kg/m³ starts 1 m above its equilibrium, for 10 s.
model::Case hemisphere(double step) {
  const std::string text = fmt::format(R"(hawser: 1
environment: {{gravity: 9.81, water: {{density: 1000}}}}
bodies:
  sphere:
    position: [0, 0, 1]
    floating:
      mass: 261800
      inertia: [2.6e6, 2.6e6, 2.6e6]
      hydrodynamics: {{wamit: {}/tests/data/hemisphere, length_scale: 5}}
statics: false
dynamics: {{duration: 10, step: {}, rho_infinity: 1}}
)",
                                       HAWSER_SOURCE_DIR, step);
  return io::read_case_text(text, testing::TempDir() + "sphere.yaml");
}

// Heave decay from 1 m against the inverse Laplace transform of the exact transform of K, with added mass and
// damping by the multipole method of Hulme (1982). Table of the IEA OES sphere with 261.8 t in 1000 kg/m³.
TEST(Platforms, HemisphereDecays) {
  constexpr double kTime = 2.5;
  const double exact[] = {1, -0.798213175, 0.43444015, -0.144894465, -0.0327708241};

  const auto found = motion(hemisphere(0.02), 10, kTime);
  ASSERT_EQ(found.size(), 5u);
  for (size_t i = 0; i < found.size(); ++i) {
    printf("hemisphere at %4.1f s: %.6f m, exact %.6f m\n", kTime * static_cast<double>(i), found[i][0].z(),
           exact[i]);
    EXPECT_NEAR(found[i][0].z(), exact[i], 1e-3) << i;
  }
}

// Coefficient files of two bodies with B = b (2, -1; -1, 1) omega² exp(-2 omega).
struct Pair {
  static constexpr double kAdded[3] = {800, -200, 600}, kShare[3] = {2, -1, 1};
  static constexpr double kDamping = 6000;
  std::string stem;
  std::vector<double> omega;
  Eigen::MatrixXd damping;

  Pair() {
    for (int k = 1; k <= 120; ++k) omega.push_back(0.05 * k);
    damping.resize(120, 3);
    for (int k = 0; k < 120; ++k)
      for (int e = 0; e < 3; ++e)
        damping(k, e) = kDamping * kShare[e] * omega[k] * omega[k] * std::exp(-2 * omega[k]);
    const auto folder = std::filesystem::path(testing::TempDir()) / "hawser_platform_pair";
    stem = (folder / "pair").string();
    if (rank_of(PETSC_COMM_WORLD) == 0) write(folder);
    MPI_Barrier(PETSC_COMM_WORLD);
  }
  void write(const std::filesystem::path& folder) const {
    std::filesystem::create_directories(folder);
    const int modes[3][2] = {{3, 3}, {3, 9}, {9, 9}};
    std::ofstream radiation(stem + ".1");
    std::ofstream stiffness(stem + ".hst");
    for (int e = 0; e < 3; ++e)
      for (const bool turned : {false, true}) {
        const int i = modes[e][turned];
        const int j = modes[e][!turned];
        if (turned && i == j) continue;
        radiation << fmt::format("0 {} {} {:.17g}\n", i, j, kAdded[e] / 1000);
        for (size_t k = 0; k < omega.size(); ++k)
          radiation << fmt::format("{:.17g} {} {} {:.17g} {:.17g}\n", 2 * M_PI / omega[k], i, j,
                                   kAdded[e] / 1000, damping(static_cast<int>(k), e) / 1000 / omega[k]);
      }
    stiffness << "3 3 0.3\n9 9 0.2\n";
  }
};

// Reference: the same equations by average acceleration and trapezoidal convolution with small steps.
std::vector<Eigen::Vector2d> pair_by_trapezoids(const Pair& pair, Eigen::Vector2d x, double until,
                                                double every) {
  constexpr double h = 0.01;
  const RadiationMemory memory(pair.omega, pair.damping);
  Eigen::Matrix2d M;
  Eigen::Matrix2d C = Eigen::Vector2d(3000, 2000).asDiagonal();
  M << 1000 + Pair::kAdded[0], Pair::kAdded[1], Pair::kAdded[1], 700 + Pair::kAdded[2];
  const int steps = static_cast<int>(std::lround(until / h));
  std::vector<Eigen::Matrix2d> K;
  for (int k = 0; k <= steps; ++k) {
    const auto e = memory.retardation(k * h);
    K.emplace_back();
    K.back() << e[0], e[1], e[1], e[2];
  }
  std::vector<Eigen::Vector2d> v = {Eigen::Vector2d::Zero()};
  std::vector<Eigen::Vector2d> out = {x};
  Eigen::Vector2d a = M.inverse() * (-C * x);
  for (int n = 1; n <= steps; ++n) {
    Eigen::Vector2d past = 0.5 * h * K[static_cast<size_t>(n)] * v[0];
    for (int k = 1; k < n; ++k) past += h * K[static_cast<size_t>(n - k)] * v[static_cast<size_t>(k)];
    // M a + h/2 K(0) v + past + C x = 0, with x and v by average acceleration.
    const Eigen::Vector2d predicted_v = v.back() + 0.5 * h * a;
    const Eigen::Vector2d predicted_x = x + h * v.back() + 0.25 * h * h * a;
    const Eigen::Matrix2d left = M + 0.25 * h * h * K[0] + 0.25 * h * h * C;
    const Eigen::Vector2d next = left.inverse() * (-past - 0.5 * h * K[0] * predicted_v - C * predicted_x);
    x = predicted_x + 0.25 * h * h * next;
    v.push_back(predicted_v + 0.5 * h * next);
    a = next;
    if (std::abs(std::remainder(n * h, every)) < 1e-6) out.push_back(x);
  }
  return out;
}

TEST(Platforms, TwoBodiesRadiateOnEachOther) {
  const Pair pair;
  const std::string text = fmt::format(R"(hawser: 1
environment: {{gravity: 10, water: {{density: 1000}}}}
bodies:
  float: {{position: [0, 0, 0.1], floating: {{mass: 1000, inertia: [400, 400, 400], hydrodynamics: {{wamit: {0}, body: 1}}}}}}
  spar: {{position: [5, 0, -0.05], floating: {{mass: 700, inertia: [400, 400, 400], hydrodynamics: {{wamit: {0}, body: 2}}}}}}
statics: false
dynamics: {{duration: 20, step: 0.02, rho_infinity: 1}}
)",
                                       pair.stem);
  const auto found = motion(io::read_case_text(text, testing::TempDir() + "pair.yaml"), 20, 2);
  const auto exact = pair_by_trapezoids(pair, {0.1, -0.05}, 20, 2);
  ASSERT_EQ(found.size(), exact.size());
  for (size_t i = 0; i < found.size(); ++i) {
    if (rank_of(PETSC_COMM_WORLD) == 0)
      printf("two bodies at %2zu s: %.6f %.6f m, by trapezoids %.6f %.6f m\n", 2 * i, found[i][0].z(),
             found[i][1].z(), exact[i][0], exact[i][1]);
    EXPECT_NEAR(found[i][0].z(), exact[i][0], 2e-4) << i;
    EXPECT_NEAR(found[i][1].z(), exact[i][1], 2e-4) << i;
  }
}

// Steps alternate between 0.05 and 0.2 s: the memory does not require a regular time grid.
TEST(Platforms, StepsMayChange) {
  Simulation s(PETSC_COMM_WORLD, hemisphere(0.05));
  Dynamics& d = s.dynamics();
  d.start(s.state());
  int n = 0;
  double last = 0;
  const auto stop = [&](double t) { return t + (n++ % 3 == 0 ? 0.013 : 0.041); };
  d.run(10, stop, [&](const StepInfo&) {
    last = from_owner(s, [&](size_t node) { return d.committed_kinematics().x[node].z(); });
    return true;
  });
  printf("hemisphere at 10 s with changing steps: %.6f m\n", last);
  EXPECT_NEAR(last, -0.0327708241, 5e-4);
}

// Statics: heave F/C33 by a force F, and pitch F x/(C55 - m g zG) by its arm x for small angles; the weight
// is not part of the coefficients.
TEST(Platforms, RestsUnderLoad) {
  const std::string stem = coefficients("hawser_platform_load/barge", "3 3 200\n4 4 4000\n5 5 4000\n");
  const std::string text = fmt::format(R"(hawser: 1
environment: {{gravity: 10, water: {{density: 1000}}}}
bodies:
  barge:
    floating:
      mass: 1e6
      centre_of_mass: [0, 0, 2]
      inertia: [1e8, 1e8, 1e8]
      hydrodynamics: {{wamit: {}}}
      loads: [{{force: [0, 0, -2000], at: [10, 0, 0]}}]
)",
                                       stem);
  const model::Case c = io::read_case_text(text, testing::TempDir() + "barge.yaml");
  Simulation s(PETSC_COMM_WORLD, c);
  s.solve_statics();
  const double middle = from_owner(s, [&](size_t n) { return s.state().x[n].z(); });
  const double pitch = from_owner(s, [&](size_t n) { return log_so3(s.state().q[n]).y(); });
  EXPECT_NEAR(middle - 2 * std::cos(pitch), -2000.0 / 2e6, 1e-8);
  EXPECT_NEAR(pitch, 2000 * 10 / (4e7 - 1e6 * 10 * 2), 1e-8);
}

// A ship whose centres of mass and buoyancy are ahead of its origin is rotated by a moment on a yaw spring:
// heel and trim stay zero.
TEST(Platforms, ShipYawsUpright) {
  // V x_B = 1000 m³ 4 m.
  const std::string stem = coefficients("hawser_platform_yaw/ship",
                                        "3 3 200\n3 5 -800\n5 3 -800\n4 4 900\n5 5 20000\n4 6 -4000\n");
  const std::string text = fmt::format(R"(hawser: 1
environment: {{gravity: 10, water: {{density: 1000}}}}
bodies:
  ship:
    floating:
      mass: 1e6
      centre_of_mass: [4, 0, 2]
      inertia: [1e8, 1e9, 1e9]
      hydrodynamics:
        wamit: {}
        stiffness: [[1e6, 0, 0, 0, 0, 0], [0, 1e6, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0],
                    [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 1e8]]
      loads: [{{moment: [0, 0, 1e8]}}]
)",
                                       stem);
  const model::Case c = io::read_case_text(text, testing::TempDir() + "ship.yaml");
  Simulation s(PETSC_COMM_WORLD, c);
  s.solve_statics();
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(from_owner(s, [&](size_t n) { return log_so3(s.state().q[n])[k]; }), k == 2 ? 1 : 0, 1e-10)
        << k;
}

// A float of 1000 kg with A = 800 - 300 omega, B = 50 omega and C for which omega = 0.8 has the mode C =
// omega² (m + A), zeta = B/(2 omega (m + A)).
TEST(Platforms, ModesHaveTheAddedMassOfTheirFrequency) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "hawser_platform_modes";
  const std::string stem = (folder / "float").string();
  constexpr double kOmega = 0.8, kMoving = 1000 + 800 - 300 * kOmega;
  if (rank_of(PETSC_COMM_WORLD) == 0) {
    std::filesystem::create_directories(folder);
    std::ofstream radiation(stem + ".1");
    std::ofstream stiffness(stem + ".hst");
    radiation << "0 3 3 0.2\n";
    for (const double omega : {0.4, 1.2})
      radiation << fmt::format("{:.17g} 3 3 {:.17g} {:.17g}\n", 2 * M_PI / omega, (800 - 300 * omega) / 1000,
                               0.05);
    stiffness << fmt::format("3 3 {:.17g}\n4 4 0.4\n5 5 0.5\n", kOmega * kOmega * kMoving / 1e4);
  }
  MPI_Barrier(PETSC_COMM_WORLD);
  const std::string text = fmt::format(R"(hawser: 1
environment: {{gravity: 10, water: {{density: 1000}}}}
bodies:
  float: {{floating: {{mass: 1000, inertia: [400, 400, 400], hydrodynamics: {{wamit: {}}}}}}}
)",
                                       stem);
  Simulation s(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "float.yaml"));
  s.solve_statics();
  bool found = false;
  for (const NaturalMode& mode : hawser::natural_modes(s.system(), s.state().at_rest(), 6)) {
    if (mode.squared < kFreeMotion || mode.squared > 5) continue;  // drift and yaw; roll and pitch
    found = true;
    EXPECT_NEAR(mode.squared, kOmega * kOmega, 1e-8);
    EXPECT_NEAR(mode.damping_ratio, 50 * kOmega / (2 * kOmega * kMoving), 1e-8);
  }
  EXPECT_TRUE(found);
}

// Added mass of 800 kg up to 1.2 rad/s, linear to -1600 kg at 1.6 rad/s and to 0 at 2.4 rad/s, of a
// float of 1000 kg: the mass is negative at its frequency without added mass, and its mode C = omega² (m + A)
// is at 2.2 rad/s. A second float of its own files and the same frequency has the same mode again.
TEST(Platforms, ModesWithNegativeAddedMass) {
  const std::string stem = testing::TempDir() + "hawser_negative/float";
  constexpr double kOmega = 2.2, kMoving = 1000 - 400;
  if (rank_of(PETSC_COMM_WORLD) == 0) {
    std::filesystem::create_directories(testing::TempDir() + "hawser_negative");
    std::ofstream radiation(stem + ".1");
    std::ofstream stiffness(stem + ".hst");
    radiation << "0 3 3 0\n";
    for (const auto& [omega, added] :
         {std::pair(0.2, 800.0), {0.4, 800.0}, {1.2, 800.0}, {1.6, -1600.0}, {2.4, 0.0}, {2.8, 0.0}})
      radiation << fmt::format("{:.17g} 3 3 {:.17g} 0.01\n", 2 * M_PI / omega, added / 1000);
    stiffness << fmt::format("3 3 {:.17g}\n4 4 0.4\n5 5 0.5\n", kOmega * kOmega * kMoving / 1e4);
  }
  MPI_Barrier(PETSC_COMM_WORLD);
  const std::string body =
      fmt::format("floating: {{mass: 1000, inertia: [400, 400, 400], hydrodynamics: {{wamit: {}}}}}", stem);
  const std::string text = fmt::format(R"(hawser: 1
environment: {{gravity: 10, water: {{density: 1000}}}}
bodies:
  one: {{{0}}}
  two: {{position: [50, 0, 0], {0}}}
)",
                                       body);
  Simulation s(PETSC_COMM_WORLD, io::read_case_text(text, testing::TempDir() + "negative.yaml"));
  s.solve_statics();
  const std::vector<NaturalMode> modes = hawser::natural_modes(s.system(), s.state().at_rest(), 12);
  const auto heaves = [](const NaturalMode& m) { return std::abs(m.squared - kOmega * kOmega) < 1e-6; };
  EXPECT_EQ(std::count_if(modes.begin(), modes.end(), heaves), 2);
  for (const NaturalMode& mode : modes) EXPECT_GT(mode.squared, -kFreeMotion);
}

}  // namespace
}  // namespace hawser::test::platforms
