// Responses to waves against closed forms: a float with constant coefficients in all six degrees of freedom,
// alone and rotated, and one on a tether with mass.
#include "hawser/solve/linear_responses.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <filesystem>
#include <fstream>

#include "hawser/io/case_reader.hpp"
#include "hawser/kernels/waves.hpp"
#include "hawser/math/heading.hpp"
#include "verification/platform_rig.hpp"

namespace hawser::test::linear_responses {
namespace {

using run::Simulation;

// Coefficients of a float with the same A and B at all frequencies, C = (0, 0, 2e4, 3e5, 4e5, 0) and wave
// forces X of waves in +x, in 1000 kg/m³ and 10 m/s².
const Mat6 kAdded = [] {
  Mat6 A = Vec6(800, 900, 1500, 6e3, 7e3, 8e3).asDiagonal();
  A(0, 4) = A(4, 0) = 500;
  A(1, 3) = A(3, 1) = -400;
  return A;
}();
const Mat6 kDamping = [] {
  Mat6 B = Vec6(300, 350, 900, 2e3, 2500, 100).asDiagonal();
  B(0, 4) = B(4, 0) = -200;
  B(3, 5) = B(5, 3) = 100;
  return B;
}();
const ComplexVec6 kForces = [] {
  ComplexVec6 X;
  X << Complex(100, 3000), Complex(50, -20), Complex(1.5e4, -800), Complex(400, 300), Complex(-900, -7000),
      Complex(60, 80);
  return X;
}();
constexpr double kMass = 2000, kInertia[3] = {5e3, 6e3, 7e3}, kOmega = 0.9;

std::string coefficients() {
  const std::string stem = testing::TempDir() + "hawser_responses/float";
  if (rank_of(PETSC_COMM_WORLD) == 0) {
    std::filesystem::create_directories(std::filesystem::path(stem).parent_path());
    std::ofstream radiation(stem + ".1");
    std::ofstream waves(stem + ".3");
    std::ofstream(stem + ".hst") << "3 3 2\n4 4 30\n5 5 40\n4 6 -1\n";
    for (const double omega : {0.5, kOmega, 1.5}) {
      for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j)
          radiation << fmt::format("{:.17g} {} {} {:.17g} {:.17g}\n", 2 * M_PI / omega, i + 1, j + 1,
                                   kAdded(i, j) / 1000, kDamping(i, j) / 1000 / omega);
        const Complex X = kForces[i] / 1e4;
        waves << fmt::format("{:.17g} 0 {} {:.17g} {:.17g} {:.17g} {:.17g}\n", 2 * M_PI / omega, i + 1,
                             std::abs(X), std::arg(X) * 180 / M_PI, X.real(), X.imag());
      }
    }
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        radiation << fmt::format("0 {} {} {:.17g}\n", i + 1, j + 1, kAdded(i, j) / 1000);
  }
  MPI_Barrier(PETSC_COMM_WORLD);
  return stem;
}

WaveComponent wave(double direction) {
  return {1, kOmega, wave_number(kOmega, 0, 10), std::cos(direction), std::sin(direction), 0};
}

// Motion of the first body's node, from its owner: space axes, and rotations in its own.
ComplexVec6 response(Simulation& s, const WaveComponent& w) {
  ComplexVec6 out = ComplexVec6::Zero();
  hawser::linear_responses(s.system(), s.state().at_rest(), {w}, [&](size_t, const std::vector<Complex>& u) {
    const int n = s.local().find(s.mesh().body_node(0));
    if (s.local().owns(n))
      out = Eigen::Map<const ComplexVec6>(&u[3 * static_cast<size_t>(s.local().block[n])]);
  });
  MPI_Allreduce(MPI_IN_PLACE, out.data(), 12, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return out;
}

// The centre of mass is in the origin, the centre of buoyancy 0.5 m ahead of it. A moment about fixed axes
// balances the float, so that its stiffness is not symmetric: yaw causes a moment of roll, but not the
// reverse.
TEST(LinearResponses, SixCoupledEquations) {
  const std::string stem = coefficients();
  for (const double heading : {0.0, 0.7}) {
    const double x = 300, y = -200;
    Simulation s(
        PETSC_COMM_WORLD,
        io::read_case_text(fmt::format(R"(hawser: 1
environment: {{gravity: 10, water: {{density: 1000}}}}
bodies:
  float:
    position: [{}, {}, 0]
    rotation_deg: [0, 0, {}]
    floating:
      mass: {}
      inertia: [{}, {}, {}]
      hydrodynamics:
        wamit: {}
        displaced_volume: 2
        stiffness: [[4e3, 0, 0, 0, 700, 0], [0, 3e3, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0],
                    [700, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 9e3]]
        damping: [[50, 0, 0, 0, 0, 0], [0, 60, 0, 0, 0, 0], [0, 0, 70, 0, 0, 0], [0, 0, 0, 80, 0, 0],
                  [0, 0, 0, 0, 90, 0], [0, 0, 0, 0, 0, 100]]
      loads: [{{moment: [{}, {}, 0]}}]
)",
                                       x, y, heading * 180 / M_PI, kMass, kInertia[0], kInertia[1],
                                       kInertia[2], stem, -1e4 * std::sin(heading), 1e4 * std::cos(heading)),
                           testing::TempDir() + "float.yaml"));
    s.solve_statics();
    Mat6 C = Vec6(4e3, 3e3, 2e4, 3e5, 4e5, 9e3).asDiagonal();
    C(0, 4) = C(4, 0) = 700;
    C(3, 5) = -1e4;
    Mat6 M = kAdded;
    M.diagonal() += Vec6(kMass, kMass, kMass, kInertia[0], kInertia[1], kInertia[2]);
    Mat6 B = kDamping;
    B.diagonal() += Vec6(50, 60, 70, 80, 90, 100);
    Eigen::Matrix<Complex, 6, 6> Z = (C - kOmega * kOmega * M).cast<Complex>();
    Z += Complex(0, kOmega) * B;
    const WaveComponent w = wave(heading);
    const Complex crest = std::polar(1.0, -w.number * (w.x * x + w.y * y));
    ComplexVec6 exact = Z.partialPivLu().solve(kForces * crest);
    const Mat3 H = heading_axes(heading);
    exact.head<3>() = (H * exact.head<3>()).eval();
    const ComplexVec6 found = response(s, w);
    for (int k = 0; k < 6; ++k)
      EXPECT_LT(std::abs(found[k] - exact[k]), 1e-8 * exact.segment<3>(k / 3 * 3).norm()) << k;
  }
}

// Heave on a vertical tether of 200 m below the surface, an elastic rod of the mass m a length: at its upper
// end it resists a displacement z by EA q cot(q L) z, q = omega sqrt(m/EA). It weighs nothing in water.
TEST(LinearResponses, FloatOnATetherWithMass) {
  const std::string stem = coefficients();
  constexpr double kEA = 1.2e6, kPerLength = 45, kLength = 200;
  const auto heave = [&](int elements) {
    Simulation s(PETSC_COMM_WORLD,
                 io::read_case_text(fmt::format(R"(hawser: 1
environment: {{gravity: 10, water: {{density: 1000}}}}
line_types:
  rod: {{outer_diameter: {:.17g}, mass_per_length: {}, EA: {}, bending: false, Ca_normal: 0, Cd_normal: 0}}
bodies:
  float: {{floating: {{mass: {}, inertia: [5e3, 6e3, 7e3], hydrodynamics: {{wamit: {}, displaced_volume: 2.1}}, loads: [{{moment: [0, 1e4, 0]}}]}}}}
lines:
  tether: {{sections: [{{type: rod, length: {}, elements: {}}}], end_a: {{anchor: [0, 0, -210]}}, end_b: {{body: float, at: [0, 0, -10]}}}}
)",
                                                std::sqrt(4 * kPerLength / (1000 * M_PI)), kPerLength, kEA,
                                                kMass, stem, kLength, elements),
                                    testing::TempDir() + "tether.yaml"));
    s.solve_statics();
    return response(s, wave(0))[2];
  };
  const double q = kOmega * std::sqrt(kPerLength / kEA);
  const Complex Z(2e4 - kOmega * kOmega * (kMass + kAdded(2, 2)) + kEA * q / std::tan(q * kLength),
                  kOmega * kDamping(2, 2));
  const Complex exact = kForces[2] / Z;
  for (const int elements : {20, 40}) {
    const double error = std::abs(heave(elements) / exact - 1);
    if (rank_of(PETSC_COMM_WORLD) == 0) printf("tether of %d elements: heave off by %.1e\n", elements, error);
    EXPECT_LT(error, 0.02 / (elements * elements));
  }
}

}  // namespace
}  // namespace hawser::test::linear_responses
