// Longest automatic step from motion tables, from oscillating or rotating bodies, and from platforms, against
// closed forms.
#include "hawser/model/longest_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "hawser/model/summary.hpp"

namespace hawser::longest_step_test {
namespace {

model::Case moved(const model::TableMotion& table) {
  model::Case c;
  c.dynamics.duration = 1e5;
  c.output.every = 1e4;
  c.bodies.emplace_back().motion = table;
  return c;
}

template <class OfTime>
model::TableMotion table(double every, double duration, const OfTime& of_time,
                         BetweenRows between = BetweenRows::spline) {
  model::TableMotion t;
  t.between = between;
  for (int i = 0; i * every <= duration; ++i) {
    t.time.push_back(i * every);
    t.offset.emplace_back(of_time(i * every), 0, 0);
  }
  return t;
}

double wave(double t, double amplitude, double period) { return amplitude * std::sin(2 * M_PI * t / period); }

// The step for a tabulated sine is a hundredth of its period for any rows, as for a sine given by amplitude
// and period. A monotone cubic through few rows has sharp bends at its extremes, so its step may be shorter.
TEST(LongestStep, OfASineInATableIsThatOfTheSine) {
  const auto step = [](double every, BetweenRows between) {
    const auto t = table(
        every, 1200, [](double time) { return wave(time, 2, 12); }, between);
    return model::longest_step(moved(t)).length;
  };
  for (const double every : {0.01, 0.25, 1.0, 2.0}) {
    EXPECT_NEAR(step(every, BetweenRows::spline), 0.12, 0.02 * 0.12) << every;
    EXPECT_NEAR(step(every, BetweenRows::linear), 0.12, 0.12 * 0.12) << every;
    EXPECT_LT(step(every, BetweenRows::monotone), 0.125) << every;
    EXPECT_GT(step(every, BetweenRows::monotone), 0.05) << every;
  }
}

// Closed form: a hundredth of 2 pi sqrt of the sum of (a omega)² over that of (a omega²)². A superposed drift
// or steady velocity does not change the steps per wave.
TEST(LongestStep, OfWavesOnADriftFollowsTheWaves) {
  const double fast = 2 * M_PI / 10, slow = 2 * M_PI / 100;
  const auto t =
      table(0.5, 2000, [](double time) { return wave(time, 1, 10) + wave(time, 8, 100) + 0.7 * time; });
  const double rate = std::pow(fast, 2) + std::pow(8 * slow, 2);
  const double second = std::pow(fast, 4) + std::pow(8 * slow * slow, 2);
  const double step = model::longest_step(moved(t)).length;
  EXPECT_NEAR(step, 2 * M_PI * std::sqrt(rate / second) / 100, 0.01 * step);
  EXPECT_LT(step, 10. / 60);
}

TEST(LongestStep, OfSlowTablesIsLong) {
  model::TableMotion shift;
  shift.between = BetweenRows::monotone;
  shift.time = {0, 1000, 3000, 9000};
  shift.offset = {Vec3::Zero(), Vec3::Zero(), Vec3(30, 0, 0), Vec3(30, 0, 0)};
  EXPECT_GT(model::longest_step(moved(shift)).length, 10);
  model::TableMotion steady;
  steady.time = {0, 5000};
  steady.offset = {Vec3::Zero(), Vec3(5000, 0, 0)};
  EXPECT_EQ(model::longest_step(moved(steady)).length, 1e5 / 50);
}

// Pitch moves attachments at 40 m from the origin, and is combined with heave by this lever.
TEST(LongestStep, OfRotationsGoesByWhatIsAttached) {
  model::TableMotion t = table(0.25, 1000, [](double time) { return wave(time, 2, 20); });
  for (const double time : t.time) t.rotation.emplace_back(0, wave(time, 0.01, 5), 0);
  model::Case c = moved(t);
  c.bodies[0].name = "vessel";
  model::Line& line = c.lines.emplace_back();
  line.end_b.kind = model::EndKind::body;
  line.end_b.carrier = "vessel";
  const auto expected = [](double lever) {
    const double w = 2 * M_PI / 20, p = 2 * M_PI / 5;
    const double rate = std::pow(2 * w, 2) + std::pow(0.01 * lever * p, 2);
    return 2 * M_PI / 100 * std::sqrt(rate / (std::pow(2 * w * w, 2) + std::pow(0.01 * lever * p * p, 2)));
  };
  for (const double lever : {2.0, 40.0}) {
    line.end_b.at = {lever, 0, 0};
    EXPECT_NEAR(model::longest_step(c).length, expected(lever), 0.01 * expected(lever));
  }
}

TEST(LongestStep, OfACurrentThatChanges) {
  model::Case c;
  c.dynamics.duration = 1e5;
  c.output.every = 1e4;
  std::vector<std::pair<double, double>> rows;
  for (int i = 0; i <= 400; ++i) rows.emplace_back(5 * i, 1 + wave(5 * i, 0.3, 100));
  c.environment.water.current.time_factor = TimeFactor(rows);
  EXPECT_NEAR(model::longest_step(c).length, 1, 0.02);
}

// A load on a rope without excitation: a sixtieth of 2 pi sqrt(m L/EA), for which the scheme lengthens the
// period by a thousandth (3.47/n², from the recursion of the scheme). In waves the load moves with the hook,
// and its period does not limit the step.
TEST(LongestStep, OfALoadOnARope) {
  model::Case c;
  c.dynamics.duration = 100;
  c.output.every = 1;
  model::Body& load = c.bodies.emplace_back();
  load.name = "load";
  load.position = {0, 0, -50};
  load.mass.emplace().mass = 4e5;
  model::LineType& rope = c.line_types.emplace_back();
  rope.name = "rope";
  rope.kind = model::LineKind::cable;
  rope.EA = 2e7;
  rope.mass_per_length = 5;
  model::Line& line = c.lines.emplace_back();
  line.sections.push_back({"rope", 50, 10, 1});
  line.end_a.kind = model::EndKind::anchor;
  line.end_b.kind = model::EndKind::body;
  line.end_b.carrier = "load";
  const double period = 2 * M_PI * std::sqrt(4e5 * 50 / 2e7);
  const model::LongestStep free = model::longest_step(c);
  EXPECT_NEAR(free.length, period / 60, 1e-9);
  c.dynamics.enabled = true;
  EXPECT_EQ(free.divisor, 60);
  EXPECT_EQ(free.subject, "the period of body load on its lines");
  EXPECT_NE(model::summary(c).find("s (a sixtieth of the period of body load on its lines)"),
            std::string::npos);
  model::HarmonicMotion heave;
  heave.amplitude = {0, 0, 1};
  heave.period = 30;
  model::Body& crane = c.bodies.emplace_back();
  crane.name = "crane";
  crane.motion = heave;
  EXPECT_NEAR(model::longest_step(c).length, 0.3, 1e-9);
}

// Without excitation: a sixtieth of the shortest period of heave, roll and pitch, here roll with (J +
// A44)/(C44 - m g zG).
TEST(LongestStep, OfAPlatformResolvesItsPeriods) {
  const auto data = std::make_shared<model::HydrodynamicData>();
  data->omega = {0.5, 1};
  data->infinite = Eigen::MatrixXd::Identity(6, 6);
  data->infinite(2, 2) = 5e5;
  data->infinite(3, 3) = 4e6;
  data->added_mass = {data->infinite, data->infinite};
  data->hydrostatic = Eigen::MatrixXd::Zero(6, 6);
  data->hydrostatic(2, 2) = 1e5;
  data->hydrostatic(3, 3) = 6e7;
  data->hydrostatic(4, 4) = 2e7;
  model::Case c;
  c.dynamics.duration = 1e5;
  c.output.every = 1e4;
  c.environment.gravity = 10;
  model::BodyMass& m = c.bodies.emplace_back().mass.emplace();
  m.mass = 1e6;
  m.centre = {0, 0, 1};
  m.inertia = {1e7, 3e7, 3e7};
  m.hydrodynamics.emplace().data = data;
  // The body rolls about the point at which sway has no mean: the coupling with sway reduces the inertia.
  const double coupling = 1e6;
  const double inertia = 1e7 + 1e6 + 4e6 - coupling * coupling / (1e6 + 1);
  const double period = 2 * M_PI * std::sqrt(inertia / (6e7 - 1e7));
  EXPECT_NEAR(model::longest_step(c).length, period / 60, 1e-9);
}

TEST(LongestStep, OfASpinIsAHundredthOfATurn) {
  model::Case c;
  c.dynamics.duration = 1e5;
  c.output.every = 1e4;
  model::BodyMass& m = c.bodies.emplace_back().mass.emplace();
  m.mass = 2;
  m.angular_velocity = {0, 0, -60};
  EXPECT_NEAR(model::longest_step(c).length, 2 * M_PI / 60 / 100, 1e-12);
}

}  // namespace
}  // namespace hawser::longest_step_test
