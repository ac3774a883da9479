// Pipes with contents and marine growth: wall tension, weight, inertia and drag, from case files.
#include <filesystem>
#include <fstream>

#include "hawser/io/case_reader.hpp"
#include "hawser/io/hdf5.hpp"
#include "hawser/run/driver.hpp"
#include "support/rig.hpp"

namespace hawser::test::wall_tension_test {
namespace {

constexpr double kG = 9.80665, kRho = 1025, kQuarter = M_PI / 4;

// A pipe of 0.3 m hangs from z = 10 m, 400 m long, with a free end; `more` are further keys of its type.
std::string hanging(bool beam, const std::string& more) {
  return std::string(
             "hawser: 1\nenvironment: {water: {depth: 1000}}\nline_types:\n  pipe: {outer_diameter: 0.3, "
             "mass_per_length: 200, EA: 1e10, ") +
         (beam ? "EI: 1e5, GJ: 1e5" : "bending: false") + more +
         "}\nlines:\n  pipe:\n    sections: [{type: pipe, length: 400, elements: 40}]\n"
         "    end_a: {anchor: [0, 0, 10]}\n    end_b: free\n"
         "    start: {points: [[0, 0, 10], [0, 0, -390]]}\nstatics: true\n";
}

// Node fields of a case at rest from the results file.
struct Shown {
  std::vector<double> position, effective, wall;
};
Shown shown(const std::string& text) {
  const std::string base = ::testing::TempDir() + "wall-tension";
  std::ofstream(base + ".yaml") << text;
  run::RunOptions options;
  options.case_path = base + ".yaml";
  options.output = base + ".h5";
  options.quiet = true;
  EXPECT_EQ(run::run(MPI_COMM_WORLD, options), 0);
  Shown s;
  {
    const io::h5::Id file = io::h5::open_read(base + ".h5");
    s.position = io::h5::read_array(file, "fields/position").values;
    s.effective = io::h5::read_array(file, "fields/effective_tension").values;
    s.wall = io::h5::read_array(file, "fields/wall_tension").values;
  }
  for (const char* end : {".yaml", ".h5", ".xdmf"}) std::filesystem::remove(base + end);
  return s;
}

// T_w = T_e + p_i A_i - p_e A_e with the areas of the bare pipe, with contents, growth or modules: only
// pressures at the free end, no external pressure in air, the whole weight at the top.
TEST(WallTension, HangingPipe) {
  struct Kind {
    const char* name;
    const char* more;
    double bore = 0, contents = 0, pressure = 0, mass = 200, displaced = 0.3;
  };
  const double grown = 200 + 1400 * kQuarter * (0.4 * 0.4 - 0.3 * 0.3);
  const double filled = 200 + 800 * kQuarter * 0.25 * 0.25;
  for (const Kind& k : {Kind{"bare", ""},
                        {"contents", ", contents: {inner_diameter: 0.25, density: 800, pressure: 2e6}", 0.25,
                         800, 2e6, filled},
                        {"growth", ", marine_growth: {thickness: 0.05, density: 1400}", 0, 0, 0, grown, 0.4},
                        {"module", ", displaced_diameter: 0.45", 0, 0, 0, 200, 0.45}})
    for (const bool beam : {false, true}) {
      SCOPED_TRACE(testing::Message() << k.name << (beam ? ", beam" : ", cable"));
      const Shown s = shown(hanging(beam, k.more));
      ASSERT_EQ(s.wall.size(), 41U);
      const double outside = kQuarter * 0.3 * 0.3;
      const double inside = kQuarter * k.bore * k.bore;
      const double up = kRho * kQuarter * k.displaced * k.displaced;  // kg/m
      double most = 0;
      for (size_t n = 0; n < s.wall.size(); ++n) {
        const double z = s.position[3 * n + 2];
        const double arc_left = 400 - 10 * static_cast<double>(n);
        const double wet = std::min(arc_left, 390.0);
        double effective = kG * (k.mass * arc_left - up * wet);
        if (k.displaced > 0.4 && !beam) effective = std::max(effective, 0.0);
        const double wall =
            effective + inside * (k.pressure - k.contents * kG * z) - outside * kRho * kG * std::max(-z, 0.0);
        // Tensions are those in the middle of the elements; at the surface, where buoyancy begins, a quarter
        // of an element's buoyancy is missing.
        const double near = n == 1 ? 0.26 * kG * up * 10 : 100;
        if (n != 1) most = std::max(most, std::abs(s.wall[n] - wall));
        EXPECT_NEAR(s.wall[n], wall, near) << n;
        EXPECT_NEAR(s.effective[n], effective, near) << n;
      }
      printf("  %s, %s: wall %.0f N at the top, %.0f N at the free end, off by up to %.0f N\n", k.name,
             beam ? "beam" : "cable", s.wall.front(), s.wall.back(), most);
      EXPECT_NEAR(s.effective.back(), 0, 1e-3);
      const double depth = -s.position.back();
      EXPECT_NEAR(s.wall.back(),
                  inside * (k.pressure + k.contents * kG * depth) - outside * kRho * kG * depth, 1e-2);
    }
}

// At its end the wall of a coated pipe has the pressure of the sea on its own area, as without the coating.
TEST(WallTension, CoatedPipe) {
  std::string text = hanging(true, "");
  const std::string plain = "outer_diameter: 0.3, mass_per_length: 200, EA: 1e10, EI: 1e5, GJ: 1e5";
  text.replace(
      text.find(plain), plain.size(),
      "pipe: {outer_diameter: 0.3, wall_thickness: 0.02, coatings: [{thickness: 0.05, density: 700}]}");
  const Shown s = shown(text);
  const double pressure = kRho * kG * -s.position.back();
  EXPECT_NEAR(s.effective.back(), 0, 1e-3);
  EXPECT_NEAR(s.wall.back(), -kQuarter * 0.3 * 0.3 * pressure, 1e-2);
}

// Sinking of filled or overgrown rods, v = v_t tanh(t/tau): weight, inertia, displaced and drag
// diameter.
TEST(WallTension, FilledAndOvergrownRodsSink) {
  struct Kind {
    const char* more;
    double mass, displaced, dragged;
  };
  const double filled = 300 + 900 * kQuarter * 0.4 * 0.4;
  const double grown = 300 + 1325 * kQuarter * (0.6 * 0.6 - 0.5 * 0.5);
  for (const Kind& k : {Kind{", contents: {inner_diameter: 0.4, density: 900}", filled, 0.5, 0.5},
                        {", marine_growth: {thickness: 0.05}", grown, 0.6, 0.6},
                        // Free-flooding: the displaced volume is smaller than that of the outside, which has
                        // the drag; growth is a ring around the outside.
                        {", displaced_diameter: 0.3", 300, 0.3, 0.5},
                        {", displaced_diameter: 0.3, marine_growth: {thickness: 0.05}", grown,
                         std::sqrt(0.3 * 0.3 + 0.6 * 0.6 - 0.5 * 0.5), 0.6},
                        {", drag_diameter: 0.8, marine_growth: {thickness: 0.05}", grown, 0.6, 0.9}}) {
    model::Case c = io::read_case_text(
        std::string(
            "hawser: 1\nenvironment: {water: {depth: 1000}}\nline_types:\n  rod: {outer_diameter: 0.5, "
            "mass_per_length: 300, EA: 1e8, bending: false") +
            k.more +
            "}\nlines:\n  rod:\n    sections: [{type: rod, length: 4, elements: 4}]\n    end_a: free\n    "
            "end_b: free\n    start: {points: [[0, 0, -100], [4, 0, -100]]}\nstatics: false\n"
            "dynamics: {duration: 4, step: 0.01}\n",
        HAWSER_SOURCE_DIR "/tests/rod.yaml");
    Simulation sim(PETSC_COMM_SELF, c);
    sim.dynamics().start(sim.state());
    const double lifted = kRho * kQuarter * k.displaced * k.displaced;
    const double weight = (k.mass - lifted) * kG;
    const double drag = 0.5 * kRho * 1.2 * k.dragged;
    const double fastest = std::sqrt(weight / drag);
    const double tau = (k.mass + lifted) / std::sqrt(weight * drag);
    for (const double t : {0.5, 1.0, 2.0, 4.0}) {
      sim.dynamics().run(
          t, [t](double) { return t; }, [](const StepInfo&) { return true; });
      const double v = fastest * std::tanh(t / tau);
      EXPECT_NEAR(-sim.dynamics().committed_kinematics().v[2].z(), v, 1e-3 * v) << k.more << " " << t;
    }
  }
}

}  // namespace
}  // namespace hawser::test::wall_tension_test
