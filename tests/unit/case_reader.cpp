// Valid case files: written values are read, and missing ones have the documented defaults.
#include "hawser/io/case_reader.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "hawser/base/error.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/summary.hpp"

namespace hawser::case_reader_test {
namespace {

namespace fs = std::filesystem;
using model::Case;

constexpr const char* kTypes =
    "hawser: 1\n"
    "line_types:\n"
    "  hose: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, EI: 1e4, GJ: 1e4}\n"
    "  chain: {outer_diameter: 100 mm, mass_per_length: 0.1 t/m, EA: 100 MN, bending: false}\n";

Case read(const std::string& text) {
  return io::read_case_text(text, (fs::path(HAWSER_SOURCE_DIR) / "tests/data/bad/text.yaml").string());
}
Case read_line(const std::string& line) {
  return read(std::string(kTypes) + "lines:\n  a: {" + line + "}\n");
}

bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-14; }

// Linear waves above the breaking limit are accepted with a note. Miche's limit is 0.142 of the length in
// deep water and 0.142 tanh(kd) in general.
TEST(CaseReader, WavesThatWouldBreak) {
  const auto notes = [](const std::string& sea) {
    std::vector<std::string> all =
        read(kTypes + std::string("environment: {") + sea +
             "}\n"
             "lines: {a: {sections: [{type: hose, length: 100, elements: 20}], end_a: {anchor: [0, 0, 0]}, "
             "end_b: {anchor: [90, 0, 0]}}}\n")
            .notes;
    // Other notes: the chain is too heavy for its diameter, and dynamics is missing.
    std::erase_if(all, [](const std::string& n) {
      return n.find("line_types.chain") != std::string::npos ||
             n.find("waves: they act") != std::string::npos;
    });
    return all;
  };
  // The wave of 9 s has a length of 126.4 m and a limit of 17.95 m; in 10 m of water 81.7 m and 7.50 m.
  EXPECT_TRUE(notes("water: {}, waves: {regular: {height: 17.9, period: 9}}").empty());
  const auto deep = notes("water: {}, waves: {regular: {height: 19, period: 9}}");
  ASSERT_EQ(deep.size(), 1U);
  EXPECT_NE(deep[0].find("waves.regular: a wave of 19 m would break: 126 m long, it gets 18 m high"),
            std::string::npos)
      << deep[0];
  EXPECT_TRUE(notes("water: {depth: 10}, waves: {regular: {height: 7.4, period: 9}}").empty());
  EXPECT_EQ(notes("water: {depth: 10}, waves: {regular: {height: 7.6, period: 9}}").size(), 1U);
  const auto second =
      notes("water: {}, waves: {components: [{height: 1, period: 9}, {height: 2, period: 2}]}");
  ASSERT_EQ(second.size(), 1U);
  EXPECT_NE(second[0].find("components[1]"), std::string::npos);
  // The limit of a sea's steepness is 1/15 up to 8 s and 1/25 from 15 s: at 12 s 0.0514, 11.6 m.
  const auto spectrum = [&](const std::string& kind, double height, double period) {
    return notes("water: {}, waves: {" + kind + ": {hs: " + std::to_string(height) +
                 ", tp: " + std::to_string(period) + "}}");
  };
  for (const std::string kind : {"jonswap", "pierson_moskowitz"}) {
    EXPECT_TRUE(spectrum(kind, 11.5, 12).empty());
    const auto steep = spectrum(kind, 13, 12);
    ASSERT_EQ(steep.size(), 1U);
    EXPECT_NE(steep[0].find("waves." + kind +
                            ": waves of a sea of 13 m at 12 s would break: its steepness "
                            "2 pi hs/(g tp²) is 0.0578, and seas of this period get to 0.0514, 11.6 m high"),
              std::string::npos)
        << steep[0];
    EXPECT_TRUE(spectrum(kind, 2.58, 5).empty());  // 9.80665/2 pi/15 25 m
    EXPECT_EQ(spectrum(kind, 2.63, 5).size(), 1U);
    EXPECT_TRUE(spectrum(kind, 24.9, 20).empty());  // 9.80665/2 pi/25 400 m
    EXPECT_EQ(spectrum(kind, 25.1, 20).size(), 1U);
  }
}

TEST(CaseReader, Reel) {
  const Case c = io::read_case(HAWSER_SOURCE_DIR "/cases/reel/reel.yaml");
  EXPECT_EQ(c.title, "Marlim Sul hose reel");
  EXPECT_EQ(c.environment.gravity, 9.80665);
  ASSERT_EQ(c.line_types.size(), 1U);
  const model::LineType& t = c.line_type("hose");
  EXPECT_EQ(t.kind, model::LineKind::beam);
  EXPECT_EQ(t.outer_diameter, 0.85);
  EXPECT_EQ(t.contact_diameter, 0.85);
  EXPECT_EQ(t.mass_per_length, 273.4);
  EXPECT_EQ(t.EA, 9.505e8);
  EXPECT_EQ(t.EI2, 1e6);
  EXPECT_EQ(t.EI3, 1e6);
  EXPECT_EQ(t.GJ, 1e6);
  EXPECT_EQ(t.GA, 0);
  const double round = 273.4 * 0.85 * 0.85 / 8;
  EXPECT_TRUE(near(t.rotary_inertia, {round, round / 2, round / 2}));
  ASSERT_EQ(c.bodies.size(), 1U);
  EXPECT_EQ(c.body_index("reel"), 0);
  EXPECT_EQ(c.body_index("wheel"), -1);
  EXPECT_EQ(c.bodies[0].ramp, 10);
  const auto& m = std::get<model::ConstantMotion>(c.bodies[0].motion);
  EXPECT_EQ(m.axis, Vec3(0, -1, 0));
  EXPECT_EQ(m.rate, 0.1);
  EXPECT_EQ(m.velocity, Vec3(0, 0, 0));
  ASSERT_EQ(c.volumes.size(), 1U);
  EXPECT_EQ(c.volumes[0].mesh, (fs::path(HAWSER_SOURCE_DIR) / "cases/reel/drum.stl").string());
  EXPECT_EQ(c.volumes[0].body, "reel");
  EXPECT_EQ(c.volumes[0].basis, model::StiffnessBasis::per_length);
  EXPECT_EQ(c.volumes[0].normal_stiffness, 2e8);
  EXPECT_EQ(c.volumes[0].friction.axial, 0.3);
  EXPECT_EQ(c.volumes[0].friction.lateral, 0.3);
  ASSERT_EQ(c.lines.size(), 1U);
  const model::Line& l = c.lines[0];
  ASSERT_EQ(l.sections.size(), 1U);
  EXPECT_EQ(l.sections[0].length, 250);
  EXPECT_EQ(l.sections[0].elements, 250);
  EXPECT_EQ(l.end_a.kind, model::EndKind::body);
  EXPECT_EQ(l.end_a.at, Vec3(4.025, -2.3, 0));
  EXPECT_TRUE(l.end_a.clamped);
  EXPECT_EQ(l.end_a.direction.value(), Vec3(0, 0, -1));
  EXPECT_EQ(l.end_b.kind, model::EndKind::free);
  EXPECT_EQ(l.start, model::Start::hanging);
  ASSERT_EQ(l.loads.size(), 1U);
  EXPECT_EQ(l.loads[0].per_length, Vec3(0, 93.8, 0));
  EXPECT_LT(l.loads[0].to, 0);
  EXPECT_EQ(c.contact.method, model::ContactMethod::line);
  EXPECT_TRUE(c.contact.all_lines && c.contact.all_volumes);
  EXPECT_TRUE(c.statics.enabled && c.dynamics.enabled);
  EXPECT_EQ(c.dynamics.duration, 325);
  EXPECT_EQ(c.dynamics.step, 0);
  EXPECT_EQ(c.output.every, 1);
  EXPECT_EQ(c.output.file, (fs::path(HAWSER_SOURCE_DIR) / "cases/reel/reel.h5").string());
  EXPECT_TRUE(c.output.xdmf);
  ASSERT_EQ(c.output.histories.size(), 2U);
  EXPECT_EQ(c.output.histories[1].at, 250);
  EXPECT_TRUE(c.notes.empty());
  EXPECT_NE(c.text.find("Marlim Sul"), std::string::npos);
}

TEST(CaseReader, HangingLine) {
  const Case c = io::read_case(HAWSER_SOURCE_DIR "/cases/hanging-line/hanging-line.yaml");
  EXPECT_EQ(c.lines.size(), 1U);
  EXPECT_TRUE(c.volumes.empty());
  EXPECT_FALSE(c.dynamics.enabled);
}

// Defaults of the schema must equal those of model::Case.
TEST(CaseReader, DefaultsAreThoseOfTheCase) {
  const Case c = read_line(
      "sections: [{type: chain, length: 10, elements: 5}], end_a: {anchor: [0, 0, 0]}, end_b: free");
  const Case d;
  EXPECT_EQ(c.title, d.title);
  EXPECT_EQ(c.environment.gravity, d.environment.gravity);
  EXPECT_EQ(c.contact.method, d.contact.method);
  EXPECT_EQ(c.contact.all_lines, d.contact.all_lines);
  EXPECT_EQ(c.statics.enabled, d.statics.enabled);
  EXPECT_EQ(c.statics.tolerance, d.statics.tolerance);
  EXPECT_EQ(c.statics.max_iterations, d.statics.max_iterations);
  EXPECT_EQ(c.dynamics.enabled, d.dynamics.enabled);
  EXPECT_EQ(c.output.every, d.output.every);
  EXPECT_EQ(c.output.xdmf, d.output.xdmf);
  const Case s = read_line(
      "sections: [{type: chain, length: 10, elements: 5}], end_a: {anchor: [0, 0, 0]}, end_b: free}\n"
      "bodies: {b: {}}\nvolumes: {v: {mesh: box.obj}}\nstatics: {}\ndynamics: {duration: 1");
  EXPECT_EQ(s.statics.tolerance, d.statics.tolerance);
  EXPECT_EQ(s.statics.max_iterations, d.statics.max_iterations);
  EXPECT_EQ(s.dynamics.step, d.dynamics.step);
  EXPECT_EQ(s.dynamics.rho_infinity, d.dynamics.rho_infinity);
  EXPECT_EQ(s.dynamics.tolerance, d.dynamics.tolerance);
  EXPECT_EQ(s.dynamics.error_tolerance, d.dynamics.error_tolerance);
  const model::Volume v;
  const model::Volume& w = s.volumes[0];
  EXPECT_EQ(w.scale, v.scale);
  EXPECT_EQ(w.basis, v.basis);
  EXPECT_EQ(w.smoothing, v.smoothing);
  EXPECT_EQ(w.relative_damping, v.relative_damping);
  EXPECT_EQ(w.friction.axial, v.friction.axial);
  EXPECT_EQ(w.friction.mobilisation_length, v.friction.mobilisation_length);
  const model::Body b;
  EXPECT_EQ(s.bodies[0].position, b.position);
  EXPECT_EQ(s.bodies[0].rotation, b.rotation);
  EXPECT_EQ(s.bodies[0].motion.index(), 0U);
  EXPECT_EQ(s.lines[0].start, model::Start::automatic);
  EXPECT_EQ(s.lines[0].sections[0].grading, 1);
}

TEST(CaseReader, EverythingGiven) {
  const Case c = read(std::string(kTypes) + R"(
  flat: {outer_diameter: 0.3, contact_diameter: 350 mm, mass_per_length: 80, EA: 1e8, EI: [1 MN m2, 20 kN m2],
         GJ: 5e4, GA: 1e7, rotary_inertia: [1, 2, 3], stiffness_damping: 10 ms}
bodies:
  ship: {position: [1, 2, 3], rotation_deg: [0, 0, 90],
         motion: {harmonic: {amplitude: [1, 0, 2], rotation_amplitude_deg: [0, 3.5, 0], period: 10,
                             phase_deg: [90, 0, 0]}}}
  tug: {motion: {velocity: [2 kn, 0, 0], ramp: 5}}
  rig: {motion: {table: {rows: [[0, 0, 0, 0, 0, 0, 0], [5, 1, 0, 0, 0, 0, 90], [120, 2, 0, 0, 0, 0, 0]]}}}
volumes:
  deck: {mesh: box.obj, scale: 2, body: ship, active: top, normal_stiffness: {per_area: 1 MN/m3}, smoothing: 1 mm,
         relative_damping: 5 %, friction: {axial: 0.2, lateral: 0.4, mobilisation_length: 2 mm}}
  block: {mesh: box.obj, active: {box: [[-1, -1, -1], [3, 3, 0.5]]}, normal_stiffness: {per_point: 1 kN/m},
          friction: {axial: 0.2, shear_stiffness: 1e5}}
lines:
  "line 1":
    sections: [{type: chain, length: 10, element_length: 0.7}, {type: flat, length: 30, elements: 7, grading: 2}]
    end_a: {anchor: [0, 0, 0], direction: [3, 0, 4]}
    end_b: {body: ship, at: [5, 0, 0], direction: [0, 0, 2], clamped: true}
    start: {points: [[0, 0, 0], [0, 2, -18], [2, 7, 3]]}
    masses: [{at: end_b, mass: 1 t}]
    loads:
      - {per_length: [0, 1 kN/m, 0], from: 5, to: 20, ramp: 3}
      - {at: 20, moment: [0, 0, 2 kN m]}
contact: {lines: [line 1], volumes: [block]}
statics: {tolerance: 1e-9, max_iterations: 50}
dynamics: {duration: 2 min, step: 50 ms, max_step: 0.1, min_step: 1e-4, rho_infinity: 0.5, tolerance: 1e-6,
           error_tolerance: 1 mm}
output: {file: out/r.h5, every: 2, checkpoint_every: 10, format: [hdf5],
         histories: [{line: line 1, at: 7.5}, {line: line 1, at: end_b, name: top}]}
)");
  const model::LineType& f = c.line_type("flat");
  EXPECT_EQ(f.EI2, 1e6);
  EXPECT_EQ(f.EI3, 2e4);
  EXPECT_EQ(f.contact_diameter, 0.35);
  EXPECT_EQ(f.rotary_inertia, Vec3(1, 2, 3));
  EXPECT_EQ(f.stiffness_damping, 0.01);
  EXPECT_EQ(c.line_type("chain").mass_per_length, 100);
  EXPECT_EQ(c.line_type("chain").kind, model::LineKind::cable);
  const auto& h = std::get<model::HarmonicMotion>(c.bodies[0].motion);
  EXPECT_TRUE(near(c.bodies[0].rotation, {0, 0, std::numbers::pi / 2}));
  EXPECT_TRUE(near(h.rotation_amplitude, {0, 3.5 * std::numbers::pi / 180, 0}));
  EXPECT_TRUE(near(h.phase, {std::numbers::pi / 2, 0, 0}));
  EXPECT_NEAR(std::get<model::ConstantMotion>(c.bodies[1].motion).velocity.x(), 1.028889, 1e-6);
  const auto& t = std::get<model::TableMotion>(c.bodies[2].motion);
  EXPECT_EQ(t.time, (std::vector<double>{0, 5, 120}));
  EXPECT_TRUE(near(t.rotation[1], {0, 0, std::numbers::pi / 2}));
  EXPECT_EQ(c.volumes[0].active_part, "top");
  EXPECT_EQ(c.volumes[0].basis, model::StiffnessBasis::per_area);
  EXPECT_EQ(c.volumes[0].normal_stiffness, 1e6);
  EXPECT_EQ(c.volumes[0].relative_damping, 0.05);
  EXPECT_EQ(c.volumes[0].friction.lateral, 0.4);
  EXPECT_EQ(c.volumes[0].friction.mobilisation_length, 0.002);
  EXPECT_EQ(c.volumes[1].active_box->upper, Vec3(3, 3, 0.5));
  EXPECT_EQ(c.volumes[1].friction.lateral, 0.2);
  EXPECT_EQ(c.volumes[1].friction.shear_stiffness, 1e5);
  const model::Line& l = c.lines[0];
  EXPECT_EQ(l.name, "line 1");
  EXPECT_EQ(l.sections[0].elements, 15);
  EXPECT_EQ(l.sections[1].grading, 2);
  EXPECT_TRUE(near(l.end_a.direction.value(), {0.6, 0, 0.8}));
  EXPECT_TRUE(near(l.end_b.direction.value(), {0, 0, 1}));
  // Rotated by 90° about z, and moved by amplitude * sin(phase) = (1, 0, 0) at t = 0.
  EXPECT_LT((model::end_position(c, l.end_b) - Vec3(2, 7, 3)).norm(), 1e-12);
  EXPECT_EQ(l.points.size(), 3U);
  EXPECT_EQ(l.masses[0].at, 40);
  EXPECT_EQ(l.masses[0].mass, 1000);
  EXPECT_EQ(l.loads[0].from, 5);
  EXPECT_EQ(l.loads[0].to, 20);
  EXPECT_EQ(l.loads[0].ramp, 3);
  EXPECT_EQ(l.point_loads[0].moment, Vec3(0, 0, 2000));
  EXPECT_FALSE(c.contact.all_lines || c.contact.all_volumes);
  EXPECT_EQ(c.contact.volumes, std::vector<std::string>{"block"});
  EXPECT_EQ(c.dynamics.duration, 120);
  EXPECT_EQ(c.dynamics.step, 0.05);
  EXPECT_EQ(c.dynamics.error_tolerance, 0.001);
  EXPECT_EQ(c.output.file, (fs::path(c.directory) / "out/r.h5").string());
  EXPECT_FALSE(c.output.xdmf);
  EXPECT_EQ(c.output.checkpoint_every, 10);
  EXPECT_EQ(c.output.histories[0].name, "line 1@7.5");
  EXPECT_EQ(c.output.histories[1].name, "top");
  EXPECT_EQ(c.output.histories[1].at, 40);
}

// The longest element is at most the requested length, and one element fewer would exceed it.
TEST(CaseReader, ElementLength) {
  for (const double h : {0.3, 1.0, 7.0, 50.0})
    for (const double g : {0.2, 1.0, 5.0}) {
      const Case c =
          read_line("sections: [{type: chain, length: 50, element_length: " + std::to_string(h) +
                    ", grading: " + std::to_string(g) + "}], end_a: {anchor: [0, 0, 0]}, end_b: free");
      const auto longest = [&](int n) {
        double sum = 0, most = 0;
        for (int i = 0; i < n; ++i) {
          const double x = n > 1 ? std::pow(g, static_cast<double>(i) / (n - 1)) : 1;
          sum += x;
          most = std::max(most, x);
        }
        return 50 * most / sum;
      };
      const int n = c.lines[0].sections[0].elements;
      EXPECT_LE(longest(n), h * (1 + 1e-8)) << h << " " << g;
      EXPECT_TRUE(n == 1 || longest(n - 1) > h) << h << " " << g;
    }
}

TEST(CaseReader, TautLineMayBeALittleShort) {
  const auto line = [](const char* length) {
    return std::string("sections: [{type: chain, length: ") + length +
           ", elements: 5}], end_a: {anchor: [0, 0, 0]}, end_b: {anchor: [100, 0, 0]}";
  };
  // No metal has so little EA for its diameter: 50 % strain is allowed.
  EXPECT_NO_THROW(read_line(line("99")));
  EXPECT_NO_THROW(read_line(line("67")));
  EXPECT_THROW(read_line(line("66.5")), InputError);
}

TEST(CaseReader, MotionTableFromAFile) {
  const fs::path folder = fs::path(testing::TempDir()) / "hawser_table";
  fs::create_directories(folder);
  std::ofstream(folder / "surge.txt") << "# t x y z\n0 0 0 0\n\n1.5, 2, 0, -1  # up\n";
  const Case c =
      io::read_case_text(std::string(kTypes) +
                             "bodies: {b: {motion: {table: {file: surge.txt}, ramp: 2}}}\n"
                             "lines: {a: {sections: [{type: hose, length: 10, elements: 5}], end_a: free, "
                             "end_b: {body: b, at: [0, 0, 0]}}}\n",
                         (folder / "x.yaml").string());
  const auto& t = std::get<model::TableMotion>(c.bodies[0].motion);
  ASSERT_EQ(t.time.size(), 2U);
  EXPECT_EQ(t.offset[1], Vec3(2, 0, -1));
  EXPECT_TRUE(t.rotation.empty());
  EXPECT_EQ(c.bodies[0].ramp, 2);
}

TEST(CaseSummary, CountsUnknownsOfMixedLines) {
  const Case c = read_line(
      "sections: [{type: chain, length: 10, elements: 4}, {type: hose, length: 20, elements: 3}, "
      "{type: chain, length: 10, elements: 2}], end_a: {anchor: [0, 0, 0]}, end_b: free, masses: [{at: 0, "
      "mass: 5}]");
  const model::LineSize z = model::size_of(c, c.lines[0]);
  EXPECT_EQ(z.elements, 9);
  EXPECT_EQ(z.nodes, 10);
  EXPECT_EQ(z.unknowns, 3 * 10 + 3 * 4);  // the four nodes of the hose have rotations
  EXPECT_EQ(z.mass, 10 * 100 + 20 * 50 + 10 * 100 + 5);
  EXPECT_EQ(z.length, 40);
}

TEST(CaseReader, ContactLaws) {
  const Case c = read(std::string(kTypes) + R"(volumes:
  deck: {shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}},
         normal_stiffness: {table: [[0.001, 100], [0.02, 5e3]], per: area},
         friction: {axial: 0.5, lateral: 0.7, kinetic: {axial: 0.3, lateral: 0.4}, blend_speed: 0.01,
                    mobilisation_length: {axial: 5 mm, lateral: 0.02}, return: associated, stick: michalopoulos}}
  wall: {shape: {plane: {point: [0, 0, 0], normal: [1, 0, 0]}}, smoothing: 0,
         normal_stiffness: {allowed_penetration: 4 mm}, friction: {axial: 0.5, kinetic: 0.3, blend_speed: 1}}
lines:
  a: {sections: [{type: hose, length: 10, elements: 2}], end_a: {anchor: [0, 0, 0]}, end_b: free}
)");
  const model::Volume& deck = c.volumes[0];
  const model::Volume& wall = c.volumes[1];
  EXPECT_EQ(deck.basis, model::StiffnessBasis::per_area);
  ASSERT_TRUE(deck.force_table);
  EXPECT_NEAR(deck.force_table->at(0.001).force, 100, 1e-9);
  EXPECT_EQ(deck.normal_stiffness, deck.force_table->largest_slope());
  const model::Friction& f = deck.friction;
  EXPECT_EQ(f.axial, 0.5);
  EXPECT_EQ(f.lateral, 0.7);
  EXPECT_EQ(f.axial_kinetic, 0.3);
  EXPECT_EQ(f.lateral_kinetic, 0.4);
  EXPECT_EQ(f.blend_speed, 0.01);
  EXPECT_EQ(f.mobilisation_length, 0.005);
  EXPECT_EQ(f.lateral_mobilisation_length, 0.02);
  EXPECT_EQ(f.return_rule, FrictionReturn::associated);
  EXPECT_EQ(f.spring, FrictionSpring::michalopoulos);
  EXPECT_EQ(wall.basis, model::StiffnessBasis::automatic);
  EXPECT_EQ(wall.allowed_penetration, 0.004);
  EXPECT_EQ(wall.smoothing, 0);
  EXPECT_EQ(wall.friction.lateral, 0.5);
  EXPECT_EQ(wall.friction.lateral_kinetic, 0.3);
  EXPECT_EQ(wall.friction.return_rule, FrictionReturn::radial);
  const std::string s = model::summary(c);
  EXPECT_NE(s.find("force by a table of 2 rows up to 0.02 m"), std::string::npos) << s;
  EXPECT_NE(s.find("friction 0.5 along, 0.7 across at rest, 0.3 and 0.4 sliding"), std::string::npos) << s;
}

TEST(CaseReader, PairsOfLinesTakeMissingKeysFromAll) {
  const Case c = read(std::string(kTypes) + R"(lines:
  a: {sections: [{type: hose, length: 10, elements: 2}], end_a: {anchor: [0, 0, 0]}, end_b: {anchor: [9.9, 0, 0]}}
  b: {sections: [{type: hose, length: 10, elements: 2}], end_a: {anchor: [0, 5, 0]}, end_b: {anchor: [9.9, 5, 0]}}
contact:
  between_lines:
    normal_stiffness: {per_length: 5.0e6}
    friction: 0.3
    mobilisation_length: 0.02
    smoothing: 0.001
    relative_damping: 0.1
    pairs:
      - {lines: [a, b], friction: 0}
      - {lines: [a, a], normal_stiffness: auto, relative_damping: 0.2}
      - {lines: [b, b], normal_stiffness: {per_area: 1.0e8}, smoothing: 0.002, mobilisation_length: 0.03}
)");
  const model::LinePairSettings& all = c.contact.between_lines.general;
  ASSERT_EQ(c.contact.between_lines.pairs.size(), 3U);
  const auto of = [&](size_t i) { return c.contact.between_lines.pairs[i].settings; };
  EXPECT_EQ(all.normal_stiffness, 5e6);
  EXPECT_EQ(of(0).basis, model::StiffnessBasis::per_length);
  EXPECT_EQ(of(0).normal_stiffness, 5e6);
  EXPECT_EQ(of(0).friction, 0);
  EXPECT_EQ(of(0).mobilisation_length, 0.02);
  EXPECT_EQ(of(0).smoothing, 0.001);
  EXPECT_EQ(of(0).relative_damping, 0.1);
  EXPECT_EQ(of(1).basis, model::StiffnessBasis::automatic);
  EXPECT_EQ(of(1).friction, 0.3);
  EXPECT_EQ(of(1).relative_damping, 0.2);
  EXPECT_EQ(of(2).basis, model::StiffnessBasis::per_area);
  EXPECT_EQ(of(2).normal_stiffness, 1e8);
  EXPECT_EQ(of(2).friction, 0.3);
  EXPECT_EQ(of(2).mobilisation_length, 0.03);
  EXPECT_EQ(of(2).smoothing, 0.002);
}

TEST(CaseReader, ClashesClearancesAndSigns) {
  const std::string text = std::string(kTypes) + R"(volumes:
  a: {mesh: box.obj, sign: tetrahedron}
  b: {mesh: corner.obj, sign: solid_angle}
  c: {mesh: open_box.obj, sign: winding, smooth: false}
  d: {mesh: box.obj, sign: pseudonormal}
  e: {mesh: box.obj}
lines:
  a: {sections: [{type: hose, length: 10, elements: 2}], end_a: {anchor: [0, 0, 0]}, end_b: {anchor: [9.9, 0, 0]}}
  b: {sections: [{type: hose, length: 10, elements: 2}], end_a: {anchor: [0, 5, 0]}, end_b: {anchor: [9.9, 5, 0]}}
)";
  const Case plain = read(text);
  using enum model::SignTest;
  const model::SignTest signs[] = {tetrahedra, solid_angle, winding, pseudonormal, automatic};
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(plain.volumes[i].sign, signs[i]);
    EXPECT_EQ(plain.volumes[i].smooth, i > 2);  // tests of points in polyhedra use the flat facets
  }
  EXPECT_TRUE(plain.output.clashes.enabled);
  EXPECT_EQ(plain.output.clashes.merge_gap, 0.1);
  EXPECT_EQ(plain.output.clashes.merge_length, 0);
  EXPECT_EQ(plain.output.clashes.rows, 20);
  const Case c = read(text + R"(output:
  clashes: {merge_gap: 50 ms, merge_length: 2, rows: 3}
  clearances:
    - {line: a, other_line: b}
    - {line: b, volume: e, name: keel}
)");
  EXPECT_EQ(c.output.clashes.merge_gap, 0.05);
  EXPECT_EQ(c.output.clashes.merge_length, 2);
  EXPECT_EQ(c.output.clashes.rows, 3);
  ASSERT_EQ(c.output.clearances.size(), 2U);
  EXPECT_EQ(c.output.clearances[0].name, "a to b");
  EXPECT_EQ(c.output.clearances[0].other_line, "b");
  EXPECT_EQ(c.output.clearances[1].name, "keel");
  EXPECT_EQ(c.output.clearances[1].volume, "e");
  EXPECT_FALSE(read(text + "output: {clashes: false}\n").output.clashes.enabled);
}

TEST(CaseSummary, OfTheReel) {
  const std::string s = model::summary(io::read_case(HAWSER_SOURCE_DIR "/cases/reel/reel.yaml"));
  for (const char* part : {"hose: 250 m, 250 elements, 251 nodes, 1506 unknowns", "weight 670.3 kN",
                           "drum: drum.stl, on reel", "friction 0.3", "dynamics of 325 s"})
    EXPECT_NE(s.find(part), std::string::npos) << part << "\n" << s;
}

}  // namespace
}  // namespace hawser::case_reader_test
