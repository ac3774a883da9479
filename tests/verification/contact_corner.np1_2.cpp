// Lines in the corner of one mesh against the same walls as separate volumes: positions, contact and friction
// forces in statics and in motion, on one and two ranks.
#include <fstream>

#include "hawser/io/case_reader.hpp"
#include "verification/contact_rig.hpp"

namespace hawser::test::contact_corner {
namespace {

using test::append;

double sum(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return x;
}
double largest(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
  return x;
}

model::Case read(const std::string& name, const std::string& text) {
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  const std::string path = ::testing::TempDir() + name + std::to_string(rank) + ".yaml";
  std::ofstream(path) << text;
  return io::read_case(path);
}

using Surfaces = std::vector<std::shared_ptr<const Surface>>;

std::shared_ptr<const Surface> mesh(TriangleMesh m, bool smooth = false) {
  MeshSurfaceOptions o;
  o.smooth = smooth;
  return std::make_shared<MeshSurface>(std::move(m), std::vector<bool>{}, o);
}

struct Rest {
  std::vector<double> x, force, friction;  // of this rank's nodes
  Vec3 total = Vec3::Zero();               // N, on the line, sum over the ranks
  int steps = 0, iterations = 0, touching = 0;
  double deepest = 0;  // m
};

void measure(Simulation& s, const Kinematics& state, Rest& r) {
  r.x.clear();
  for (const Vec3& x : state.x.first(static_cast<size_t>(s.local().owned)))
    r.x.insert(r.x.end(), x.begin(), x.end());
  NodeField force(s, "contact_force");
  NodeField friction(s, "friction_force");
  r.force = force.at(state);
  r.friction = friction.at(state);
  r.total.setZero();
  for (size_t i = 0; i < r.force.size(); ++i) r.total[static_cast<int>(i % 3)] += r.force[i];
  for (int c = 0; c < 3; ++c) r.total[c] = sum(r.total[c]);
  r.touching = s.line_volume_contact()->active_count();
  r.deepest = largest(s.line_volume_contact()->largest_penetration().depth);
}

// At rest, and at the end of the run.
std::array<Rest, 2> run(const model::Case& c, const Surfaces& surfaces) {
  std::array<Rest, 2> out;
  Simulation s(PETSC_COMM_WORLD, c, surfaces);
  if (c.statics.enabled) s.solve_statics();
  measure(s, s.state().at_rest(), out[0]);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  d.run(
      c.dynamics.duration, [](double t) { return t + 1000; },
      [&](const StepInfo& i) {
        out[1].iterations += i.iterations;
        return ++out[1].steps < 5000;
      });
  measure(s, d.committed_kinematics(), out[1]);
  return out;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = a.size() == b.size() ? 0 : 1e300;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return largest(most);
}
double size(const std::vector<double>& a) {
  double most = 0;
  for (const double x : a) most = std::max(most, std::abs(x));
  return largest(most);
}

// Equal within `part` of the largest force, and positions within `part` of a radius of 0.1 m.
void expect_same(const Rest& a, const Rest& b, double part, const std::string& what) {
  std::printf(
      "%s: one mesh %d steps, %d iterations; volumes %d, %d; forces differ by %.1e, places by %.1e m\n",
      what.c_str(), a.steps, a.iterations, b.steps, b.iterations,
      difference(a.force, b.force) / size(b.force), difference(a.x, b.x));
  EXPECT_LT(difference(a.x, b.x), part * 0.1) << what;
  EXPECT_LT(difference(a.force, b.force), part * size(b.force)) << what;
  EXPECT_LT(difference(a.friction, b.friction), part * size(b.force)) << what;
  EXPECT_NEAR(a.deepest, b.deepest, part * 0.1) << what;
}

// A hose on a deck, pressed against a bulwark by a distributed load and drawn along both.
std::string on_deck(const std::string& method, const std::vector<std::string>& volumes) {
  std::string text = R"(hawser: 1
line_types:
  hose: {outer_diameter: 0.2, mass_per_length: 50, EA: 1.0e7, EI: 1.0e4, GJ: 1.0e4, stiffness_damping: 0.01}
bodies:
  tug: {motion: {velocity: [0.8, 0, 0], ramp: 0.3}}
volumes:
)";
  for (const std::string& v : volumes)
    text += "  " + v +
            ": {shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}, friction: 0.3, normal_stiffness: "
            "{per_length: 1e7}}\n";
  return text + R"(lines:
  hose:
    sections: [{type: hose, length: 10.1, elements: 26}]
    end_a: {body: tug, at: [0, 0.4, 0.4]}
    end_b: {body: tug, at: [10, 0.4, 0.4]}
    loads: [{per_length: [0, -350, 0]}]
    start: {points: [[0, 0.4, 0.4], [1.5, 0.13, 0.13], [8.5, 0.13, 0.13], [10, 0.4, 0.4]]}
contact: {method: )" +
         method + R"(}
dynamics: {duration: 1.2, step: 0.012, resolve_impacts: false}
)";
}

constexpr double kFrom = -5, kTo = 20;

// A prism along x with a polygon in (y, z) as its section.
TriangleMesh along_x(const std::vector<std::pair<double, double>>& polygon,
                     const std::vector<std::vector<int>>& pieces) {
  TriangleMesh m = test::prism_mesh(polygon, pieces, kTo - kFrom);
  for (Vec3& v : m.vertices) v = Vec3(v.z() + kFrom, v.x(), v.y());
  return m;
}

// Deck z = 0 and bulwark y = 0 as one mesh.
TriangleMesh deck_and_bulwark() {
  return along_x({{-5, -5}, {0, -5}, {3, -5}, {3, 0}, {0, 0}, {0, 1}, {-5, 1}, {-5, 0}},
                 {{0, 1, 4, 7}, {1, 2, 3, 4}, {7, 4, 5, 6}});
}

TEST(ContactCorner, DeckAndBulwark) {
  for (const std::string method : {"line", "nodes"}) {
    const auto one = run(read("corner_one", on_deck(method, {"ship"})), {mesh(deck_and_bulwark())});
    const auto two = run(read("corner_two", on_deck(method, {"deck", "bulwark"})),
                         {mesh(test::box_mesh(Vec3(kFrom, -5, -5), Vec3(kTo, 3, 0))),
                          mesh(test::box_mesh(Vec3(kFrom, -5, -5), Vec3(kTo, 0, 1)))});
    for (const size_t when : {size_t{0}, size_t{1}}) {
      const Rest& r = one[when];
      expect_same(r, two[when], 1e-6, method + (when ? ", drawn along" : ", at rest"));
      EXPECT_GT(r.total.y(), 1000) << "pressed onto the bulwark";
      EXPECT_GT(r.total.z(), 1000) << "pressed onto the deck";
      EXPECT_LT(r.deepest, 0.005);
    }
    EXPECT_LT(one[1].total.x(), -0.2 * (one[1].total.y() + one[1].total.z())) << "friction of both";
  }
}

// The hose lies on the deck and then slides against the bulwark.
TEST(ContactCorner, FromOneWallToTwo) {
  std::string text = on_deck("line", {"ship"});
  const auto put = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos);
    text.replace(text.find(from), from.size(), to);
  };
  // The hose is free and lies at an angle beside the bulwark, towards which the load presses it.
  put("length: 10.1", "length: 10");
  put("end_a: {body: tug, at: [0, 0.4, 0.4]}", "end_a: free");
  put("end_b: {body: tug, at: [10, 0.4, 0.4]}", "end_b: free");
  put("[[0, 0.4, 0.4], [1.5, 0.13, 0.13], [8.5, 0.13, 0.13], [10, 0.4, 0.4]]",
      "[[0, 0.2, 0.11], [9.999, 0.34, 0.11]]");
  put("dynamics: {duration: 1.2, step: 0.012,", "statics: false\ndynamics: {duration: 0.45, step: 0.002,");
  const auto one = run(read("slides_one", text), {mesh(deck_and_bulwark())});
  put("  ship:",
      "  bulwark: {shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}, friction: 0.3, normal_stiffness: "
      "{per_length: 1e7}}\n  ship:");
  const auto two =
      run(read("slides_two", text), {mesh(test::box_mesh(Vec3(kFrom, -5, -5), Vec3(kTo, 0, 1))),
                                     mesh(test::box_mesh(Vec3(kFrom, -5, -5), Vec3(kTo, 3, 0)))});
  EXPECT_EQ(one[0].touching, 0) << "clear at first";
  EXPECT_GT(one[1].total.y(), 300);
  expect_same(one[1], two[1], 1e-6, "from one wall to two");
}

// A line half a turn round a drum is pressed against its flange; the drum rotates under it.
TEST(ContactCorner, DrumAndFlange) {
  const auto text = [](const std::vector<std::string>& volumes) {
    std::string t = R"(hawser: 1
environment: {gravity: 0}
line_types:
  hose: {outer_diameter: 0.2, mass_per_length: 50, EA: 1.0e7, EI: 2.0e3, GJ: 2.0e3, stiffness_damping: 0.01}
bodies:
  reel: {motion: {rotation: {axis: [0, 0, 1], rate: 0.2}, ramp: 0.3}}
volumes:
)";
    for (const std::string& v : volumes)
      t += "  " + v +
           ": {body: reel, shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}, friction: 0.3, "
           "normal_stiffness: {per_length: 2.0e6}}\n";
    t += R"(lines:
  hose:
    sections: [{type: hose, length: 9.42, elements: 48}]
    end_a: {anchor: [1.1, -3, -0.9]}
    end_b: {anchor: [-1.1, -3, -0.9]}
    loads: [{per_length: [0, 0, -200]}]
    start: {points: [[1.1, -3, -0.9])";
    for (int i = 0; i <= 24; ++i) {
      const double a = M_PI * i / 24;
      t += ", [" + std::to_string(1.1 * std::cos(a)) + ", " + std::to_string(1.1 * std::sin(a)) + ", -0.9]";
    }
    return t + ", [-1.1, -3, -0.9]]}\ndynamics: {duration: 1, step: 0.01, resolve_impacts: false}\n";
  };
  const TriangleMesh drum = test::flanged_drum_mesh(24, 1, 2, 1.6, 0.1);
  const auto disc = [](double from) {
    return mesh(test::revolution_mesh({{0, from}, {1.6, from}, {1.6, from + 0.1}, {0, from + 0.1}}, 24));
  };
  const auto one = run(read("drum_one", text({"reel"})), {mesh(drum)});
  const auto two = run(read("drum_two", text({"drum", "low", "high"})),
                       {mesh(test::drum_mesh(24, 1, 2)), disc(-1.1), disc(1)});
  for (const size_t when : {size_t{0}, size_t{1}}) {
    expect_same(one[when], two[when], 1e-6, when ? "drum that turns" : "drum at rest");
    EXPECT_GT(one[when].total.z(), 300) << "pressed onto the flange";
    EXPECT_GT(one[when].total.y(), 2000) << "pressed onto the drum";
  }
}

}  // namespace
}  // namespace hawser::test::contact_corner
