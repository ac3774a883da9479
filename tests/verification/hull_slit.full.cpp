// A hose dragged over the stern of KVLCC2 into the slit between rudder and hull presses on both walls, as
// parts of one volume and as separate volumes; both models agree in the contact impulse.
#include <fstream>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "support/hulls.hpp"
#include "verification/contact_rig.hpp"

namespace hawser::test {
namespace {

constexpr char kCase[] = R"(hawser: 1
title: A hose in the slit over a rudder
line_types:
  hose: {outer_diameter: 0.498, mass_per_length: 120, EA: 6.178e7, EI: 1.961e5, GJ: 1.961e5, stiffness_damping: 0.01}
bodies:
  tugs: {position: [95, 0, 0], motion: {velocity: [2, 0, 0], ramp: 4}}
volumes:
VOLUMES
lines:
  hose:
    sections: [{type: hose, length: 107, elements: 107}]
    end_a: {body: tugs, at: [0, -33, 5]}
    end_b: {body: tugs, at: [0, 33, 5]}
    loads: [{per_length: [0, 0, 1500]}]
    start: {points: [[95, -33, 5], [95, -29.5, -17.5], [95, -26, -21.3], [95, 26, -21.3], [95, 29.5, -17.5], [95, 33, 5]]}
dynamics: {duration: 36}
)";

constexpr char kTwo[] = R"(  hull: {mesh: kvlcc2.obj, scale: 58, friction: 0.2, active: ship_ship_hull}
  rudder: {mesh: kvlcc2.obj, scale: 58, friction: 0.2, active: ship_ship_rudder})";
constexpr char kOne[] = "  ship: {mesh: kvlcc2.obj, scale: 58, friction: 0.2}";

struct Drag {
  int steps = 0;
  double both = 0, deep = 0;   // s with contact on both sides near the middle; m, penetration
  std::vector<double> weight;  // N, on hull and rudder at each whole second
};

void drag(const std::string& folder, const std::string& volumes, Drag& r) {
  const std::string path = folder + "/slit.yaml";
  std::string text = kCase;
  text.replace(text.find("VOLUMES"), 7, volumes);
  std::ofstream(path) << text;
  const model::Case c = io::read_case(path);
  std::vector<std::shared_ptr<const Surface>> surfaces;
  for (const run::LoadedVolume& v : run::load_volumes(c)) surfaces.push_back(v.surface);
  Simulation s(PETSC_COMM_WORLD, c, surfaces);
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  NodeField force(s, "contact_force");
  NodeField normal(s, "contact_normal_force");
  d.run(
      36, [](double t) { return t + 1000; },
      [&](const StepInfo& i) {
        // Contact on both walls: the sum of the forces' sizes exceeds the size of their resultant.
        const auto& f = force.at(d.committed_kinematics());
        const auto& n = normal.at(d.committed_kinematics());
        Vec3 left = Vec3::Zero();
        double sizes = 0;
        for (size_t k = 53; k <= 58; ++k) {
          left += Eigen::Map<const Vec3>(f.data() + 3 * k);
          sizes += n[k];
        }
        if (sizes - left.norm() > 2e3) r.both += i.h;
        while (i.time >= static_cast<double>(r.weight.size() + 1)) {
          double all = 0;
          for (const double x : n) all += x;
          r.weight.push_back(all);
        }
        return ++r.steps < 20000;
      });
  r.deep = s.line_volume_contact()->largest_penetration().depth;
  std::printf(
      "hose in the slit: %d steps, %.1f s between both walls, %.1f mm deep, pressed with %.1f kN at the "
      "end\n",
      r.steps, r.both, 1e3 * r.deep, 1e-3 * r.weight.back());
}

TEST(HullSlit, BothWallsBearTheHose) {
  const std::string folder = ::testing::TempDir() + "hawser_hulls";
  if (test::unpacked_hull("kvlcc2.obj", folder).empty())
    GTEST_SKIP() << "the hull meshes are not beside the sources";
  Drag one, two;
  drag(folder, kOne, one);
  drag(folder, kTwo, two);
  for (const Drag& r : {one, two}) {
    EXPECT_LT(r.steps, 20000);
    EXPECT_GT(r.both, 1);
    EXPECT_LT(r.deep, 0.15 * 0.249);
  }
  ASSERT_EQ(one.weight.size(), two.weight.size());
  // The steps of both runs differ, so forces are compared as sums over the run.
  double first = 0, second = 0;
  for (const double w : one.weight) first += w;
  for (const double w : two.weight) second += w;
  EXPECT_NEAR(first, second, 0.05 * second) << "N s, of the whole run";
}

}  // namespace
}  // namespace hawser::test
