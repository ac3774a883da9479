// Wave-drift damping: decay of surge in a regular wave that exerts no force, with and without the damping.
#include <fmt/format.h>

#include "hawser/io/case_reader.hpp"
#include "verification/platform_rig.hpp"

namespace hawser::test::drift_damping {
namespace {

// A barge on a soft spring in waves of amplitude a. The coefficient b, interpolated between two periods,
// gives the damping b a²:
//   x = e^(-q t) (cos w t + q/w sin w t) x_0,   q = b a²/(2 m),   w² = k/m - q²
TEST(DriftDamping, SurgeDecaysInWaves) {
  constexpr double kMass = 1e6, kStiffness = 4e3, kHeight = 4, kLow = 3e3, kHigh = 9e3, kStart = 10;
  const double omega = 2 * M_PI / 8, low = 2 * M_PI / 10, high = 2 * M_PI / 5;
  const double b = kLow + (kHigh - kLow) * (omega - low) / (high - low);
  const std::string stem = platform_rig::coefficients("hawser_drift_damping/barge", "3 3 1000\n");
  if (runs::rank_of(PETSC_COMM_WORLD) == 0)
    std::ofstream(stem + ".3") << "10 0 3 1e-6 0 1e-6 0\n5 0 3 1e-6 0 1e-6 0\n";
  MPI_Barrier(PETSC_COMM_WORLD);
  for (const bool damped : {false, true}) {
    const std::string text =
        fmt::format(R"(hawser: 1
environment: {{gravity: 10, water: {{density: 1000}}, waves: {{regular: {{height: {}, period: 8}}}}}}
bodies:
  barge:
    position: [{}, 0, 0]
    floating:
      mass: {}
      inertia: [1e8, 1e8, 1e8]
      hydrodynamics:
        wamit: {}
        follow_period: 0
        place: [0, 0, 0]
        stiffness: [[{}, 0, 0, 0, 0, 0], [0, 1e4, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 1e8, 0, 0], [0, 0, 0, 0, 1e8, 0], [0, 0, 0, 0, 0, 1e8]]
{}
statics: false
dynamics: {{duration: 300, step: 0.2, rho_infinity: 1}}
)",
                    kHeight, kStart, kMass, stem, kStiffness,
                    damped ? fmt::format("        wave_drift_damping: {{rows: [[10, {}, 0, 0], "
                                         "[5, {}, 0, 0]]}}",
                                         kLow, kHigh)
                           : "");
    const auto found =
        platform_rig::motion(io::read_case_text(text, testing::TempDir() + "barge.yaml"), 300, 20);
    const double q = damped ? b * kHeight * kHeight / 4 / (2 * kMass) : 0;
    const double w = std::sqrt(kStiffness / kMass - q * q);
    ASSERT_EQ(found.size(), 16u);
    double off = 0;
    for (size_t i = 0; i < found.size(); ++i) {
      const double t = 20 * static_cast<double>(i);
      off = std::max(off, std::abs(found[i][0].x() -
                                   kStart * std::exp(-q * t) * (std::cos(w * t) + q / w * std::sin(w * t))));
    }
    printf("surge in waves: decay by %.3f in 300 s, off by %.1e m of %.0f m\n", std::exp(-q * 300), off,
           kStart);
    EXPECT_LT(off, 2e-3 * kStart);
  }
}

}  // namespace
}  // namespace hawser::test::drift_damping
