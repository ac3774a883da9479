// Case C08, impact on a penalty spring: a mass with an initial speed (a rigid line of two nodes of 25 kg on
// 5e4 N/m each, in all 50 kg on 1e5 N/m), a dropped mass, and an elastic bar against a wall.
#include "verification/contact_rig.hpp"

namespace hawser::test::contact_impact_test {
namespace {

constexpr double kMass = 50, kStiffness = 1e5, kSpeed = 2;
const double kPeriod = 2 * M_PI * std::sqrt(kMass / kStiffness);

struct Impact {
  double zeta = 0, gravity = 0, speed = kSpeed, height = 0.01, step = kPeriod / 100, rho_infinity = 0.8;
};
struct Rebound {
  double force = 0, depth = 0, duration = 0, speed = 0, lost = 0;  // N, m, s, m/s, part of the energy
};

Rebound run(const Impact& in) {
  constexpr double radius = 0.01;
  model::LineType type = cable_type(1e6, kMass / 2);
  type.outer_diameter = type.contact_diameter = 2 * radius;
  model::Case c = one_line(type, 2, 1, {}, {});
  c.environment.gravity = in.gravity;
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {{0, 0, radius + in.height}, {2, 0, radius + in.height}};
  model::Volume floor;
  floor.name = "floor";
  floor.basis = model::StiffnessBasis::per_point;
  floor.normal_stiffness = kStiffness / 2;
  floor.relative_damping = in.zeta;
  floor.smoothing = 1e-6;
  c.volumes.push_back(floor);
  c.contact.method = model::ContactMethod::nodes;
  c.dynamics.step = in.step;
  c.dynamics.rho_infinity = in.rho_infinity;
  Simulation s(PETSC_COMM_WORLD, c, {std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ())});
  for (Vec3& v : s.state().v) v = Vec3(0, 0, -in.speed);
  Dynamics& d = s.dynamics();
  d.start(s.state());

  NodeField contact(s, "contact_normal_force");
  Rebound out;
  const double damping = 2 * in.zeta * std::sqrt(kStiffness * kMass);
  double t0 = 0;
  double g0 = in.height;
  double f0 = 0;
  double touched = -1;
  d.run(
      10, [](double t) { return t + 100; },
      [&](const StepInfo& i) {
        const double g = d.committed().s.x[0].z() - radius;
        const double v = d.committed().s.v[0].z();
        const std::vector<double>& force = contact.at(d.committed_kinematics());
        const double f = force[0] + force[1];
        out.force = std::max(out.force, f);
        out.depth = std::max(out.depth, -g);
        // Times of touch and release by linear interpolation within a step: of the gap, and of the force as
        // if it could pull.
        if (touched < 0 && f > 0) touched = t0 + i.h * g0 / (g0 - g);
        if (touched >= 0 && f == 0) {
          const double pull = -kStiffness * g - damping * v;
          out.duration = t0 + i.h * f0 / (f0 - pull) - touched;
          out.speed = v;
          const double before = 0.5 * in.speed * in.speed + in.gravity * in.height;
          out.lost = 1 - (0.5 * v * v + in.gravity * g) / before;
          return false;
        }
        t0 = i.time;
        g0 = g;
        f0 = f;
        return i.time < 2;
      });
  return out;
}

// Closed form: F = v sqrt(k m), duration pi sqrt(m/k). Errors are below 0.1 % with steps of T/100, at any
// time of impact within a step.
TEST(Impact, MassOnSpring) {
  for (const double rho : {0.8, 1.0})
    for (const double height : {1e-6, 0.01, 0.0137}) {
      Impact in;
      in.rho_infinity = rho;
      in.height = height;
      const Rebound r = run(in);
      std::printf("impact, rho %.1f, from %g m: force %+.3f %%, duration %+.3f %%, speed %+.3f %%\n", rho,
                  height, 100 * (r.force / 4472.135955 - 1), 100 * (r.duration / 0.07024814731 - 1),
                  100 * (r.speed / kSpeed - 1));
      EXPECT_NEAR(r.force, 4472.135955, 1e-3 * 4472.135955);
      EXPECT_NEAR(r.depth, 0.04472135955, 1e-3 * 0.04472135955);
      EXPECT_NEAR(r.duration, 0.07024814731, 1e-3 * 0.07024814731);
      EXPECT_NEAR(r.speed, kSpeed, 1e-3 * kSpeed);
    }
}

// Closed form of a Kelvin-Voigt spring without tension, zeta = 0.1. Its force jumps at the impact, so the
// error is of first order: the jump is up to half a step early or late.
TEST(Impact, Damped) {
  const double exact = 0.7440793978;
  double worst[2] = {0, 0};
  for (const double height : {1e-6, 0.005, 0.01, 0.0137})
    for (const int fine : {0, 1}) {
      Impact in;
      in.zeta = 0.1;
      in.height = height;
      in.step = kPeriod / (fine ? 1000 : 100);
      const Rebound r = run(in);
      worst[fine] = std::max(worst[fine], std::abs(r.speed / kSpeed / exact - 1));
      EXPECT_NEAR(r.duration, 0.06609985373, (fine ? 1e-3 : 5e-3) * 0.06609985373);
    }
  // If the run starts at the impact, as the closed form does, the error at T/100 is below 0.1 %, as without
  // damping.
  Impact touching;
  touching.zeta = 0.1;
  touching.height = -1.001e-6;
  const Rebound r = run(touching);
  std::printf("damped impact from the touch, T/100: restitution %+.3f %%\n",
              100 * (r.speed / kSpeed / exact - 1));
  EXPECT_NEAR(r.speed / kSpeed, exact, 1e-3 * exact);
  std::printf("damped impact: restitution off by up to %.3f %% at T/100, %.3f %% at T/1000\n", 100 * worst[0],
              100 * worst[1]);
  EXPECT_LT(worst[0], 8e-3);
  EXPECT_LT(worst[1], 1e-3);
}

// Dropped from 1 m: m g (h + p) = k p²/2.
TEST(Impact, Drop) {
  Impact in;
  in.gravity = 9.81;
  in.speed = 0;
  in.height = 1;
  const Rebound r = run(in);
  std::printf("drop: force %+.3f %%, energy lost %.3f %%\n", 100 * (r.force / 10407.18242 - 1), 100 * r.lost);
  EXPECT_NEAR(r.force, 10407.18242, 1e-3 * 10407.18242);
  EXPECT_NEAR(r.depth, 0.1040718242, 1e-3 * 0.1040718242);
  EXPECT_LT(std::abs(r.lost), 2e-3);
}

// The bar: E 210 GPa, A 0.01 m², 7850 kg/m³, 10 m, 1 m/s, against a wall with a spring kp.
constexpr double kLength = 10, kAxial = 2.1e9, kBarMass = 78.5;
constexpr int kPieces = 100;
const double kWave = std::sqrt(kAxial / kBarMass);
const double kImpedance = std::sqrt(kAxial * kBarMass);

// Reference by characteristics: the end moves into the wall at v + 2 w - F/Z. w is the wave that left the end
// as w - F/Z one return trip earlier; the free end reflects it with the same velocity.
struct BarHistory {
  double dt = 2e-7, force = 0, release = 0, impulse = 0;
  std::vector<double> F{0};
  explicit BarHistory(double kp) {
    const size_t delay = static_cast<size_t>(std::llround(2 * kLength / kWave / dt));
    std::vector<double> left{0};
    double p = 0;
    for (size_t i = 1;; ++i) {
      const auto wave = [&](size_t k) { return k >= delay ? left[k - delay] : 0.0; };
      const double half = p + 0.5 * dt * (1 + 2 * wave(i - 1) - kp * p / kImpedance);
      p += dt * (1 + wave(i - 1) + wave(i) - kp * half / kImpedance);
      release = static_cast<double>(i) * dt;
      if (p <= 0) return;
      F.push_back(kp * p);
      left.push_back(wave(i) - kp * p / kImpedance);
      impulse += kp * p * dt;
      force = std::max(force, kp * p);
    }
  }
};

// The bar before the wall; 100 elements.
model::Case bar_and_wall(double kp, double step) {
  model::LineType type = beam_type(kAxial, 1e5, 1e5, kBarMass);
  type.outer_diameter = type.contact_diameter = 1e-3;
  model::Case c = one_line(type, kLength, kPieces, {}, {});
  c.lines[0].start = model::Start::points;
  c.lines[0].points = {{5e-4, 0, 0}, {kLength + 5e-4, 0, 0}};
  model::Volume wall;
  wall.name = "wall";
  wall.basis = model::StiffnessBasis::per_point;
  wall.normal_stiffness = kp;
  wall.smoothing = 1e-8;
  c.volumes.push_back(wall);
  c.contact.method = model::ContactMethod::nodes;
  c.dynamics.step = step;
  return c;
}

class Bar : public ::testing::TestWithParam<double> {};

TEST_P(Bar, AgainstWall) {
  const double kp = GetParam();
  const int n = kPieces;
  // Steps of half the travel time of a wave through an element, whatever the contact requires. Shorter ones
  // resolve oscillations of the mesh behind the wave front, 15 % above the plateau.
  model::Case c = bar_and_wall(kp, 0.5 * kLength / n / kWave);
  c.dynamics.resolve_impacts = false;
  Simulation s(PETSC_COMM_WORLD, c, {std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitX())});
  for (Vec3& v : s.state().v) v = Vec3(-1, 0, 0);
  Dynamics& d = s.dynamics();
  d.start(s.state());

  const BarHistory exact(kp);
  NodeField contact(s, "contact_normal_force");
  const double trip = 2 * kLength / kWave;
  double most = 0, last = 0, impulse = 0, release = 0;
  Samples plateau;
  d.run(
      0.012, [](double t) { return t + 100; },
      [&](const StepInfo& i) {
        const double f = contact.at(d.committed_kinematics())[0];
        most = std::max(most, f);
        impulse += 0.5 * (f + last) * i.h;
        if (f > 0) release = i.time;
        if (i.time > 0.5 * trip && i.time < 0.95 * trip) plateau.add(f, i.h);
        last = f;
        return true;
      });
  double momentum = 0;
  for (int e = 0; e < n; ++e) {
    const size_t k = static_cast<size_t>(e);
    momentum += kBarMass * kLength / n * 0.5 * (d.committed().s.v[k].x() + d.committed().s.v[k + 1].x());
  }
  const double brought = kBarMass * kLength;
  std::printf(
      "bar, kp %.0e: force %+.2f %%, plateau %+.2f %% of rho c A v, release %+.2f %%, impulse %+.3f %%, "
      "momentum %+.1e\n",
      kp, 100 * (most / exact.force - 1), 100 * (plateau.mean() / kImpedance - 1),
      100 * (release / exact.release - 1), 100 * (impulse / exact.impulse - 1),
      (momentum + brought) / impulse - 1);
  EXPECT_NEAR(most, exact.force, 0.05 * exact.force);
  if (kp >= 1e9) {
    EXPECT_NEAR(plateau.mean(), kImpedance, 0.01 * kImpedance);
  }
  if (kp >= 1e10) {
    EXPECT_NEAR(release, trip, 0.02 * trip);
  }
  EXPECT_NEAR(release, exact.release, 5e-3 * exact.release);
  EXPECT_NEAR(impulse, exact.impulse, 5e-3 * exact.impulse);
  // Not to round-off, because steps are divided at the impact.
  EXPECT_NEAR(momentum + brought, impulse, 1e-5 * impulse);
}

// With steps of a third, a sixth and a twelfth of the contact time the peak is the same, and energy does not
// increase.
TEST_P(Bar, PeakDoesNotDependOnTheStep) {
  const double kp = GetParam();
  const BarHistory exact(kp);
  for (const double divided : {3.0, 4.0, 5.0, 6.0, 12.0}) {
    const model::Case c = bar_and_wall(kp, exact.release / divided);
    Simulation s(PETSC_COMM_WORLD, c, {std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitX())});
    for (Vec3& v : s.state().v) v = Vec3(-1, 0, 0);
    Dynamics& d = s.dynamics();
    d.start(s.state());
    NodeField contact(s, "contact_normal_force");
    double most = 0, energy = 0, last = 0;  // energy: at most, at the end
    int steps = 0, rejected = 0;
    const double brought = 0.5 * kBarMass * kLength;
    d.run(
        0.012, [](double t) { return t + 100; },
        [&](const StepInfo& i) {
          ++steps;
          rejected += i.rejected;
          most = std::max(most, contact.at(d.committed_kinematics())[0]);
          const Energy e = s.system().energy(d.committed_kinematics());
          energy = std::max(energy, e.kinetic + e.strain);
          last = e.kinetic + e.strain;
          return true;
        });
    std::printf(
        "bar, kp %.0e, steps of T/%.0f (%d, %d rejected): force %+.2f %%, energy at most %+.1e, at the end "
        "%+.1e\n",
        kp, divided, steps, rejected, 100 * (most / exact.force - 1), energy / brought - 1,
        last / brought - 1);
    EXPECT_NEAR(most, exact.force, 0.03 * exact.force);
    EXPECT_LT(energy / brought - 1, 2e-4);
  }
}
INSTANTIATE_TEST_SUITE_P(Walls, Bar, ::testing::Values(1e8, 1e9, 1e10));

// The history by characteristics against the closed form of its first trip, and against values of an
// independent computation (largest force and time of release).
TEST(BarReference, Characteristics) {
  const double Z = kImpedance;
  const BarHistory soft(1e8), stiff(1e9);
  const double half = kLength / kWave;
  const auto first_trip = [&](double kp) { return Z * (1 - std::exp(-kp * half / Z)); };
  EXPECT_NEAR(soft.F[static_cast<size_t>(half / soft.dt)], first_trip(1e8), 1e-3 * Z);
  EXPECT_NEAR(stiff.F[static_cast<size_t>(half / stiff.dt)], first_trip(1e9), 1e-3 * Z);
  EXPECT_NEAR(soft.force, 263550.3727, 1e-4 * Z);
  EXPECT_NEAR(soft.release, 0.009470642159, 1e-6);
  EXPECT_NEAR(stiff.force, 405987.5649, 1e-4 * Z);
  EXPECT_NEAR(stiff.release, 0.004548166466, 1e-6);
}

}  // namespace
}  // namespace hawser::test::contact_impact_test
