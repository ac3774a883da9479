// Feeder law: length paid out in a step as a function of tension, force of the element at the feed point, and
// energy of a changed unstretched length.
#include "hawser/kernels/feeder_law.hpp"

#include <gtest/gtest.h>

#include <random>

#include "hawser/kernels/beam.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/feeder.hpp"
#include "hawser/model/longest_step.hpp"

namespace hawser::test::feed_test {
namespace {

ResponseCurve rope() {
  return ResponseCurve(std::vector<ResponseCurve::Row>{{0.05, 15}, {0.1, 90}, {0.2, 120}}, false);
}

double tension(const CableSection& s, double chord, double length) {
  const double strain = chord / length - 1 - s.free_strain;
  return strain > 0 ? s.axial(strain).force : 0;
}

// A step that began with the strain `strain_before`.
struct Fed {
  double length = 0, by_chord = 0;
};
Fed step(const CableSection& s, const FeedLaw& law, double from, double h, double chord,
         double strain_before = 0) {
  const FedElement e =
      feed_step([&](double length) { return cable_feed(s, chord, length, strain_before, h); }, law, from, h);
  return {e.length, e.length_by_force * cable_feed(s, chord, e.length, strain_before, h).by_chord};
}

TEST(Feed, SolvesItsSpeedLaw) {
  const ResponseCurve table = rope();
  for (const ResponseCurve* t : {static_cast<const ResponseCurve*>(nullptr), &table})
    for (const double k : {0.0, 0.01, 1.0, 100.0})
      for (const double most : {0.0, 0.2}) {
        CableSection s{1, 300, 0, t, 0.01};
        const FeedLaw law{20, k, most, false};
        for (const double chord : {0.3, 0.9, 1.0, 1.05, 1.1, 1.2, 1.8})
          for (const double h : {1e-3, 0.1, 10.0}) {
            const double from = 1.02;
            const Fed e = step(s, law, from, h, chord);
            const double T = tension(s, chord, e.length);
            const double v = (e.length - from) / h;
            EXPECT_GT(e.length, 0);
            if (most > 0) {
              EXPECT_LE(std::abs(v), most * (1 + 1e-9));
            }
            if (most == 0 || std::abs(v) < most * (1 - 1e-9)) {
              if (k == 0) {
                EXPECT_NEAR(T, 20, 1e-9);
              } else if (e.length > 1e-5) {
                EXPECT_NEAR(v, k * (T - 20), 1e-9 * (1 + k * T));
              }
            }
            constexpr double d = 1e-6;
            const double slope =
                (step(s, law, from, h, chord + d).length - step(s, law, from, h, chord - d).length) / (2 * d);
            EXPECT_NEAR(slope, e.by_chord, 1e-6 * (1 + std::abs(slope))) << k << ' ' << chord << ' ' << h;
          }
      }
}

// A feeder rests within its band. Beyond it, the tension stays at the edge until the speed equals that of the
// law, and then satisfies the law. The tension is a continuous function of the chord.
TEST(Feed, LeavesItsBandWithoutAJump) {
  for (const double most_speed : {0.0, 4.0})
    for (const double damping : {0.0, 0.02})
      for (const double sign : {1.0, -1.0}) {
        const CableSection s{1, 300, damping};
        const FeedLaw law{60, 0.5, most_speed, true, 50, 75};
        constexpr double from = 1, h = 0.01, strain_before = 0.2;  // 60 N
        const auto T = [&](double chord) {
          return cable_feed(s, chord, step(s, law, from, h, chord, strain_before).length, strain_before, h)
              .force;
        };
        int rested = 0, at_edge = 0, by_law = 0, limited = 0;
        double last = 60;
        for (int i = 0; i < 2000; ++i) {
          const double chord = 1.2 + sign * 1e-4 * i;
          const double now = T(chord);
          const Fed e = step(s, law, from, h, chord, strain_before);
          const double v = (e.length - from) / h;
          EXPECT_GE(sign * (now - last), -1e-9);
          EXPECT_LT(sign * (now - last), 2.1 * 300 * 1e-4 * (1 + damping / h)) << chord;
          const double edge = sign > 0 ? 75 : 50;
          if (v == 0) {
            ++rested;
          } else if (most_speed > 0 && std::abs(v) > most_speed * (1 - 1e-9)) {
            ++limited;
          } else if (std::abs(now - edge) < 1e-9) {
            ++at_edge;
            EXPECT_LE(std::abs(v), 0.5 * std::abs(edge - 60) * (1 + 1e-9));
          } else {
            ++by_law;
            EXPECT_NEAR(v, 0.5 * (now - 60), 1e-9);
          }
          last = now;
          if (i % 100 != 50) continue;
          constexpr double d = 1e-7;
          const double slope = (step(s, law, from, h, chord + d, strain_before).length -
                                step(s, law, from, h, chord - d, strain_before).length) /
                               (2 * d);
          EXPECT_NEAR(slope, e.by_chord, 1e-6) << chord;
        }
        EXPECT_GT(rested, 10);
        EXPECT_GT(at_edge, 10);
        EXPECT_GT(most_speed > 0 ? limited : by_law, 10);
      }
}

TEST(Feed, TheForceFollowsTheLength) {
  const ResponseCurve table = rope();
  for (const ResponseCurve* t : {static_cast<const ResponseCurve*>(nullptr), &table})
    for (const double k : {0.0, 0.05}) {
      const FeedLaw law{20, k, 0, false};
      const CableSection before{1, 300, 0.02, t, 0.01};
      const CableStart from = cable_start(before, Vec3::Zero(), Vec3(0.9, 0.5, -0.3), 0.01, 0.1);
      const CableStep in{0.1, 0.06};
      const auto mean = [&](const Vec3& x, CableForce* out) {
        CableSection s = before;
        const Fed e = step(s, law, 1, in.h, x.norm(), from.strain);
        s.length = e.length;
        s.length_by_chord = e.by_chord;
        if (out) cable_mean_force(s, from, in, Vec3::Zero(), x, *out);
        return cable_mean_force(s, from, in, Vec3::Zero(), x);
      };
      const Vec3 x(0.95, 0.52, -0.25), d(0.3, -0.4, 0.6);
      CableForce pull;
      mean(x, &pull);
      constexpr double e = 1e-5;
      const Vec3 slope = (8 * (mean(x + e * d, nullptr) - mean(x - e * d, nullptr)) -
                          (mean(x + 2 * e * d, nullptr) - mean(x - 2 * e * d, nullptr))) /
                         (12 * e);
      EXPECT_LT((slope - pull.k * d).norm(), 1e-8 * slope.norm());
    }
}

// Work of the ends and of the length change equals energy change plus dissipation exactly.
TEST(Feed, WorkAndEnergyAgree) {
  std::mt19937 g(7);
  std::uniform_real_distribution<double> u(-1, 1);
  const ResponseCurve table = rope();
  for (const ResponseCurve* t : {static_cast<const ResponseCurve*>(nullptr), &table})
    for (int i = 0; i < 400; ++i) {
      const CableSection s0{1 + 0.3 * u(g), 300, i % 2 ? 0.02 : 0, t, 0.01};
      CableSection s1 = s0;
      s1.length *= 1 + 0.2 * u(g);
      const Vec3 d0 = s0.length * (1.05 + 0.1 * u(g)) * Vec3(u(g), u(g), u(g)).normalized();
      const Vec3 d1 = s1.length * (1.05 + 0.1 * u(g)) * Vec3(u(g), u(g), u(g)).normalized();
      const CableStart from = cable_start(s0, Vec3::Zero(), d0, 0.02 * u(g), 0.1);
      const CableStep step{0.1, 0.06};
      const auto energy = [](const CableSection& s, const Vec3& d) {
        return cable_stress(s, {Vec3::Zero(), d, Vec3::Zero(), Vec3::Zero()}).strain_energy;
      };
      const CableStepResult lost = cable_step_result(s1, from, step, Vec3::Zero(), d1);
      const double work = cable_mean_force(s1, from, step, Vec3::Zero(), d1).dot(d1 - d0) + lost.fed;
      EXPECT_NEAR(work, energy(s1, d1) - energy(s0, d0) + lost.damped + lost.filtered, 1e-9);
      EXPECT_GE(lost.damped, 0);
    }
}

// A beam in a bent state; GA as given.
struct Bar {
  BeamSection s;
  BeamEnds e;
};
Bar bent(std::mt19937& g, double GA, const ResponseCurve* table) {
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vec = [&] { return Vec3(u(g), u(g), u(g)); };
  Bar b;
  b.s.length = 1.3;
  b.s.EA = 2e3;
  b.s.EI2 = 15;
  b.s.EI3 = 40;
  b.s.GJ = 23;
  b.s.GA = GA;
  b.s.tension = table;
  b.e.q1 = exp_so3(vec());
  b.e.q2 = b.e.q1 * exp_so3(0.5 * vec());
  b.e.x1 = vec();
  b.e.x2 = b.e.x1 + b.e.q1 * (1.35 * (Vec3::UnitX() + 0.15 * vec()));
  return b;
}

// The force at a feeder is minus the derivative of strain energy with respect to unstretched length.
TEST(Feed, ABeamPullsByItsEnergy) {
  std::mt19937 g(3);
  const ResponseCurve table = rope();
  for (int i = 0; i < 40; ++i) {
    const Bar b = bent(g, i % 2 ? 900 : 0, i % 3 ? nullptr : &table);
    BeamReference r;
    r.strain = -0.01;
    const auto of = [&](double length, const Vec3& pulled) {
      BeamSection s = b.s;
      s.length = length;
      BeamEnds e = b.e;
      e.x2 += pulled;
      return std::pair(beam_feed(s, r, e), beam_stress(s, r, e).strain_energy);
    };
    constexpr double d = 1e-4;
    const auto by = [&](auto&& value) {
      return (8 * (value(d) - value(-d)) - (value(2 * d) - value(-2 * d))) / (12 * d);
    };
    const BeamFeed f = of(b.s.length, Vec3::Zero()).first;
    EXPECT_NEAR(-by([&](double x) { return of(b.s.length + x, Vec3::Zero()).second; }), f.force,
                1e-8 * b.s.EA);
    EXPECT_NEAR(by([&](double x) { return of(b.s.length + x, Vec3::Zero()).first.force; }), f.slope,
                1e-8 * b.s.EA);
    EXPECT_LT(f.slope, 0);
  }
  // For a straight beam the force is the tension plus the elastic energy per length.
  Bar b = bent(g, 0, nullptr);
  b.e.q1 = b.e.q2 = Quat::Identity();
  b.e.x2 = b.e.x1 + 1.3013 * Vec3::UnitX();
  const BeamFeed f = beam_feed(b.s, {}, b.e);
  EXPECT_NEAR(f.force, 2e3 * 0.001 * (1.001 - 0.0005), 1e-9);
  EXPECT_NEAR(f.by_chord, 2e3 * 1.001 / 1.3, 1e-9);
}

TEST(Feed, TheForceOfABeamFollowsTheLength) {
  using Vec12 = Eigen::Matrix<double, 12, 1>;
  std::mt19937 g(5);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 40; ++i) {
    const Bar b = bent(g, i % 2 ? 900 : 0, nullptr);
    for (const double k : {0.0, 0.01}) {
      const FeedLaw law{60, k, 0, false};
      const auto force = [&](const BeamEnds& e, Mat12* K) {
        BeamSection s = b.s;
        const FedElement fed = feed_step(
            [&](double length) {
              BeamSection at = b.s;
              at.length = length;
              const BeamFeed f = beam_feed(at, {}, e);
              return FedPull{f.force, f.slope};
            },
            law, 1.3, 0.1);
        s.length = fed.length;
        s.length_by_force = fed.length_by_force;
        Vec12 f;
        if (K)
          beam_tangent(s, {}, e, false, f, *K, nullptr);
        else
          beam_force(s, {}, e, f);
        return f;
      };
      Mat12 K;
      force(b.e, &K);
      Vec12 d;
      for (double& x : d) x = u(g);
      const auto at = [&](double step) {
        const Vec12 m = step * d;
        BeamEnds e = b.e;
        e.x1 += m.segment<3>(0);
        e.x2 += m.segment<3>(6);
        e.q1 = e.q1 * exp_so3(m.segment<3>(3));
        e.q2 = e.q2 * exp_so3(m.segment<3>(9));
        return force(e, nullptr);
      };
      constexpr double e = 1e-3;
      const Vec12 slope = (8 * (at(e) - at(-e)) - (at(2 * e) - at(-2 * e))) / (12 * e);
      EXPECT_LT((slope - K * d).norm(), 1e-6 * slope.norm()) << k;
    }
  }
}

TEST(Feed, StepsFollowItsChangesOfSpeed) {
  model::Case c;
  c.dynamics.duration = 1000;
  c.output.every = 10;
  c.lines.emplace_back().end_b.feed.emplace().speed = {{0, 0.5}, {20, 0.5}, {24, 0}};
  EXPECT_DOUBLE_EQ(model::longest_step(c).length, 4. / 20);
  c.events.emplace_back().action.kind = model::Action::Kind::feed;
  c.events.back().action.ramp = 2;
  EXPECT_DOUBLE_EQ(model::longest_step(c).length, 2. / 20);
}

TEST(Feed, ItsLengthIsTheIntegralOfItsSpeed) {
  model::Feed f;
  f.speed = {{1, 0.5}, {3, -1}, {4, 2}};
  double sum = 0;
  constexpr double h = 1e-4;
  for (int i = 0; i < 60000; ++i) {
    sum += h * model::fed_by(f, (i + 0.5) * h).speed;
    if (i % 5000 == 0) {
      const model::Fed at = model::fed_by(f, (i + 1) * h);
      EXPECT_NEAR(at.length, sum, 1e-6);
      EXPECT_NEAR(at.acceleration, (model::fed_by(f, (i + 1) * h + 1e-6).speed - at.speed) / 1e-6, 1e-6);
    }
  }
  EXPECT_EQ(model::fed_by(f, 0.5).speed, 0.5);
  EXPECT_EQ(model::fed_by(f, 10).speed, 2);
}

}  // namespace
}  // namespace hawser::test::feed_test
