// Warnings of peaks of tension that steps or elements do not resolve.
#include "hawser/record/snaps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::record::snaps_test {
namespace {

// Two elements of 2 m: a wave passes one in 2 sqrt(5/1e8) = 0.447 ms, and travels along the line and back in
// 1.79 ms.
const char* const kSling = R"(
hawser: 1
line_types: {wire: {outer_diameter: 0.05, mass_per_length: 5, EA: 1.0e8, bending: false}}
lines:
  sling:
    sections: [{type: wire, length: 4, elements: 2}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [3.9, 0, 0]}
)";

// Warning about half a wave of this duration [s] and 1 kN in equal steps, one of which is at the maximum.
std::string warning(double half, int steps, double rest = 0, bool damped = false, double across = 0) {
  const model::Case c = io::read_case_text(kSling, "/nowhere/case.yaml");
  const run::Simulation sim(MPI_COMM_SELF, c);
  Snaps snaps(c, sim.local());
  const double h = half / steps;
  for (int k = 0; k <= steps; ++k) {
    const double way = M_PI * k / steps;
    const std::vector<double> tension(3, rest + (1000 - rest) * std::max(std::sin(way), 0.0));
    const PerLine<Snaps::VolumePassage> over(sim.local(), {across, 1 + h * k - 1e-3});
    snaps.update(1 + h * k, k == 0 ? 0 : h, tension, tension, &over);
  }
  return snaps.warning(0, "sling", 1000, damped, advice::StepChoice::given);
}

// With 4 steps the largest rise in a step is 1 - cos(pi/4) = 29 % of the maximum, with 8 steps it is small.
TEST(Snaps, OfTooFewSteps) {
  EXPECT_EQ(warning(1, 4),
            "the largest tension of line sling (1 kN at arc length 0 m, t = 1.5 s) is due to an impact that "
            "is not resolved: 29 % of it build up in one step of 0.25 s; the true value may be higher or "
            "lower, and the value may differ on another number of ranks. If it matters, compare with "
            "dynamics.step: 0.083 s and elements half as long");
  EXPECT_EQ(warning(1, 8), "");
  EXPECT_EQ(warning(1, 4, 600), "");  // a wave of 400 N on 600 N
}

// After a resolved peak of 1 kN the wire has `later` newtons at the end of a step that began slack.
std::string later_peak(double later) {
  const model::Case c = io::read_case_text(kSling, "/nowhere/case.yaml");
  const run::Simulation sim(MPI_COMM_SELF, c);
  Snaps snaps(c, sim.local());
  const auto update = [&](double time, double h, double T) {
    const std::vector<double> tension(3, T);
    snaps.update(time, h, tension, tension);
  };
  update(0, 0, 0);
  for (int k = 1; k <= 100; ++k) update(0.01 * k, 0.01, 1000 * std::sin(M_PI * k / 100));
  update(1.25, 0.25, later);
  update(1.5, 0.25, 0);
  update(1.75, 0.25, 0);
  return snaps.warning(0, "sling", 1000, false, advice::StepChoice::given);
}

// From 0 in one step: at least a quarter of the period, so that the peak is up to 800 N/cos(pi/4).
TEST(Snaps, BetweenLaterSteps) {
  EXPECT_EQ(later_peak(600), "");
  EXPECT_EQ(
      later_peak(800),
      "line sling comes taut within one step of 0.25 s (t = 1.25 s, arc length 0 m): the peak between "
      "the steps may be 1.131 kN, above the largest tension. If it matters, compare with dynamics.step: "
      "0.042 s");
}

// A restart begins at the end of a step, whose tension at its start is not known.
TEST(Snaps, NotAtARestart) {
  const model::Case c = io::read_case_text(kSling, "/nowhere/case.yaml");
  const run::Simulation sim(MPI_COMM_SELF, c);
  Snaps snaps(c, sim.local());
  for (int k = 0; k < 3; ++k) {
    const std::vector<double> tension(3, 1000 - k);
    snaps.update(1 + 0.1 * k, 0.1, tension, tension, nullptr);
  }
  EXPECT_EQ(snaps.warning(0, "sling", 1000, false, advice::StepChoice::given), "");
}

// A peak of 3 ms: its phase is 0.35 rad in a third of a millisecond and 1.05 rad in a millisecond, the times
// that a transverse wave needs to pass an element over a volume.
TEST(Snaps, OfAnElementOverAVolume) {
  EXPECT_EQ(warning(3e-3, 100, 0, false, 0.33e-3), "");
  EXPECT_NE(warning(3e-3, 100, 0, false, 1e-3)
                .find("a transverse wave takes to pass an element that lies over a volume"),
            std::string::npos);
  EXPECT_EQ(warning(3e-3, 100, 800, false, 1e-3), "");  // most of the tension is permanent: no impact
}

// The phase of a wave of 2 ms between zeros advances by 0.70 rad in the time that an axial wave needs to pass
// an element, that of 4 ms by 0.35 rad.
TEST(Snaps, OfTooFewElements) {
  EXPECT_NE(warning(2e-3, 100).find("lasts less than an axial wave takes to pass three elements"),
            std::string::npos);
  EXPECT_EQ(warning(4e-3, 100), "");
}

// If the steps damp axial waves, a rise within the round trip of a wave, 1.79 ms, is reported as well: half
// of 3 ms is shorter, half of 4 ms is not.
TEST(Snaps, OfDampedWaves) {
  EXPECT_EQ(warning(3e-3, 100), "");
  EXPECT_NE(
      warning(3e-3, 100, 0, true).find("it rises from 0 kN within 0.0015 s, and the steps damp axial waves"),
      std::string::npos);
  EXPECT_EQ(warning(4e-3, 100, 0, true), "");
  EXPECT_EQ(warning(3e-3, 100, 700, true), "");
}

// A drop at a release is no impact.
TEST(Snaps, NotOfWhatFalls) {
  const model::Case c = io::read_case_text(kSling, "/nowhere/case.yaml");
  const run::Simulation sim(MPI_COMM_SELF, c);
  Snaps snaps(c, sim.local());
  const std::vector<double> held(3, 1000), loose(3, 100);
  snaps.update(0, 0, held, held);
  snaps.update(0.1, 0.1, held, held);
  snaps.update(0.2, 0.1, loose, loose);
  EXPECT_EQ(snaps.warning(0, "sling", 1000, true, advice::StepChoice::given), "");
}

}  // namespace
}  // namespace hawser::record::snaps_test
