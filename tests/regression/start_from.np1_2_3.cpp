// A run that starts from the results of another one: the same equilibrium; another current, other elements,
// other ends; rejected input.
#include <algorithm>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::start_from {
namespace {

const char* const kCase = R"(
hawser: 1
environment:
  water: {depth: 80}
  current: {speed: 0.9, direction_deg: 40}
  seabed: {depth: 80, friction: 0.4}
line_types:
  hose: {outer_diameter: 0.3, mass_per_length: 95, EA: 4e7, EI: 2e4, GJ: 1e4, Cd_normal: 1.1}
  chain: {outer_diameter: 0.1, mass_per_length: 60, EA: 2e8, bending: false}
lines:
  riser:
    sections: [{type: hose, length: 130, elements: 40}]
    end_a: {anchor: [0, 0, -80]}
    end_b: {anchor: [85, 5, -2], direction: [0.2, 0, 1], clamped: true}
  tail:
    sections: [{type: chain, length: 110, elements: 30}]
    end_a: {anchor: [0, 50, -80]}
    end_b: {anchor: [60, 50, -3]}
dynamics: {duration: 2, step: 0.1}
output: {every: 1, histories: [{line: riser, at: end_b, name: top}]}
)";

std::vector<double> first(const std::string& file, const char* field) {
  const Results r = read(file);
  const auto& all = r.fields.at(field);
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / r.output_times.size())};
}

class StartFrom : public ::testing::Test {
 protected:
  void SetUp() override {
    path = folder("start_from");
    write_case(path + "/a.yaml", kCase);
    run_on_all({path + "/a.yaml", path + "/a.h5"});
  }
  static bool zero() { return rank_of(MPI_COMM_WORLD) == 0; }
  // Runs a case that starts from a.h5, with edits, and the same case from its own start shape.
  void both(const std::string& name, Edits edits) {
    write_case(path + "/" + name + "_own.yaml", kCase, edits);
    edits.push_back({"lines:\n", "start: {from: a.h5}\nlines:\n"});
    write_case(path + "/" + name + ".yaml", kCase, edits);
    run_on_all({path + "/" + name + "_own.yaml", path + "/" + name + "_own.h5"});
    run_on_all({path + "/" + name + ".yaml", path + "/" + name + ".h5"});
  }
  void expect_same_statics(const std::string& name, double most) {
    if (!zero()) return;
    const double off = largest_difference(first(path + "/" + name + ".h5", "position"),
                                          first(path + "/" + name + "_own.h5", "position"));
    printf("  %s: %.1e m apart\n", name.c_str(), off);
    EXPECT_LT(off, most) << name;
  }
  std::string path;
};

// Without friction on the bed the equilibrium does not depend on the start shape.
TEST_F(StartFrom, GoesOnToTheSameEquilibrium) {
  const std::pair<std::string, std::string> smooth{"friction: 0.4", "friction: 0"};
  both("same", {smooth});
  expect_same_statics("same", 1e-5);
  both("current", {smooth, {"speed: 0.9, direction_deg: 40", "speed: 0.6, direction_deg: 70"}});
  expect_same_statics("current", 1e-5);
  both("elements", {smooth, {"elements: 40", "elements: 65"}, {"elements: 30", "elements: 12"}});
  expect_same_statics("elements", 1e-5);
  both("ends", {smooth, {"[85, 5, -2]", "[92, -3, -4]"}, {"length: 110", "length: 108"}});
  expect_same_statics("ends", 1e-5);
}

// Without statics the run starts with the positions and section axes of the other run within round-off, at a
// chosen output, for a renamed line.
TEST_F(StartFrom, ShapeAsItWasLeft) {
  const std::string file = path + "/as_left.yaml";
  write_case(file, kCase,
             {{"line: riser", "line: steep"},
              {"dynamics:", "statics: false\ndynamics:"},
              {"  riser:\n", "  steep:\n    start: {from: a.h5, line: riser, time: 1}\n"},
              {"lines:\n", "start: {from: a.h5, time: 1}\nlines:\n"}});
  run_on_all({file, path + "/as_left.h5"});
  if (!zero()) return;
  const Results a = read(path + "/a.h5");
  const Results b = read(path + "/as_left.h5");
  ASSERT_EQ(a.output_times.size(), 3u);
  for (const char* field : {"position", "axis_1", "axis_2"}) {
    const auto& then = a.fields.at(field);
    const auto& now = b.fields.at(field);
    const size_t n = then.size() / 3;
    double off = 0;
    for (size_t i = 0; i < n; ++i) off = std::max(off, std::abs(then[n + i] - now[i]));
    // The clamped end starts with its rotation at equilibrium.
    EXPECT_LT(off, 1e-9) << field;
    EXPECT_GT(largest(now), 0.9) << field;
  }
}

// The parts of a line that is cut later are one line before that time.
TEST_F(StartFrom, ALineThatIsCutThere) {
  write_case(path + "/cut.yaml", kCase,
             {{"output: {", "events: [{cut: {line: tail, at: 60}, time: 1.5}]\noutput: {"},
              {"chain: {", "chain: {stiffness_damping: 1e-3, "}});
  run_on_all({path + "/cut.yaml", path + "/cut.h5"});
  write_case(path + "/before.yaml", kCase, {{"lines:\n", "start: {from: cut.h5, time: 1}\nlines:\n"}});
  const model::Case c = io::read_case(path + "/before.yaml");
  ASSERT_TRUE(c.lines[1].previous_shape);
  EXPECT_NEAR(c.lines[1].previous_shape->arc.back(), 110, 1e-9);
  EXPECT_EQ(c.lines[1].previous_shape->arc.size(), 31U);
  EXPECT_TRUE(std::is_sorted(c.lines[1].previous_shape->arc.begin(), c.lines[1].previous_shape->arc.end()));
  const Vec3 gap = c.lines[1].previous_shape->position.back() - Vec3(60, 50, -3);
  EXPECT_LT(gap.norm(), 1e-9);
  write_case(path + "/after.yaml", kCase, {{"lines:\n", "start: {from: cut.h5}\nlines:\n"}});
  try {
    io::read_case(path + "/after.yaml");
    FAIL() << "parts that are apart";
  } catch (const InputError& e) {
    EXPECT_NE(
        std::string(e.what()).find("It is cut there, and its parts have come apart: give a 'time' before "
                                   "that, or make each part a line"),
        std::string::npos)
        << e.what();
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

TEST_F(StartFrom, RefusesInOneSentence) {
  const auto refusal = [&](const Edits& edits) -> std::string {
    write_case(path + "/bad.yaml", kCase, edits);
    std::string what;
    try {
      io::read_case(path + "/bad.yaml");
    } catch (const InputError& e) {
      what = e.what();
    }
    MPI_Barrier(MPI_COMM_WORLD);
    return what;
  };
  const auto expect = [&](const Edits& edits, const char* sentence) {
    const std::string what = refusal(edits);
    EXPECT_NE(what.find(sentence), std::string::npos) << what;
  };
  expect({{"  riser:\n", "  riser:\n    start: {from: a.h5, line: raiser}\n"}}, "lines.riser.start.line: ");
  expect({{"  riser:\n", "  riser:\n    start: {from: a.h5, line: raiser}\n"}}, "has no line 'raiser'");
  expect({{"  riser:\n", "  riser:\n    start: {from: a.h5, line: raiser}\n"}}, "did you mean 'riser'");
  expect({{"  riser:\n", "  riser:\n    start: {from: a.h5, time: 1.3}\n"}}, "the nearest is at 1 s");
  expect({{"length: 130", "length: 200"}, {"lines:\n", "start: {from: a.h5}\nlines:\n"}},
         "the line is 200 m long, but 130 m in");
  expect({{"output: {", "output: {file: a.h5, "}, {"lines:\n", "start: {from: a.h5}\nlines:\n"}},
         "this run would overwrite it");
  if (zero()) std::filesystem::copy_file(path + "/a.h5", path + "/b.h5~");
  MPI_Barrier(MPI_COMM_WORLD);
  expect({{"output: {", "output: {file: b.h5, "}, {"lines:\n", "start: {from: b.h5~}\nlines:\n"}},
         "b.h5~ is the file that line 'riser' starts from, and this run would overwrite it");
  // A line that is not in the other run has its automatic start shape, with a note.
  write_case(path + "/new.yaml", kCase,
             {{"  riser:\n", "  new:\n"},
              {"line: riser", "line: new"},
              {"lines:\n", "start: {from: a.h5}\nlines:\n"}});
  const model::Case c = io::read_case(path + "/new.yaml");
  EXPECT_FALSE(c.lines[0].previous_shape);
  EXPECT_TRUE(c.lines[1].previous_shape);
  ASSERT_FALSE(c.notes.empty());
  EXPECT_NE(c.notes[0].find("lines.new: is not in a.h5"), std::string::npos) << c.notes[0];
  MPI_Barrier(MPI_COMM_WORLD);
}

}  // namespace
}  // namespace hawser::runs::start_from
