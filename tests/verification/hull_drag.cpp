// A hose of 10 in is dragged along the side of a real tanker's hull, under its stern and under its bow,
// without nodes inside the hull. KVLCC2 at 320 m, 130 000 triangles as published, with open and non-manifold
// edges.
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "support/hulls.hpp"
#include "verification/contact_rig.hpp"

namespace hawser::test::hull_drag_test {
namespace {

constexpr double kRadius = 0.249;  // m, of the hose

// Counts the queries of contact to a surface and times every sixteenth (reading the clock costs more than
// some queries).
class CountedSurface final : public Surface {
  template <class Ask>
  auto timed(Ask&& ask) const {
    if (++asked_ % 16) return ask();
    const double start = cpu_seconds();
    auto answer = ask();
    seconds_ += cpu_seconds() - start;
    ++timed_;
    return answer;
  }

 public:
  explicit CountedSurface(std::shared_ptr<const Surface> s) : s_(std::move(s)) {}
  std::optional<SurfacePoint> query(const Vec3& y, double max_distance, int hint) const override {
    return timed([&] { return s_->query(y, max_distance, hint); });
  }
  Box bounds() const override { return s_->bounds(); }
  // Queries of facet groups count as well.
  void facet_groups(std::span<const Vec3> axis, double reach, FacetGroups& out) const override {
    timed([&] {
      s_->facet_groups(axis, reach, out);
      return 0;
    });
  }
  bool one_facet_group(std::span<const Vec3> axis, double reach) const override {
    return timed([&] { return s_->one_facet_group(axis, reach); });
  }
  std::optional<SurfacePoint> query_group(const FacetGroup& group, const Vec3& y, double max_distance,
                                          bool either_side) const override {
    return timed([&] { return s_->query_group(group, y, max_distance, either_side); });
  }
  long asked() const { return asked_; }
  double microseconds() const {  // less the time of reading the clock
    double clock = 0;
    for (int i = 0; i < 1000; ++i) clock -= cpu_seconds() - cpu_seconds();
    return timed_ ? 1e6 * (seconds_ / static_cast<double>(timed_) - clock / 1000) : 0;
  }

 private:
  std::shared_ptr<const Surface> s_;
  mutable long asked_ = 0, timed_ = 0;
  mutable double seconds_ = 0;
};

struct Drag {
  const char* name;
  const char* ends[2];  // m, in the frame of the tugs
  const char* more;     // of the line: loads, start
  double from;          // m, x of the tugs at the start
  double length;        // m
  double speed;         // m/s, along x
  double duration;      // s
};

struct Outcome {
  double deepest = 0;     // m, penetration
  int most_touching = 0;  // elements
  int nodes = 0;          // nodes compared, at all outputs
  int inside = 0;         // of these within the hull, by the reference
};

// x points aft: the bulb begins at -170 m, the rudder ends at 163 m, and the keel is at z = -20.8 m.
std::string case_of(const Drag& d, const std::string& hull) {
  return fmt::format(R"(hawser: 1
title: A hose dragged along a hull, {}
line_types:
  hose: {{outer_diameter: 0.498, mass_per_length: 120, EA: 6.178e7, EI: 1.961e5, GJ: 1.961e5, stiffness_damping: 0.01}}
bodies:
  tugs: {{position: [{}, 0, 0], motion: {{velocity: [{}, 0, 0], ramp: 4}}}}
volumes:
  hull: {{mesh: {}, scale: 58, friction: 0.2}}
lines:
  hose:
    sections: [{{type: hose, length: {}, elements: {}}}]
    end_a: {{body: tugs, at: {}}}
    end_b: {{body: tugs, at: {}}}
    {}
dynamics: {{duration: {}}}
)",
                     d.name, d.from, d.speed, hull, d.length, static_cast<int>(d.length), d.ends[0],
                     d.ends[1], d.more, d.duration);
}

Outcome drag(const Drag& d) {
  const std::string folder = ::testing::TempDir() + "hawser_hulls";
  const std::string hull = test::unpacked_hull("kvlcc2.obj", folder);
  const std::string path = folder + "/" + d.name + ".yaml";
  std::ofstream(path) << case_of(d, hull);
  const model::Case c = io::read_case(path);
  const std::vector<run::LoadedVolume> volumes = run::load_volumes(c);
  const auto counted = std::make_shared<CountedSurface>(volumes[0].surface);
  Simulation s(PETSC_COMM_WORLD, c, {counted});
  s.solve_statics();
  Dynamics& dynamics = s.dynamics();
  dynamics.start(s.state());
  Outcome out;
  long steps = 0, iterations = 0;
  const long before = counted->asked();
  const double cpu = cpu_seconds();
  std::vector<Vec3> places;  // of all nodes, every half second
  dynamics.run(
      d.duration, [](double t) { return t + 1000; },
      [&](const StepInfo& i) {
        ++steps;
        iterations += i.iterations;
        out.most_touching = std::max(out.most_touching, s.line_volume_contact()->active_count());
        if (std::floor(2 * i.time) > std::floor(2 * (i.time - i.h)) || i.time >= d.duration)
          for (const Vec3& x : dynamics.committed_kinematics().x) places.push_back(x);
        return true;
      });
  const double seconds = cpu_seconds() - cpu;
  const long asked = counted->asked() - before;
  out.deepest = s.line_volume_contact()->largest_penetration().depth;
  const MeshView& mesh = *volumes[0].facets;
  const auto boundary = test::boundary_of(mesh);
  const Box box = counted->bounds();
  const Vec3 up(0.0031, 0.0017, 1);
  for (const Vec3& x : places) {
    if (distance(box, x) > 0) continue;
    ++out.nodes;
    out.inside += test::WindingAlong(mesh, x, up.normalized()).at(0, mesh, boundary) > 0.5;
  }
  const double share = 1e-6 * counted->microseconds() * static_cast<double>(asked) / seconds;
  std::printf(
      "%s: %ld steps, %.1f iterations a step, %.2f CPU s a simulated second; hull asked %ld times, %.2f us "
      "each, "
      "%.0f %% of the time; up to %d elements touch, penetration %.1f mm; %d of %d nodes inside\n",
      d.name, steps, static_cast<double>(iterations) / static_cast<double>(steps), seconds / d.duration,
      asked, counted->microseconds(), 100 * share, out.most_touching, 1e3 * out.deepest, out.inside,
      out.nodes);
  return out;
}

void expect_outside(const Drag& d, int touching) {
  if (test::unpacked_hull("kvlcc2.obj", ::testing::TempDir() + "hawser_hulls").empty())
    GTEST_SKIP() << "the hull meshes are not beside the sources";
  const Outcome o = drag(d);
  EXPECT_LT(o.deepest, 0.1 * kRadius);
  EXPECT_GE(o.most_touching, touching);
  EXPECT_GT(o.nodes, 500);
  EXPECT_EQ(o.inside, 0);
}

// A lateral load presses the hose against the flat side and onto the bow's shoulder.
TEST(HullDrag, AlongTheSide) {
  expect_outside(
      {"side", {"[-25, 31.5, -2]", "[25, 31.5, -2]"}, "loads: [{per_length: [0, -900, 0]}]", -60, 54, -2, 30},
      20);
}

// Buoyancy presses a sling against the bottom of the parallel body; it is dragged aft until it leaves the
// narrowing hull.
TEST(HullDrag, UnderTheStern) {
  if (!std::getenv("HAWSER_FULL")) GTEST_SKIP() << "long; set HAWSER_FULL";
  expect_outside({"stern",
                  {"[0, -33, 5]", "[0, 33, 5]"},
                  "loads: [{per_length: [0, 0, 1500]}]\n    start: {points: [[95, -33, 5], [95, -29.5, "
                  "-17.5], [95, -26, "
                  "-21.3], [95, 26, -21.3], [95, 29.5, -17.5], [95, 33, 5]]}",
                  95,
                  107,
                  2,
                  30},
                 5);
}

// The hose hangs ahead of the bow and is dragged onto the bulb and under it.
TEST(HullDrag, UnderTheBow) {
  expect_outside({"bow", {"[0, -32, 8]", "[0, 32, 8]"}, "", -178, 84, 2, 20}, 5);
}

}  // namespace
}  // namespace hawser::test::hull_drag_test
