// A hose of 278.5 m between two points 200 m apart in a uniform lateral current, free, and with a wall behind
// it.
//
// Reference: planar extensible elastica under cross-flow drag on a Winkler wall, solved by multiple shooting
// (own computation, free case checked against the exact catenary of constant tension for EI -> 0 to 5e-7).
// Hose and current as in Silva, Corrêa & Jacob, OMAE2006-92155. Tolerances: end tension 0.5 %, contact length
// 1 m, wall force 0.5 %, curvature 1 %.
#include "verification/contact_rig.hpp"

namespace hawser::test::hose_on_wall_test {
namespace {

constexpr double kLength = 278.5, kDiameter = 0.49843453365368695, kDensity = 1025, kSpeed = 0.72;

struct Found {
  double tension = 0, middle = 0, angle = 0;  // N at end A, m from the wall's plane, deg from the flow there
  double curvature = 0, force = 0;            // 1/m, N of the wall
  double first = 0, last = 0;                 // m, arc lengths at the ends of the contact
};

// The hose is submerged and neutrally buoyant, so it stays in the plane. stiffness [N/m²] of the wall; 0: no
// wall.
Found hose(double EI, double EA, double stiffness, int elements, model::Relaxation relaxation) {
  model::LineType t = beam_type(EA, EI, EI, kDensity * M_PI / 4 * kDiameter * kDiameter);
  t.outer_diameter = kDiameter;
  t.contact_diameter = 1e-6;  // the reference has contact at the centreline
  t.Cd_normal = 1.2;
  t.Cd_axial = 0;
  model::Case c = one_line(t, kLength, elements, anchor({60, 0, -10}), anchor({60, 200, -10}));
  c.environment.gravity = 9.80665;
  c.environment.water.present = true;
  c.environment.water.density = kDensity;
  c.environment.water.current.profile = {{0, kSpeed, M_PI}};
  c.statics.relaxation = relaxation;
  std::vector<std::shared_ptr<const Surface>> surfaces;
  if (stiffness > 0) {
    model::Volume wall;
    wall.name = "wall";
    wall.shape = PlaneShape{Vec3::Zero(), Vec3::UnitX()};
    wall.basis = model::StiffnessBasis::per_length;
    wall.normal_stiffness = stiffness;
    wall.smoothing = 0;
    c.volumes.push_back(wall);
    surfaces.push_back(std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitX()));
  }
  Simulation sim(PETSC_COMM_SELF, c, surfaces);
  sim.solve_statics();
  Found f;
  const State& s = sim.state();
  const size_t last = s.x.size() - 1;
  const double* r = sim.system().reactions().data();
  f.tension = Vec3(r[0], r[1], r[2]).norm();
  f.middle = s.x[last / 2].x();
  const Vec3 tangent = s.q[0] * Vec3::UnitX();
  f.angle = std::atan2(tangent.y(), -tangent.x()) * 180 / M_PI;
  std::vector<double> curvature(s.x.size());
  const auto fields = sim.system().fields();
  for (const FieldSource& source : fields.sources())
    if (source.name == "curvature") source.fill(s.at_rest(), curvature);
  f.curvature = *std::max_element(curvature.begin(), curvature.end());
  if (!sim.line_volume_contact()) return f;
  f.first = kLength;
  ActiveContacts touches;
  sim.line_volume_contact()->active_contacts(touches);
  for (const ActiveContact& touch : touches) {
    f.force += touch.force;
    f.first = std::min(f.first, touch.from);
    f.last = std::max(f.last, touch.to);
  }
  return f;
}

void print(const char* what, const Found& f) {
  std::printf(
      "%s: end tension %.1f N at %.3f deg, middle at %.4f m, curvature %.6f 1/m, contact %.2f to %.2f m, "
      "%.1f N\n",
      what, f.tension, f.angle, f.middle, f.curvature, f.first, f.last, f.force);
}

constexpr double kEA = 61781895, kEI = 196133;

TEST(HoseOnWall, FreeInTheCurrent) {
  for (const auto relaxation : {model::Relaxation::never, model::Relaxation::always}) {
    const Found f = hose(kEI, kEA, 0, 100, relaxation);
    print("free", f);
    EXPECT_NEAR(f.tension, 10902.904312922767, 5e-3 * 10902.9);
    EXPECT_NEAR(f.middle, -26.588397820789567, 0.05);
    EXPECT_NEAR(f.angle, 26.85661519011112, 0.1);
    EXPECT_NEAR(f.curvature, 0.014499751805954723, 1e-2 * 0.0145);
  }
}

// Without bending the hose is the exact catenary of constant tension a D0, D0 the drag per length in normal
// flow.
TEST(HoseOnWall, FreeWithoutBending) {
  const Found f = hose(100, 1e10, 0, 200, model::Relaxation::automatic);
  print("free, EI 100", f);
  EXPECT_NEAR(f.tension, 10916.849985832752, 5e-3 * 10916.8);
  EXPECT_NEAR(60 - f.middle, 86.57543728017528, 0.05);
}

TEST(HoseOnWall, AgainstTheWall) {
  struct Row {
    double stiffness, tension, angle, curvature, first, last, force;
  };
  for (const Row& r :
       {Row{1e5, 2363.522292122641, 10.871618816843355, 0.039977867419796, 79.20672619047619,
            199.2932738095238, 21198.559623079702},
        Row{1e6, 2363.382619, 10.8703123, 0.03999318684, 79.93613095, 198.563869, 21199.37609}})
    for (const auto relaxation : {model::Relaxation::automatic, model::Relaxation::always}) {
      const Found f = hose(kEI, kEA, r.stiffness, 200, relaxation);
      print("on the wall", f);
      EXPECT_NEAR(f.tension, r.tension, 5e-3 * r.tension);
      EXPECT_NEAR(f.angle, r.angle, 0.1);
      EXPECT_NEAR(f.curvature, r.curvature, 1e-2 * r.curvature);
      EXPECT_NEAR(f.first, r.first, 1);
      EXPECT_NEAR(f.last, r.last, 1);
      EXPECT_NEAR(f.last - f.first, r.last - r.first, 1);
      EXPECT_NEAR(f.force, r.force, 5e-3 * r.force);
    }
}

// Without bending the hose reaches the wall tangentially in a catenary of constant tension.
TEST(HoseOnWall, AgainstTheWallWithoutBending) {
  const Found f = hose(100, 1e10, 1e6, 600, model::Relaxation::automatic);
  print("on the wall, EI 100", f);
  EXPECT_NEAR(f.tension, 2347.288037826, 5e-3 * 2347.3);
  EXPECT_NEAR(f.last - f.first, 2 * 65.9522941, 1);
  EXPECT_NEAR(f.force, 20960.81358, 5e-3 * 20960.8);
}

}  // namespace
}  // namespace hawser::test::hose_on_wall_test
