// Capstans with contact along the line and more than tension: bending stiffness (C01), mobilised friction
// (C02), weight (C11), and two turns side by side. Half a turn over the top of a smooth drum about y with
// vertical legs; a dead load at one end, the other end is drawn down.
#include <cstdlib>

#include "verification/contact_rig.hpp"

namespace hawser::test::line_contact_capstan_variants_test {
namespace {

constexpr double kRho = 1, kLine = 0.01;  // m: radius of the axis on the drum, of the line

struct Rope {
  double mu = 0.3, EA = 1e7, EI = 1, weight = 0, load = 1000;  // -, N, N m², N/m, N
  double wrap = M_PI, pitch = 0, leg = 1.5;                    // rad, m a turn, m
  double beside = 0;                                           // m, outward offset of the drawn end
  double way = 0.15, speed = 0.05, mobilisation = 0;           // m, m/s, m
  double stretch = 0;
  double stiffness = 0;     // N/m²; 0: automatic
  bool drum_turns = false;  // under a line whose end is held
};
struct Drawn {
  Samples ratio;                       // over the second half: drawn end's reaction over the dead load
  std::vector<double> slid, reaction;  // m: of the point where the wrap begins; N
  double audit = 0;
};

Drawn draw(const Rope& r, std::shared_ptr<const Surface> drum_surface = nullptr) {
  if (!drum_surface) drum_surface = round_drum(kRho - kLine, 4);
  std::vector<Vec3> path = capstan_path(kRho, r.wrap, r.leg, r.leg);
  const double turned = static_cast<double>(path.size() - 3);
  for (size_t i = 1; i < path.size(); ++i)
    path[i].y() = r.pitch * r.wrap / (2 * M_PI) * std::min((static_cast<double>(i) - 1) / turned, 1.0);
  path.back() += r.beside * on_circle(1, r.wrap);
  const double length = path_length(path) / (1 + r.stretch);
  const int elements = static_cast<int>(std::ceil(16 * length));
  const double h = length / elements;
  const double g = 9.81;
  model::LineType type = beam_type(r.EA, r.EI, 1, std::max(r.weight / g, 0.2));
  type.outer_diameter = type.contact_diameter = 2 * kLine;
  type.stiffness_damping = 1e-3;
  model::Case c = one_line(type, length, elements, {}, {});
  c.environment.gravity = r.weight > 0 ? g : 0;
  model::Line& line = c.lines[0];
  line.start = model::Start::points;
  line.points = path;
  // The weight of the leg is a part of the load at the drum.
  line.point_loads.push_back({0, -(r.load - r.weight * r.leg) * along_circle(0)});
  model::Body hook;
  hook.name = "hook";
  hook.position = path.back();
  hook.ramp = 1;
  model::Body axle;
  axle.name = "axle";
  axle.ramp = 1;
  if (r.drum_turns)  // about +y its surface moves from the hook to the load
    axle.motion = model::ConstantMotion{Vec3::Zero(), Vec3::UnitY(), r.speed / kRho};
  else
    hook.motion = model::ConstantMotion{r.speed * along_circle(r.wrap), Vec3::UnitZ(), 0};
  c.bodies = {hook, axle};
  line.end_b.kind = model::EndKind::body;
  line.end_b.carrier = "hook";
  model::Volume drum;
  drum.name = "drum";
  drum.body = "axle";
  drum.relative_damping = 0.1;
  drum.friction.axial = drum.friction.lateral = r.mu;
  drum.friction.mobilisation_length = r.mobilisation;
  drum.friction.spring = FrictionSpring::michalopoulos;  // the spring of C02 follows the normal force
  if (r.stiffness > 0) {
    drum.basis = model::StiffnessBasis::per_length;
    drum.normal_stiffness = r.stiffness;
    drum.smoothing = 1e-6;
  }
  c.volumes.push_back(drum);
  c.dynamics.enabled = true;
  c.dynamics.duration = r.way / r.speed + 0.5;
  c.dynamics.step = c.dynamics.duration / 600;

  Simulation s(PETSC_COMM_WORLD, c, {drum_surface});
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const Energy e0 = s.system().energy(d.committed_kinematics());
  Drawn out;
  const size_t begin = static_cast<size_t>(std::lround(r.leg / (1 + r.stretch) / h));
  const Vec3 x0 = d.committed_kinematics().x[begin];
  d.run(
      c.dynamics.duration, [](double t) { return t + 100; },
      [&](const StepInfo& i) {
        const double* f = d.reactions().data() + 3 * s.local().block.back();
        const double slid = (d.committed_kinematics().x[begin] - x0).norm();
        // The weight of the line that has passed over the drum is subtracted.
        const double pull =
            Vec3(f[0], f[1], f[2]).norm() + r.weight * (r.leg + slid + slid * std::exp(r.mu * r.wrap));
        out.reaction.push_back(pull);
        out.slid.push_back(slid);
        if (i.time > c.dynamics.duration / 2) out.ratio.add(pull / r.load, i.h);
        return true;
      });
  const Energy e = s.system().energy(d.committed_kinematics());
  const double brought = e.work + d.support_work() - (e.potential - e0.potential);
  out.audit = (e.kinetic + e.strain - e0.kinetic - e0.strain + e.friction + e.damping) / brought - 1;
  return out;
}

// Intermediate and expensive rows run with HAWSER_FULL only.
bool whole() { return std::getenv("HAWSER_FULL") != nullptr; }

void expect_ratio(const char* what, double parameter, const Drawn& d, double exact, double tolerance) {
  std::printf("capstan along the line, %s %g: T2/T1 %.4f, exact %.4f (%+.3f %%), rms %.3f %%, audit %.1e\n",
              what, parameter, d.ratio.mean(), exact, 100 * (d.ratio.mean() / exact - 1),
              100 * d.ratio.rms() / exact, d.audit);
  EXPECT_NEAR(d.ratio.mean(), exact, tolerance * exact) << what << parameter;
  EXPECT_LT(d.ratio.rms(), 0.005 * exact) << what << parameter;
  EXPECT_LT(std::abs(d.audit), 1e-3) << what << parameter;
}

// C01: the line lifts off where 1 - cos a = B/(2 T), B = EI/rho². There it presses with a point force T sin
// a, which also has friction, and its legs are straight at EI/(2 T rho) beside the drum.
TEST(LineCapstanVariants, BendingStiffness) {
  for (const auto& [mu, wrap, B, exact] : {std::tuple(0.3, M_PI, 1e-4, 2.566247378),
                                           {0.3, M_PI, 0.02, 2.550233535},
                                           {0.3, M_PI, 0.1, 2.491762757},
                                           {0.3, M_PI, 0.5, 2.259254705},
                                           {0.2, M_PI / 2, 0.1, 1.354779408}}) {
    if ((B == 1e-4 || B == 0.02) && !whole()) continue;  // nearly a string
    Rope r;
    r.mu = mu;
    r.wrap = wrap;
    r.EI = B * r.load * kRho * kRho;
    r.leg = 6 * std::sqrt(B) + 1;
    r.beside = r.EI / (2 * exact * r.load * kRho);
    expect_ratio("EI/(T1 rho²)", B, draw(r), exact, 0.005);
  }
}

// C11: T = C e^(mu a) + w rho ((1 - mu²) sin a - 2 mu cos a)/(1 + mu²).
TEST(LineCapstanVariants, HeavyRope) {
  for (const auto& [mu, weight, exact] : {std::tuple(0.2, 100.0, 1.985012091),
                                          {0.2, 500.0, 2.427236104},
                                          {0.3, 100.0, 2.76264427},
                                          {0.3, 500.0, 3.54789177}}) {
    if ((weight == 100) == (mu == 0.3) && !whole()) continue;
    Rope r;
    r.mu = mu;
    r.weight = weight;
    r.way = 0.03;
    r.speed = 0.01;
    expect_ratio("w N/m", weight, draw(r), exact, 0.005);
  }
}

// Two turns side by side.
TEST(LineCapstanVariants, TwoTurnsSideBySide) {
  if (!whole()) GTEST_SKIP() << "long; set HAWSER_FULL";
  for (const double mu : {0.1, 0.3, 0.5}) {
    Rope r;
    r.mu = mu;
    r.wrap = 4 * M_PI;
    r.pitch = 2.5 * kLine;
    r.EA = 1e8;
    r.way = 0.3;
    // A helix has less curvature than a circle.
    const double exact = std::exp(mu * r.wrap / std::hypot(1, r.pitch / (2 * M_PI * kRho)));
    expect_ratio("two turns, mu", mu, draw(r), exact, 0.005);
  }
}

// A mesh of 24 facets with smoothing, which restores the curvature, or flat. The line is drawn over the fixed
// drum, or the drum rotates under it by more than a facet.
std::shared_ptr<const Surface> facets(bool smooth) {
  TriangleMesh mesh = test::drum_mesh(24, kRho - kLine, 4, 4);
  for (Vec3& v : mesh.vertices) v = Vec3(v.y(), v.z(), v.x());
  return std::make_shared<MeshSurface>(std::move(mesh), std::vector<bool>(),
                                       MeshSurfaceOptions{smooth, 40 * M_PI / 180});
}

// A quarter turn to two turns; turns lie side by side.
TEST(LineCapstanVariants, TwentyFourFacets) {
  for (const double wrap : {M_PI / 2, M_PI, 2 * M_PI, 4 * M_PI})
    for (const double mu : {0.1, 0.3, 0.5}) {
      const bool dear = wrap > 4 || (mu != 0.3 && (wrap > 2 || mu == 0.1));
      if (dear && !whole()) continue;
      Rope r;
      r.mu = mu;
      r.wrap = wrap;
      if (wrap > 4) r.pitch = 2.5 * kLine;
      if (wrap > 7) {
        r.EA = 1e8;
        r.way = 0.3;
      }
      const double exact = std::exp(mu * r.wrap / std::hypot(1, r.pitch / (2 * M_PI * kRho)));
      const Drawn d = draw(r, facets(true));
      std::printf("%g turns, between %+.3f and %+.3f %%, ", wrap / (2 * M_PI),
                  100 * (d.ratio.least / exact - 1), 100 * (d.ratio.most / exact - 1));
      expect_ratio("24 facets smoothed, mu", mu, d, exact, 0.005);
      EXPECT_LT(d.ratio.most - d.ratio.least, 0.005 * exact);
    }
}

// Flat facets for comparison: only the mean ratio is checked, within 2 %.
TEST(LineCapstanVariants, TwentyFourFlatFacets) {
  for (const double mu : {0.1, 0.3, 0.5}) {
    if (mu != 0.3 && !whole()) continue;
    Rope r;
    r.mu = mu;
    const Drawn d = draw(r, facets(false));
    const double exact = std::exp(mu * r.wrap);
    std::printf("capstan along the line, 24 flat facets, mu %g: T2/T1 %+.3f %%, rms %.3f %%\n", mu,
                100 * (d.ratio.mean() / exact - 1), 100 * d.ratio.rms() / exact);
    EXPECT_NEAR(d.ratio.mean(), exact, 0.02 * exact);
  }
}

TEST(LineCapstanVariants, DrumTurns) {
  for (const auto& [wrap, mu, round] : {std::tuple(M_PI, 0.1, false),
                                        {M_PI, 0.3, false},
                                        {M_PI, 0.5, false},
                                        {M_PI, 0.3, true},
                                        {4 * M_PI, 0.5, false}}) {
    if (mu != 0.3 && !whole()) continue;
    Rope r;
    r.mu = mu;
    r.wrap = wrap;
    r.drum_turns = true;
    r.way = 0.4;
    if (wrap > 7) {
      r.pitch = 2.5 * kLine;
      r.EA = 1e8;
    }
    const double exact = std::exp(mu * r.wrap / std::hypot(1, r.pitch / (2 * M_PI * kRho)));
    std::printf("%g turns, ", wrap / (2 * M_PI));
    expect_ratio(round ? "drum turns, mu" : "drum of 24 facets smoothed turns, mu", mu,
                 draw(r, round ? nullptr : facets(true)), exact, 0.005);
  }
}

// C02: dT/ds = mu T/R min(u/d, 1), du/ds = (T - T1)/EA, u the slip. Published with EA = 1e5 N and d = 2 mm;
// here displacements are a tenth of those, so that the wrap angle stays constant.
TEST(LineCapstanVariants, Mobilisation) {
  Rope r;
  r.EA = 1e6;
  r.EI = 0.1;
  r.mobilisation = 2e-4;
  r.stretch = r.load / r.EA;
  r.way = 3.3e-3;
  r.speed = 1e-3;
  r.leg = 0.3;
  r.stiffness = 5e9;
  const Drawn d = draw(r);
  for (const auto& [slip, exact] :
       {std::pair(1e-5, 1339.794814), std::pair(5e-5, 1973.279137), std::pair(1e-4, 2303.570176),
        std::pair(1.5e-4, 2485.029788), std::pair(2e-4, 2566.332395), std::pair(3e-4, 2566.332395)}) {
    size_t i = 1;
    while (i + 1 < d.slid.size() && d.slid[i] < slip) ++i;
    ASSERT_GE(d.slid[i], slip);
    const double part = (slip - d.slid[i - 1]) / (d.slid[i] - d.slid[i - 1]);
    const double found = (1 - part) * d.reaction[i - 1] + part * d.reaction[i];
    std::printf("capstan along the line, mobilisation: slip %.2f mm: T2 %.1f N, exact %.1f (%+.2f %%)\n",
                1e3 * slip, found, exact, 100 * (found / exact - 1));
    EXPECT_NEAR(found, exact, 0.005 * exact);
  }
}

}  // namespace
}  // namespace hawser::test::line_contact_capstan_variants_test
