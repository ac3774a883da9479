// Lines thrown at a plate thinner than the lines, so fast that one step may take them to the other side: they
// do not pass it, whatever the step.
#include <random>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/primitives.hpp"
#include "support/rig.hpp"
#include "support/shapes.hpp"

namespace hawser::test::contact_thin_test {
namespace {

constexpr double kRadius = 0.05, kHalf = 0.025;  // m, of the line; half the thickness
// The plate, narrow along the line: [from, to] x [-3, 3] x [-kHalf, kHalf].
struct Plate {
  double from = 0, to = 0;
  Vec3 low() const { return {from, -3, -kHalf}; }
  Vec3 high() const { return {to, 3, kHalf}; }
};

struct Throw {
  bool cable = false, of_mesh = false, nodes = false, plate_moves = false, resolve = true;
  double speed = 1, step = 0;  // m/s; s, 0: automatic
};

struct Course {
  int passed = 0, steps = 0, rejected = 0;
  double depth = 0;  // m
  bool met = false;
};

// Whether the path a -> b enters the plate and leaves it on the other side.
bool through(const Plate& plate, const Vec3& a, const Vec3& b) {
  if (a.z() * b.z() >= 0 || std::min(std::abs(a.z()), std::abs(b.z())) < kHalf) return false;
  const Vec3 at = a + (b - a) * (a.z() / (a.z() - b.z()));
  return at.x() > plate.from && at.x() < plate.to && std::abs(at.y()) < 3;
}

Course throw_line(const Throw& t, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  model::LineType type = t.cable ? cable_type(1e7, 10) : beam_type(1e7, 1e4, 1e4, 10);
  type.contact_diameter = type.outer_diameter = 2 * kRadius;
  type.rotary_inertia = Vec3::Constant(0.02);
  model::Case c = one_line(type, 10, 2, {}, {});
  c.lines[0].start = model::Start::points;
  const double gap = kRadius + kHalf + 0.01 + unit(random);
  c.lines[0].points = {Vec3(-5, 0, gap), Vec3(5, 0, gap)};
  c.statics.enabled = false;
  c.dynamics.enabled = true;
  c.dynamics.step = t.step;
  c.dynamics.max_step = 0.1;
  c.dynamics.resolve_impacts = t.resolve;
  // Place along the line between the ends and the middle of an element; at a node for contact at the nodes.
  const double at = t.nodes ? 0 : 0.4 + 1.6 * unit(random);
  const Plate plate{at - 0.15, at + 0.15};
  model::Volume v;
  v.name = "plate";
  v.basis = model::StiffnessBasis::per_length;
  v.normal_stiffness = t.nodes ? 1e9 : 1e10;
  if (t.plate_moves) {
    model::Body body;
    body.name = "plate";
    body.motion = model::ConstantMotion{Vec3(0, 0, t.speed)};
    c.bodies.push_back(body);
    v.body = "plate";
  }
  c.volumes.push_back(v);
  if (t.nodes) c.contact.method = model::ContactMethod::nodes;
  std::shared_ptr<const Surface> surface;
  if (t.of_mesh) {
    surface = std::make_shared<MeshSurface>(box_mesh(plate.low(), plate.high()));
  } else {
    BoxShape box;
    box.centre = 0.5 * (plate.low() + plate.high());
    box.size = plate.high() - plate.low();
    surface = std::make_shared<BoxSurface>(box);
  }
  Simulation s(PETSC_COMM_SELF, c, {surface});
  for (Vec3& x : s.state().v) x = Vec3(0, 0, t.plate_moves ? 0 : -t.speed);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  Course out;
  // The line's axis relative to the plate.
  const auto axis = [&] {
    const Kinematics k = d.committed_kinematics();
    const double rise = t.plate_moves ? t.speed * k.time : 0;
    std::vector<Vec3> p;
    for (const LocalElement& e : s.local().elements) {
      AxisEnds ends;
      const size_t i = static_cast<size_t>(e.first);
      const size_t j = static_cast<size_t>(e.second);
      ends.beam = !t.cable;
      ends.length = 5;
      ends.x1 = k.x[i];
      ends.x2 = k.x[j];
      ends.q1 = k.q[i];
      ends.q2 = k.q[j];
      const AxisShape shape(ends);
      for (int n = 0; n <= 100; ++n) p.push_back(shape.point(0.01 * n) - rise * Vec3::UnitZ());
    }
    return p;
  };
  std::vector<Vec3> last = axis();
  d.run((gap + 0.3) / t.speed, [](double) { return 1e300; },
        [&](const StepInfo& info) {
          const std::vector<Vec3> now = axis();
          for (size_t n = 0; n < now.size(); ++n)
            if (!t.nodes || n == 100 || n == 101) out.passed += through(plate, last[n], now[n]);
          last = now;
          out.met |= s.line_volume_contact()->active_count() > 0;
          ++out.steps;
          out.rejected += info.rejected;
          return true;
        });
  out.depth = s.line_volume_contact()->largest_penetration().depth;
  return out;
}

constexpr double kSpeeds[] = {1, 2, 5, 10, 20, 50};

void expect_none_passes(Throw t, const char* what, unsigned count) {
  for (const double step : {0.0, 0.02, 0.1}) {
    Course sum;
    int met = 0, all = 0;
    for (const double speed : kSpeeds)
      for (unsigned seed = 0; seed < count; ++seed) {
        t.speed = speed;
        t.step = step;
        const Course o = throw_line(t, 100 * seed + static_cast<unsigned>(speed));
        met += o.met;
        ++all;
        sum.passed += o.passed > 0;
        sum.steps += o.steps;
        sum.rejected += o.rejected;
        sum.depth = std::max(sum.depth, o.depth);
      }
    printf("  %s, step %g: %d of %d met, %d passed; %d steps, %d rejected, deepest %.3f of the radius\n",
           what, step, met, all, sum.passed, sum.steps, sum.rejected, sum.depth / kRadius);
    EXPECT_EQ(sum.passed, 0) << what << ", step " << step;
    EXPECT_EQ(met, all) << what << ", step " << step;
  }
}

TEST(ThinPlate, IsNotPassedByBeams) { expect_none_passes({}, "beams", 4); }
TEST(ThinPlate, IsNotPassedByCables) { expect_none_passes({.cable = true}, "cables", 4); }
TEST(ThinPlate, IsNotPassedWhereItIsAMesh) { expect_none_passes({.of_mesh = true}, "mesh", 2); }
TEST(ThinPlate, DoesNotPassWhatIsAtRest) {
  expect_none_passes({.cable = true, .plate_moves = true}, "moving plate", 2);
}
TEST(ThinPlate, IsNotPassedInStepsThatImpactsDoNotDivide) {
  expect_none_passes({.cable = true, .resolve = false}, "undivided", 2);
}
TEST(ThinPlate, IsNotPassedByNodes) {
  expect_none_passes({.cable = true, .nodes = true}, "nodes", 2);
  expect_none_passes({.cable = true, .nodes = true, .resolve = false}, "nodes, undivided", 2);
}

}  // namespace
}  // namespace hawser::test::contact_thin_test
