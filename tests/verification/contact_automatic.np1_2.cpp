// Contact with automatic stiffness (docs/theory/contact.md, "Stiffness that follows the run"): slings over a
// bar and a torus at tensions of 1 to 10^6 times the weight of a radius of line; a capstan whose tension
// increases a hundredfold; a restart with raised stiffness; errors for a given stiffness that is too small.
#include <fmt/format.h>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "regression/runs.hpp"
#include "verification/contact_rig.hpp"

namespace hawser::runs::contact_automatic {
namespace {

using run::Simulation;
using test::NodeField;

constexpr double kBar = 0.2, kLine = 0.02, kRho = kBar + kLine, kLeg = 0.6, kWeight = 2.5 * 9.81;  // m, N/m

std::string points(double radius) {
  std::string text;
  for (const Vec3& p : {Vec3(radius, 0, -kLeg), Vec3(-radius, 0, -kLeg)}) {
    const std::string leg = fmt::format("[{:.9g}, 0, {:.9g}]", p.x(), p.z());
    if (!text.empty()) {
      text += ", " + leg;
      break;
    }
    text = leg;
    for (int i = 0; i <= 30; ++i)
      text += fmt::format(", [{:.9g}, 0, {:.9g}]", radius * std::cos(M_PI * i / 30),
                          radius * std::sin(M_PI * i / 30));
  }
  return text;
}

// A sling over a bar or a torus, with a strain of about 1 %: shortened between two held ends, or loaded at
// one end.
std::string sling(const std::string& shape, double tension, bool loaded, const std::string& stiffness,
                  bool beam = false, double strain = 0.01) {
  const double EA = 1 / strain * (loaded ? std::max(tension, 10 * kWeight) : tension);
  const double length = M_PI * kRho + 2 * kLeg;
  const std::string end =
      loaded ? fmt::format("free\n    loads: [{{at: end_b, force: [0, 0, -{:.9g}]}}]", tension)
             : fmt::format("{{anchor: [-{}, 0, -{}]}}", kRho, kLeg);
  return fmt::format(R"(hawser: 1
line_types:
  rope: {{outer_diameter: {}, mass_per_length: 2.5, EA: {:.9g}, {}}}
volumes:
  bar: {{shape: {}{}}}
lines:
  rope:
    sections: [{{type: rope, length: {:.9g}, elements: 32}}]
    end_a: {{anchor: [{}, 0, -{}]}}
    end_b: {}
    start: {{points: [{}]}}
)",
                     2 * kLine, EA, beam ? "EI: 1.0, GJ: 1.0" : "bending: false", shape, stiffness,
                     length / (1 + tension / EA), kRho, kLeg, end, points(kRho));
}

// A rope half a turn about a bar, held at one end and drawn at the other; its tension increases with the
// displacement. The polyline about the bar is 0.23 % shorter than the arc.
const std::string kDrawn =
    fmt::format(R"(hawser: 1
environment: {{gravity: 0}}
line_types:
  rope: {{outer_diameter: {}, mass_per_length: 2.5, EA: 1.0e7, bending: false, stiffness_damping: 0.001}}
bodies:
  hook: {{position: [-{}, 0, -{}], motion: {{velocity: [0, 0, -0.05], ramp: 0.2}}}}
volumes:
  bar: {{shape: {{cylinder: {{from: [0, -1, 0], to: [0, 1, 0], radius: {}}}}}, friction: 0.3, relative_damping: 0.1}}
lines:
  rope:
    sections: [{{type: rope, length: {:.9g}, elements: 32}}]
    end_a: {{anchor: [{}, 0, -{}]}}
    end_b: {{body: hook, at: [0, 0, 0]}}
    start: {{points: [{}]}}
dynamics: {{duration: 1.2, max_step: 0.01}}
output: {{every: 0.1, histories: [{{line: rope, at: end_a}}]}}
)",
                2 * kLine, kRho, kLeg, kBar, (M_PI * kRho + 2 * kLeg) * 1.0021, kRho, kLeg, points(kRho));

double most(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return x;
}

struct Held {
  double tension = 0, ratio = 0, depth = 0, stiffness = 0;  // N, largest; over the smallest; m; N/m²
  double steps = 0, problem = 0;  // problem: error of the energy balance, over the work brought in
};

void measure(Simulation& s, const Kinematics& state, Held& out) {
  double least = HUGE_VAL, largest = 0;
  NodeField tension(s, "effective_tension");
  for (const double t : tension.at(state)) {
    least = std::min(least, t);
    largest = std::max(largest, t);
  }
  out.tension = most(largest);
  out.ratio = out.tension / -most(-least);
  out.depth = most(s.line_volume_contact()->largest_penetration().depth);
  out.stiffness = s.line_volume_contact()->stiffness(0);
}

std::unique_ptr<Simulation> simulation(const std::string& name, const std::string& text) {
  const std::string path = folder("contact_automatic") + "/" + name + ".yaml";
  write_case(path, text);
  const model::Case c = io::read_case(path);
  return std::make_unique<Simulation>(MPI_COMM_WORLD, c, run::surfaces(run::load_volumes(c, MPI_COMM_WORLD)));
}

Held still(const std::string& name, const std::string& text) {
  const auto s = simulation(name, text);
  s->solve_statics();
  Held out;
  measure(*s, s->state().at_rest(), out);
  return out;
}

const char* const kCylinder = "{cylinder: {from: [0, -1, 0], to: [0, 1, 0], radius: 0.2}}";
const char* const kTorus = "{torus: {centre: [0, 0, 1], axis: [1, 0, 0], radius: 1.0, tube_radius: 0.2}}";

class Sling : public ::testing::TestWithParam<std::tuple<const char*, bool, double>> {};

// Penetration is at most 5 % of the radius, and tensions are within 1 % of those with a given stiffness a
// hundred times as large and practically no smoothing.
TEST_P(Sling, IsHeldOut) {
  const auto [shape, loaded, over_weight] = GetParam();
  const double tension = over_weight * kWeight * kLine;
  const Held own = still("sling", sling(shape, tension, loaded, ""));
  const Held stiff =
      still("stiff", sling(shape, tension, loaded,
                           fmt::format(", smoothing: 1.0e-7, normal_stiffness: {{per_length: {:.9g}}}",
                                       100 * own.stiffness)));
  if (rank_of(MPI_COMM_WORLD) == 0)
    std::printf(
        "tension %.3g of the weight of a radius: %.6g N of %.6g, %.3g of the radius deep, %.3g N/m²\n",
        over_weight, own.tension, stiff.tension, own.depth / kLine, own.stiffness);
  EXPECT_GT(own.depth, 0);
  EXPECT_LE(own.depth, 0.05 * kLine);
  EXPECT_NEAR(own.tension, stiff.tension, 0.01 * stiff.tension);
  EXPECT_NEAR(own.ratio, stiff.ratio, 0.01 * stiff.ratio);
}
INSTANTIATE_TEST_SUITE_P(Shapes, Sling,
                         ::testing::Combine(::testing::Values(kCylinder, kTorus), ::testing::Values(true),
                                            ::testing::Values(1.0, 1e2, 1e3, 1e4, 1e5, 1e6)));

// Between held ends the penetration reduces the tension.
INSTANTIATE_TEST_SUITE_P(Stretched, Sling,
                         ::testing::Combine(::testing::Values(kCylinder, kTorus), ::testing::Values(false),
                                            ::testing::Values(1e3, 1e4, 1e5, 1e6)));

// A large load stretches the line. The stiffness that would carry the line's weight alone would let the line
// pass through the bar.
class Stretched : public ::testing::TestWithParam<std::tuple<bool, const char*, double>> {};

TEST_P(Stretched, StaysOnTheBar) {
  const auto [beam, method, strain] = GetParam();
  const auto s = simulation("stretched", sling(kCylinder, 1e5, true, "", beam, strain) + method);
  s->solve_statics();
  Held out;
  measure(*s, s->state().at_rest(), out);
  double top = -HUGE_VAL;
  for (int n = 0; n < s->local().owned; ++n) top = std::max(top, s->state().x[static_cast<size_t>(n)].z());
  EXPECT_NEAR(most(top), kRho, 0.15 * kLine);
  EXPECT_LE(out.depth, 0.05 * kLine);
  EXPECT_NEAR(out.tension, 1e5, 1e3);
  EXPECT_LT(out.ratio, 1.01);
}
// The line does not pass through a thin bar either, whose middle is nearer to its surface than the line's
// diameter.
TEST(Slings, StayOnAThinBar) {
  for (const double strain : {0.01, 0.05}) {
    const auto s = simulation(
        "thin", sling("{box: {centre: [0, 0, 0.19], size: [0.1, 2, 0.005]}}", 1e4, true, "", false, strain));
    s->solve_statics();
    double top = -HUGE_VAL;
    for (int n = 0; n < s->local().owned; ++n) top = std::max(top, s->state().x[static_cast<size_t>(n)].z());
    EXPECT_GT(most(top), 0.19) << strain;
  }
}
INSTANTIATE_TEST_SUITE_P(Slings, Stretched,
                         ::testing::Combine(::testing::Bool(),
                                            ::testing::Values("", "contact: {method: nodes}\n",
                                                              "statics: {contact_friction: true}\n"),
                                            ::testing::Values(0.03, 0.06, 0.1)));

TEST(Slings, AreNotDrawnThroughContactThatIsTooSoft) {
  try {
    still("soft", sling(kCylinder, 1e5, true, ", normal_stiffness: {per_length: 1.0e5}", false, 0.06));
    ADD_FAILURE() << "statics went through the bar";
  } catch (const SolveError& e) {
    const std::string message = e.what();
    EXPECT_NE(message.find(" m, would pass through volume bar: its normal_stiffness is too small for the "
                           "contact force; 'auto' chooses a sufficient value"),
              std::string::npos)
        << message;
  }
}

// One rank has the raised stiffness in its records, and all ranks continue with it. The run that raised it
// has reported it.
TEST(Slings, RestoreTheStiffness) {
  const std::string text = sling(kCylinder, 5e4, true, "");
  const auto first = simulation("first", text);
  const double initial = first->line_volume_contact()->stiffness(0);
  first->solve_statics();
  const double raised = first->line_volume_contact()->stiffness(0);
  EXPECT_GT(raised, initial);
  const auto again = simulation("again", text);
  again->line_volume_contact()->restore(first->line_volume_contact()->save());
  EXPECT_EQ(again->line_volume_contact()->stiffness(0), raised);
  EXPECT_TRUE(again->take_stiffness_raises("").empty());
}

// Beams, and contact at the nodes.
TEST(Slings, OfBeamsAndAtNodes) {
  for (const bool beam : {false, true})
    for (const char* method : {"", "contact: {method: nodes}\n"}) {
      const Held own = still("kinds", sling(kCylinder, 5e4, true, "", beam) + method);
      EXPECT_GT(own.depth, 0) << beam << method;
      EXPECT_LE(own.depth, 0.05 * kLine) << beam << method;
    }
}

// The tension increases more than a hundredfold during the run; its ratio at the end is exp(mu theta) (Euler,
// Eytelwein).
TEST(Drawn, TensionGrowsAHundredfold) {
  const auto s = simulation("drawn", kDrawn);
  s->solve_statics();
  Held before, after;
  measure(*s, s->state().at_rest(), before);
  Dynamics& d = s->dynamics();
  d.start(s->state());
  const Energy start = s->system().energy(d.committed_kinematics());
  d.run(
      1.2, [](double t) { return t + 100; },
      [&](const StepInfo&) {
        ++after.steps;
        return true;
      });
  measure(*s, d.committed_kinematics(), after);
  const Energy e = s->system().energy(d.committed_kinematics());
  double sums[2] = {e.work + d.support_work(), e.kinetic + e.strain - start.kinetic - start.strain +
                                                   e.friction + e.damping - start.friction - start.damping};
  MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  after.problem = sums[1] / sums[0] - 1;
  if (rank_of(MPI_COMM_WORLD) == 0)
    std::printf(
        "drawn: %.6g N, then %.6g; T2/T1 %.5f, exact %.5f; %.3g of the radius deep; %.3g, then %.3g N/m²; %g "
        "steps, %.3g of the energy not accounted for\n",
        before.tension, after.tension, after.ratio, std::exp(0.3 * M_PI), after.depth / kLine,
        before.stiffness, after.stiffness, after.steps, after.problem);
  EXPECT_GT(after.tension, 100 * before.tension);
  EXPECT_GT(after.stiffness, 2 * before.stiffness);
  EXPECT_LE(after.depth, 0.05 * kLine);
  EXPECT_NEAR(after.ratio, std::exp(0.3 * M_PI), 0.01 * std::exp(0.3 * M_PI));
  EXPECT_LT(std::abs(after.problem), 0.01);
  EXPECT_LT(after.steps, 1250);  // the tension rises from 5e-5 of its largest, which divides steps
}

// A restart continues with the stiffness that the first part has raised.
TEST(Drawn, GoesOnFromACheckpoint) {
  const std::string path = folder("contact_automatic_restart");
  const std::string input = path + "/case.yaml";
  write_case(input, kDrawn);
  run_on_all({input, path + "/whole.h5"});
  run_on_all({input, path + "/half.h5", "", 0.6});
  run_on_all({input, path + "/rest.h5", path + "/half.h5"});
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const auto whole = read(path + "/whole.h5").series;
  const auto rest = read(path + "/rest.h5").series;
  for (const auto& [name, values] : rest) {
    const auto& all = whole.at(name);
    ASSERT_GT(all.size(), values.size());
    const std::vector<double> tail(all.end() - static_cast<std::ptrdiff_t>(values.size()), all.end());
    EXPECT_LE(largest_difference(tail, values), 1e-12 * std::max(largest(all), 1.0)) << name;
  }
}

std::string refusal(const std::string& text, bool moves) {
  const auto s = simulation("refused", text);
  try {
    s->solve_statics();
    EXPECT_TRUE(moves) << "statics is good";
    s->dynamics().start(s->state());
    s->dynamics().run(
        1.2, [](double t) { return t + 100; }, [](const StepInfo&) { return true; });
  } catch (const SolveError& e) {
    return e.what();
  }
  return {};
}

// A stiffness given by the user that is too small stops the run with an error that names the place, the depth
// and a sufficient stiffness.
TEST(TooSoft, IsRefused) {
  const std::string still =
      refusal(sling(kCylinder, 5e4, true, ", normal_stiffness: {per_length: 5.0e6}"), false);
  for (const char* part : {"statics: line rope, arc length ", " m, would pass through volume bar: its "})
    EXPECT_NE(still.find(part), std::string::npos) << still;
  std::string text = kDrawn;
  text.replace(text.find("friction: 0.3,"), 14, "friction: 0.3, normal_stiffness: {per_length: 1.0e6},");
  const std::string moving = refusal(text, true);
  for (const char* part : {"stopped at t = ", "line rope, arc length ", " m deep in volume bar at t = ",
                           "deeper than its radius of 0.02 m", "{per_length: "})
    EXPECT_NE(moving.find(part), std::string::npos) << moving;
}

}  // namespace
}  // namespace hawser::runs::contact_automatic
