// A hose dragged over the stern of KVLCC2 and into the slit between rudder and hull, which are volumes of
// their own (parts of one mesh), so that both walls of the slit bear it. As one volume the run stops: of two
// walls that are equally near only one is felt, and none of the two forces is in balance.
#include <fstream>

#include "hawser/app/volumes.hpp"
#include "hawser/io/case_reader.hpp"
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
  hull: {mesh: kvlcc2.obj, scale: 58, friction: 0.2, active: ship_ship_hull}
  rudder: {mesh: kvlcc2.obj, scale: 58, friction: 0.2, active: ship_ship_rudder}
lines:
  hose:
    sections: [{type: hose, length: 107, elements: 107}]
    end_a: {body: tugs, at: [0, -33, 5]}
    end_b: {body: tugs, at: [0, 33, 5]}
    loads: [{per_length: [0, 0, 1500]}]
    start: {points: [[95, -33, 5], [95, -29.5, -17.5], [95, -26, -21.3], [95, 26, -21.3], [95, 29.5, -17.5], [95, 33, 5]]}
dynamics: {duration: 36}
)";

TEST(HullSlit, BothWallsBearTheHose) {
  const std::string folder = ::testing::TempDir() + "hawser_hulls";
  if (testing::unpacked_hull("kvlcc2.obj", folder).empty())
    GTEST_SKIP() << "the hull meshes are not beside the sources";
  const std::string path = folder + "/slit.yaml";
  std::ofstream(path) << kCase;
  const model::Case c = io::read_case(path);
  std::vector<std::shared_ptr<const Surface>> surfaces;
  for (const app::LoadedVolume& v : app::load_volumes(c)) surfaces.push_back(v.surface);
  Simulation s(PETSC_COMM_WORLD, c, surfaces);
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  int steps = 0;
  double both = 0;  // s, in which it presses on both near the middle
  d.run(
      36, [](double t) { return t + 1000; },
      [&](const StepInfo& i) {
        Touches touches;
        s.contact()->touches(touches);
        double force[2] = {0, 0};
        for (const Touch& t : touches)
          if (t.from > 53 && t.to < 58) force[t.volume] += t.force;
        if (std::min(force[0], force[1]) > 1e3) both += i.h;
        return ++steps < 20000;
      });
  const double deep = s.contact()->largest_penetration().depth;
  std::printf("hose in the slit: %d steps, %.1f s on both walls, %.1f mm deep\n", steps, both, 1e3 * deep);
  EXPECT_LT(steps, 20000);
  EXPECT_GT(both, 1);
  EXPECT_LT(deep, 0.15 * 0.249);
}

}  // namespace
}  // namespace hawser::test
