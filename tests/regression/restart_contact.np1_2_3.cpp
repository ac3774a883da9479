// Restarts of runs with contact between lines, in a slit that moves, with the models of contact at the nodes,
// between bodies, and with a step that is repeated because a wave ended a contact: equal within 1e-7 to one
// run.
#include "hawser/geometry/surface.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/run/simulation.hpp"
#include "regression/runs.hpp"
#include "support/shapes.hpp"

namespace hawser::runs::restart_contact {
namespace {

// A rope is drawn over a taut wire; both touch a roller, with friction.
const char* const kLines = R"(hawser: 1
line_types:
  wire: {outer_diameter: 0.1, mass_per_length: 30, EA: 1.0e7, EI: 1.0e4, GJ: 1.0e4, stiffness_damping: 0.005}
  rope: {outer_diameter: 0.1, mass_per_length: 30, EA: 1.0e7, EI: 5.0e2, GJ: 5.0e2, stiffness_damping: 0.005}
bodies:
  carriage: {motion: {velocity: [0, 0.5, 0], ramp: 0.3}}
volumes:
  roller: {shape: {cylinder: {from: [-2, 1, -0.36], to: [2, 1, -0.36], radius: 0.2}}, friction: 0.2,
           normal_stiffness: {per_length: 2.0e6}}
lines:
  wire:
    sections: [{type: wire, length: 7.98, elements: 12}]
    end_a: {anchor: [-4, 0, 0]}
    end_b: {anchor: [4, 0, 0]}
  rope:
    sections: [{type: rope, length: 8.1, elements: 17}]
    end_a: {body: carriage, at: [0, -4, 0.12]}
    end_b: {body: carriage, at: [0.2, 4, 0.12]}
    start: straight
contact:
  between_lines: {normal_stiffness: {per_length: 2.0e6}, friction: 0.3, relative_damping: 0.1}
dynamics: {duration: 1.6, step: auto, max_step: 0.02}
output: {every: 0.1, histories: [{line: rope, at: 4}]}
)";

// A bar falls on an inclined plane and slides. KIND: the contact model.
const char* const kModels = R"(hawser: 1
line_types:
  bar: {outer_diameter: 0.2, mass_per_length: 50, EA: 1.0e7, EI: 1.0e5, GJ: 1.0e5, stiffness_damping: 0.002}
volumes:
  ground: {shape: {plane: {point: [0, 0, 0], normal: [0.1, 0, 1]}}, normal_stiffness: {per_point: 1.0e6}, friction: 0.1}
lines:
  bar:
    sections: [{type: bar, length: 6, elements: 12}]
    end_a: free
    end_b: free
    start: {points: [[0, 0, 0.2], [5.99, 0, -0.36]]}
contact: {KIND}
statics: false
dynamics: {duration: 1, step: auto, max_step: 0.005}
output: {every: 0.1, histories: [{line: bar, at: 3}]}
)";

// A taut rope in a narrowing slit whose walls belong to one mesh; contact with each wall begins and ends.
const char* const kSlit = R"(hawser: 1
environment: {gravity: 0}
line_types:
  rope: {outer_diameter: 0.2, mass_per_length: 10, EA: 1.0e6, EI: 5.0e2, GJ: 5.0e2, stiffness_damping: 0.005}
bodies:
  ship:
    position: [0, 0.07, -0.73]
    motion: {harmonic: {amplitude: [0.01, 0.05, 0.29], period: 2.63, phase_deg: [0, 162, 178]}}
volumes:
  slit: {mesh: slit.obj, body: ship, friction: 0.2, smooth: false, relative_damping: 0.1,
         normal_stiffness: {per_length: 2.04e4}}
lines:
  rope:
    sections: [{type: rope, length: 8, elements: 6}]
    end_a: {anchor: [-4, 0, 0]}
    end_b: {anchor: [4, 0, 0]}
    start: straight
dynamics: {duration: 2.5, step: auto, max_step: 0.05}
output: {every: 0.125, histories: [{line: rope, at: 4}]}
)";

// A bar falls on its end and stands for 15.5 ms, until the wave reflected at its other end lifts it off;
// steps are a third of that.
const char* const kStanding = R"(hawser: 1
line_types:
  bar: {outer_diameter: 0.1, contact_diameter: 0.001, mass_per_length: 78.5, EA: 2.1e9, EI: 1.0e5, GJ: 1.0e5}
volumes:
  ground: {shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}, normal_stiffness: {per_point: 3.0e9},
           smoothing: 1.0e-8}
lines:
  bar:
    sections: [{type: bar, length: 40, elements: 80}]
    end_a: free
    end_b: free
    start: {points: [[0, 0, 0.0515], [0, 0, 40.0515]]}
contact: {method: nodes}
statics: false
dynamics: {duration: 0.165, step: 0.005}
output: {every: 0.055, histories: [{line: bar, at: 0}]}
)";

// A slit along x, open upwards.
void write_slit(const std::string& path) {
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const TriangleMesh m = test::prism_mesh(
      {{-1.5, -0.8}, {1.5, -0.8}, {1.5, 0.9}, {0.28, 0.9}, {0.02, 0}, {-0.02, 0}, {-0.28, 0.9}, {-1.5, 0.9}},
      {{0, 1, 4, 5}, {1, 2, 3, 4}, {0, 5, 6, 7}}, 10);
  std::ofstream out(path);
  for (const Vec3& v : m.vertices) out << "v " << v.z() - 5 << ' ' << v.x() << ' ' << v.y() << '\n';
  for (const auto& t : m.triangles) out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
}

void expect_same(const Results& whole, const Results& rest, double tolerance) {
  ASSERT_GT(rest.output_times.size(), 1u);
  EXPECT_EQ(tail(whole.output_times, rest.output_times), rest.output_times);
  EXPECT_LE(largest_difference(tail(whole.step_times, rest.step_times), rest.step_times), tolerance);
  for (const auto& [name, values] : whole.fields) {
    const auto& there = rest.fields.at(name);
    const auto here = tail(values, there);
    EXPECT_LE(largest_difference(here, there), tolerance * std::max(largest(here), 1.0)) << name;
  }
  for (const auto& [name, values] : whole.series)
    for (size_t c = 0; c < whole.columns.at(name); ++c) {
      const auto there = rest.column(name, c);
      const auto all = whole.column(name, c);
      const auto here = tail(all, there);
      // The last six columns of a body are differences of its forces; their tolerance is relative to those.
      const bool difference = (name == "slab" || name == "block") && c + 6 >= whole.columns.at(name);
      const double scale = name == "energy" || difference ? largest(values) : std::max(largest(all), 1.0);
      // The work of the supports is restored as one number, so sums over the ranks have another round-off.
      const double within = name == "energy" ? std::max(tolerance, 1e-14) : tolerance;
      EXPECT_LE(largest_difference(here, there), within * scale) << name << ' ' << c;
    }
  expect_same_clashes(whole, rest, tolerance);
  ASSERT_EQ(whole.summary.size(), rest.summary.size());
  EXPECT_LE(largest_difference(whole.summary, rest.summary), tolerance * largest(whole.summary));
}

// A slab with edges and a bar slides on a block, sticks and rotates; both bodies are free, on different ranks
// if there are several.
const char* const kBodies = R"(hawser: 1
environment: {gravity: 0}
bodies:
  block: {position: [0, 0, 0], floating: {mass: 900, inertia: [1e3, 1e3, 1e3], loads: [{force: [0, 0, 3000]}]}}
  slab:
    position: [-0.5, 0, 0.60045]
    floating: {mass: 300, inertia: [26, 58, 68], velocity: [0.3, 0.1, 0], loads: [{force: [0, 0, -3000]}]}
volumes:
  block: {shape: {box: {centre: [0, 0, 0], size: [6, 2, 1]}}, body: block, normal_stiffness: {per_length: 1.0e7}, friction: 0.3}
  slab: {shape: {box: {centre: [0, 0, 0], size: [1, 0.6, 0.2]}}, body: slab, normal_stiffness: {per_point: 1.0e6}, friction: 0.3, relative_damping: 0.1}
  rail: {shape: {capsule: {from: [-0.4, 0, 0.05], to: [0.4, 0, 0.05], radius: 0.15}}, body: slab, normal_stiffness: {per_length: 1.0e6}, friction: 0.3, relative_damping: 0.1}
statics: false
dynamics: {duration: 0.25, step: 0.0005}
output: {every: 0.0625, histories: [{body: slab, name: slab}, {body: block, name: block}]}
)";

// First output time at or after `after` [s] with this force; 0: none.
double touches_at(const Results& r, const char* force, double after) {
  const auto& f = r.fields.at(force);
  const size_t row = f.size() / r.output_times.size();
  for (size_t k = 0; k < r.output_times.size(); ++k)
    for (size_t i = 0; i < row; ++i)
      if (r.output_times[k] >= after && f[row * k + i] != 0) return r.output_times[k];
  return 0;
}

// Tolerance between a restarted and an uninterrupted run. The matrix couples all nodes that have been near
// each other so far, so the order of elimination differs after a restart.
constexpr double kSame = 1e-7;

// Restarts from the first output with contact at or after `after` [s]; `other_ranks` is the tolerance of a
// restart on one rank.
void compare(const std::string& name, const std::string& text, const Edits& edits, double after,
             const char* force, double other_ranks) {
  const std::string path = folder("restart_" + name);
  const std::string input = path + "/case.yaml";
  write_case(input, text, edits);
  run_on_all({input, path + "/whole.h5"});
  double half = 0;
  if (rank_of(MPI_COMM_WORLD) == 0) half = touches_at(read(path + "/whole.h5"), force, after);
  MPI_Bcast(&half, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  ASSERT_GT(half, 0);
  run_on_all({input, path + "/half.h5", "", half});
  run_on_all({input, path + "/rest.h5", path + "/half.h5"});
  run_on_one({input, path + "/fewer.h5", path + "/half.h5"});
  run_on_all({input, path + "/half.h5", path + "/half.h5"});
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  const Results whole = read(path + "/whole.h5");
  const Results rest = read(path + "/rest.h5");
  std::printf("%s: stopped at %.1f s of %.1f s\n", name.c_str(), half, whole.output_times.back());
  EXPECT_EQ(rest.output_times.front(), half);
  expect_same(whole, rest, kSame);
  const Results on = read(path + "/half.h5");
  EXPECT_EQ(on.output_times.size(), whole.output_times.size());
  expect_same(whole, on, kSame);
  expect_same(whole, read(path + "/fewer.h5"), other_ranks);
}

TEST(RestartContact, BodiesWithFriction) {
  const std::string path = folder("restart_bodies");
  const std::string input = path + "/case.yaml";
  write_case(input, kBodies, {});
  run_on_all({input, path + "/whole.h5"});
  for (const double half : {0.0625, 0.1875}) {
    run_on_all({input, path + "/half.h5", "", half});
    run_on_all({input, path + "/rest.h5", path + "/half.h5"});
    run_on_one({input, path + "/fewer.h5", path + "/half.h5"});
    if (rank_of(MPI_COMM_WORLD) > 0) continue;
    SCOPED_TRACE("stopped at " + std::to_string(half) + " s");
    for (const char* rest : {"/rest.h5", "/fewer.h5"})
      expect_same(read(path + "/whole.h5"), read(path + rest), 1e-9);
  }
}

// Stopped with one wall near, with both near, and while the second comes near.
TEST(RestartContact, InASlit) {
  const std::string path = folder("restart_slit");
  const std::string input = path + "/case.yaml";
  write_slit(path + "/slit.obj");
  write_case(input, kSlit, {});
  run_on_all({input, path + "/whole.h5"});
  for (const double half : {0.5, 1.5, 1.75, 2.125}) {
    run_on_all({input, path + "/half.h5", "", half});
    run_on_all({input, path + "/rest.h5", path + "/half.h5"});
    if (rank_of(MPI_COMM_WORLD) > 0) continue;
    SCOPED_TRACE("stopped at " + std::to_string(half) + " s");
    expect_same(read(path + "/whole.h5"), read(path + "/rest.h5"), kSame);
  }
  if (rank_of(MPI_COMM_WORLD) > 0) return;
  EXPECT_GT(touches_at(read(path + "/whole.h5"), "contact_force", 1), 0);
}

TEST(RestartContact, LinesThatTouch) { compare("lines", kLines, {}, 0.5, "line_contact_force", 1e-7); }

TEST(RestartContact, Gap) { compare("gap", kModels, {{"KIND", "method: gap"}}, 0.1, "contact_force", 1e-7); }

// Stopped while the bar stands: the time of separation follows from the checkpoint, and the step is repeated.
TEST(RestartContact, Parting) {
  if (size_of(MPI_COMM_WORLD) > 2 && !std::getenv("HAWSER_FULL")) GTEST_SKIP() << "long; set HAWSER_FULL";
  compare("parting", kStanding, {}, 0.1, "contact_force", 1e-7);
  run::Simulation s(MPI_COMM_WORLD, io::read_case(folder("restart_parting") + "/case.yaml"),
                    {std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ())});
  Dynamics& d = s.dynamics();
  d.start(s.state());
  int again = 0;
  d.run(
      0.13, [](double t) { return t < 0.1099 ? 0.11 : 1; },
      [&](const StepInfo& i) {
        if (i.time > 0.1101) again += i.rejected;
        return true;
      });
  EXPECT_GT(again, 0);
}

}  // namespace
}  // namespace hawser::runs::restart_contact
