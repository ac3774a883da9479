// Lengths that meet a target, against closed forms of the catenary; unattainable targets; several targets at
// once; a restart. On 1 and 2 ranks.
#include "hawser/run/targets.hpp"

#include "../regression/runs.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/hdf5.hpp"
#include "hawser/kernels/catenary_on_bed.hpp"
#include "hawser/model/check.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::targets_test {
namespace {

constexpr double kWeight = 1000, kEA = 5e8;  // N/m, N

const char* const kTypes =
    "hawser: 1\nline_types: {rope: {outer_diameter: 0.1, mass_per_length: 100, EA: 500 MN, bending: false}}\n"
    "contact: {between_lines: false}\n";

model::Case case_of(const std::string& text) {
  return io::read_case_text(kTypes + text, "target.yaml", {}, PETSC_COMM_WORLD);
}

// From (0, 0, 0) to (100, 0, 20).
model::Case hanging(const std::string& target, double length = 110, int elements = 800) {
  return case_of(
      "environment: {gravity: 10}\nlines:\n  l:\n    sections: [{type: rope, length: " +
      std::to_string(length) + ", elements: " + std::to_string(elements) +
      "}]\n    end_a: {anchor: [0, 0, 0]}\n    end_b: {anchor: [100, 0, 20]}\n    target: " + target + "\n");
}

// On rigid ground 100 m below, to an end 360 m away.
model::Case lying(const std::string& target, const std::string& more = "") {
  return case_of(
      "environment: {gravity: 10, seabed: {depth: 100, normal_stiffness: {per_length: 1e8}}}\nlines:\n  l:\n "
      "   "
      "sections: [{type: rope, length: 395, elements: 80}]\n    end_a: {anchor: [0, 0, -99.95]}\n    end_b: "
      "{anchor: "
      "[360, 0, 0]}\n    target: " +
      target + "\n" + more);
}

run::MetTargets met(const model::Case& c) { return run::meet_targets(PETSC_COMM_WORLD, c, {}); }

double length_of(const run::MetTargets& m, size_t line = 0) { return model::length_of(m.model.lines[line]); }

CatenaryShape closed(double length) {
  return catenary(Vec3(0, 0, 0), Vec3(100, 0, 20), {{length, Vec3(0, 0, -kWeight), kEA, Vec3::Zero(), 0}});
}

// Argument at which a monotone function is `target`.
template <class F>
double solved(double low, double high, double target, F&& f) {
  const bool increasing = f(high) > f(low);
  for (int i = 0; i < 200; ++i) {
    const double x = 0.5 * (low + high);
    ((f(x) < target) == increasing ? low : high) = x;
  }
  return 0.5 * (low + high);
}

double declination(const Vec3& tension) { return std::acos(tension.z() / tension.norm()) * 180 / M_PI; }

// A hot pipe that leaves the soil beside its anchor. At some lengths the pipe and the soil springs, whose
// directions rotate with it, rotate each other back and forth. Trials must not need thousands of relaxation
// steps for this.
TEST(Targets, PipeThatTurnsInTheSoil) {
  const model::Case c = io::read_case_text(R"(hawser: 1
environment:
  water: {density: 1025, depth: 30}
  seabed: {depth: 30, normal_stiffness: {per_area: 100 kN/m3}, friction: 0.5}
line_types:
  pipe:
    pipe: {outer_diameter: 0.2, wall_thickness: 0.012, grade: X65}
    Ca_normal: 1
    thermal_expansion: 1.17e-5
bodies: {vessel: {position: [0, 0, 0]}}
lines:
  main:
    sections: [{type: pipe, length: 62, elements: 31}]
    end_a: {anchor: [-50, 0, -32]}
    end_b: {body: vessel, at: [0, 0, 0], direction: [0.7, 0, 0.7], clamped: true}
    bend_stiffeners: [{at: end_b, EI: [[0, 1e7], [4, 1e5]]}]
    temperature_change: 40
    buried: [{from: end_a, to: 5, resistance: {axial: 5000, normal: 9000}}]
    target: {touchdown: 20, at: end_a}
contact: {between_lines: false}
)",
                                           "soil.yaml", {}, PETSC_COMM_WORLD);
  int relaxed = 0;
  const run::MetTargets m = run::meet_targets(PETSC_COMM_WORLD, c, {}, [&](const StaticsReport& now) {
    relaxed = std::max(relaxed, now.relaxation_steps);
  });
  printf("  %d steps of relaxation at the most: %s\n", relaxed, m.sentences.at(0).c_str());
  EXPECT_LT(relaxed, 50);
}

// Each trial reports its result.
TEST(Targets, TrialsAreReported) {
  std::vector<std::string> trials;
  const run::MetTargets m = run::meet_targets(PETSC_COMM_WORLD, hanging("{tension: 120 kN}", 110, 40), {}, {},
                                              [&](const std::string& trial) { trials.push_back(trial); });
  const std::string found = "(after " + std::to_string(trials.size()) + " static solutions)";
  EXPECT_TRUE(m.sentences.at(0).ends_with(found))
      << m.sentences.at(0) << ", " << trials.size() << " reported";
  EXPECT_TRUE(trials.at(0).starts_with(
      "statics 1 of the search for lengths: line l: with 110 m of section 1 the tension at end B is "))
      << trials.at(0);
  EXPECT_TRUE(trials.at(0).ends_with(", the target 120000 N")) << trials.at(0);
}

TEST(Targets, TensionOfACatenary) {
  const double expected = solved(103, 140, 120e3, [](double x) { return closed(x).tension_b().norm(); });
  const run::MetTargets m = met(hanging("{tension: 120 kN}"));
  printf("  %.8f m, closed form %.8f m: %s\n", length_of(m), expected, m.sentences.at(0).c_str());
  EXPECT_NEAR(length_of(m), expected, 1e-6 * expected);
  // From both sides, and at the other end.
  EXPECT_NEAR(length_of(met(hanging("{tension: 120 kN}", 103.5))), expected, 1e-6 * expected);
  const double at_a = solved(103, 140, 120e3, [](double x) { return closed(x).tension_a().norm(); });
  EXPECT_NEAR(length_of(met(hanging("{tension: 120 kN, at: end_a}"))), at_a, 1e-6 * at_a);
}

TEST(Targets, DeclinationOfACatenary) {
  const double b = solved(103, 140, 40, [](double x) { return declination(closed(x).tension_b()); });
  EXPECT_NEAR(length_of(met(hanging("{declination_deg: 40}"))), b, 1e-5 * b);
  const double a = solved(103, 140, 115, [](double x) { return declination(closed(x).tension_a()); });
  EXPECT_NEAR(length_of(met(hanging("{declination_deg: 115, at: end_a}"))), a, 1e-5 * a);
}

TEST(Targets, OnTheSeabed) {
  const auto on_bed = [](double length) {
    return *catenary_on_bed(Vec3(0, 0, 0.05 - 100), Vec3(360, 0, 0),
                            {{length, Vec3(0, 0, -kWeight), kEA, Vec3::Zero(), 0}}, 0);
  };
  const double length = solved(385, 420, 150, [&](double x) { return on_bed(x).grounded(); });
  for (const char* target : {"{touchdown: 150}", "{laid_length: 150}", "{touchdown: 150, at: end_a}"}) {
    const run::MetTargets m = met(lying(target));
    printf("  %s: %.4f m, closed form %.4f m\n", target, length_of(m), length);
    EXPECT_NEAR(length_of(m), length, 0.05);
  }
  const double taut = solved(380, 420, 350e3, [&](double x) { return on_bed(x).tension_b().norm(); });
  EXPECT_NEAR(length_of(met(lying("{tension: 350 kN}"))), taut, 0.02);
}

// A position `end_b` moves with the end; a numerical position stays.
TEST(Targets, OfOneSection) {
  const model::Case c = case_of(
      "environment: {gravity: 10}\nlines:\n  l:\n    sections: [{type: rope, length: 60, elements: 60}, "
      "{type: "
      "rope, length: 50, elements: 50}]\n    end_a: {anchor: [0, 0, 0]}\n    end_b: {anchor: [100, 0, 20]}\n "
      "   "
      "masses: [{at: 60, mass: 100}]\n    target: {tension: 120 kN, section: 2}\noutput: {histories: [{line: "
      "l, at: "
      "end_b}]}\n");
  const model::Case out = met(c).model;
  EXPECT_EQ(out.lines[0].sections[0].length, 60);
  EXPECT_NE(out.lines[0].sections[1].length, 50);
  EXPECT_EQ(out.lines[0].sections[1].elements, 50);
  EXPECT_EQ(out.lines[0].masses[0].at, 60);
  EXPECT_EQ(out.output.histories[0].at, model::length_of(out.lines[0]));
}

// Three lines at a joint: the tension of one depends on the length of the other.
TEST(Targets, OfLinesThatPullAtEachOther) {
  if (ranks_of(MPI_COMM_WORLD) > 1 && !std::getenv("HAWSER_FULL")) GTEST_SKIP() << "long; set HAWSER_FULL";
  const std::string line =
      ": {sections: [{type: rope, length: 75, elements: 40}], end_b: {joint: knot}, end_a: ";
  const model::Case c =
      case_of("environment: {gravity: 10}\njoints: {knot: {start: [0, 0, -40]}}\nlines:\n  a" + line +
              "{anchor: [-30, 52, 0]}, target: {tension: 95 kN, at: end_a}}\n  b" + line +
              "{anchor: [60, 0, 0]}, target: {tension: 100 kN, at: end_a}}\n  c" + line +
              "{anchor: [-30, -52, 0]}}\n");
  const run::MetTargets m = met(c);
  for (const std::string& s : m.sentences) printf("  %s\n", s.c_str());
  ASSERT_EQ(m.sentences.size(), 2u);
  EXPECT_NE(m.sentences[0].find("tension at end A is 95000 N"), std::string::npos) << m.sentences[0];
  EXPECT_NE(m.sentences[1].find("tension at end A is 100000 N"), std::string::npos) << m.sentences[1];
}

std::string refusal(const std::function<void()>& what) {
  try {
    what();
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

void expect_refused(const std::function<void()>& what, const std::string& why) {
  const std::string message = refusal(what);
  EXPECT_NE(message.find(why), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(Targets, ThatCannotBeMet) {
  const auto out_of_reach = [] { met(hanging("{tension: 1 kN}", 110, 100)); };
  printf("  %s\n", refusal(out_of_reach).c_str());
  expect_refused(out_of_reach,
                 "lines.l.target: no length of section 1 between 55 and 165 m was found that makes "
                 "1000 N the tension at end B");
  const auto too_short = [] { met(hanging("{tension: 1 GN}", 110, 100)); };
  expect_refused(too_short, "beyond these: target.yaml");
  expect_refused([] { met(hanging("{tension: 10 MN, between: [109, 111]}", 110, 100)); }, "109 to 111 m");
}

TEST(Targets, ThatMakeNoSense) {
  expect_refused([] { hanging("{touchdown: 50}"); }, "there is no 'environment.seabed'");
  expect_refused([] { hanging("{tension: 5, section: 2}"); }, "there is no section 2; the line has 1");
  expect_refused([] { hanging("{tension: 5, between: [120, 130]}"); }, "110 m, which is not between");
  expect_refused([] { hanging("{tension: 5, laid_length: 4}"); }, "exclude each other");
  expect_refused([] { lying("{laid_length: 4, at: end_a}"); }, "does not apply to 'laid_length'");
  expect_refused([] { lying("{touchdown: 4}", "statics: false\ndynamics: {duration: 1}\n"); },
                 "statics: false");
}

// The results have the length found; a restart uses it.
TEST(Targets, ThroughTheProgram) {
  const std::string folder = runs::folder("targets");
  const std::string path = folder + "/target.yaml";
  const std::string file = folder + "/t.h5";
  runs::write_case(
      path, std::string(kTypes) +
                "environment: {gravity: 10, water: {}}\nlines:\n  l:\n    sections: [{type: rope, "
                "length: 110, elements: 40}]\n    end_a: {anchor: [0, 0, -50]}\n    end_b: {anchor: [100, "
                "0, -30]}\n    target: {tension: 100 kN}\ndynamics: {duration: 0.4, step: 0.1}\n");
  runs::run(PETSC_COMM_WORLD, {path, file, "", 0.2});
  runs::run(PETSC_COMM_WORLD, {path, file, file, 0});
  if (runs::rank_of(PETSC_COMM_WORLD) != 0) return;
  const io::h5::Id h5 = io::h5::open_read(file);
  const auto arc = io::h5::read_array(h5, "nodes/arc_length").values;
  const auto tension = io::h5::read_row(h5, "fields/effective_tension", 0).values;
  EXPECT_NE(arc.back(), 110);
  EXPECT_NEAR(tension.back(), 100e3, 1);
  const auto messages = io::h5::read_texts(h5, "messages");
  std::string all;
  for (const std::string& m : messages) all += m;
  EXPECT_NE(all.find("line l: section 1 is "), std::string::npos) << all;
}

}  // namespace
}  // namespace hawser::targets_test
