// Code checks of pipes: against an engineering sheet, and each resistance against its definition.
#include "hawser/kernels/pipe_codes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::test::pipe_codes_test {
namespace {

// A 16 in pipe of X65, wall 21 mm.
PipeSteel sixteen() {
  PipeSteel s;
  s.outer = 0.4064;
  s.wall = 0.021;
  s.smys = 450e6;
  s.smts = 535e6;
  s.material_factor = 1;
  return s;
}

// alpha_c M_p / (1.15 · 1.0 · 1.2 · 0.8) = 1379.9 kN m: an engineer's sheet for this pipe (DNV-ST-F101, 5.21
// and 5.22), seamless, on a stinger (gamma_SC,LB 1, gamma_C 0.8).
TEST(PipeCodes, MomentCapacityOfAnEngineersSheet) {
  PipeSteel s = sixteen();
  s.safety_class = 1;
  const PipeCodes p(s);
  EXPECT_NEAR(p.flow_stress() * p.plastic_moment() / (1.15 * 1.2 * 0.8) / 1e3, 1379.9, 0.05);
  // That moment at rest has a utilisation of 1: combination a, with the functional factor 1.2 · 0.8.
  EXPECT_NEAR(p.local_buckling({1379.9e3, 0, 0}, {1379.9e3, 0, 0}, 0.8, 0, 0), 1, 1e-4);
  EXPECT_NEAR(p.local_buckling({0, 689.95e3, 0}, {0, 689.95e3, 0}, 0.8, 0, 0), 0.25, 1e-4);
}

TEST(PipeCodes, CollapsePressureIsARootOfItsEquation) {
  for (const auto& [outer, wall] : {std::pair{0.4064, 0.021}, {0.9144, 0.02}, {0.1524, 0.015}})
    for (const double share : {1.0, 0.85}) {
      PipeSteel s = sixteen();
      s.outer = outer;
      s.wall = wall;
      s.fabrication = share;
      s.ovality = 0.01;
      const double p = PipeCodes(s).collapse();
      const double elastic = 2 * 207e9 * std::pow(wall / outer, 3) / 0.91;
      const double yields = 450e6 * share * 2 * wall / outer;
      const auto difference = [&](double x) {
        return (x - elastic) * (x * x - yields * yields) - x * elastic * yields * 0.01 * outer / wall;
      };
      EXPECT_GT(difference(p * (1 - 1e-9)), 0);
      EXPECT_LT(difference(p * (1 + 1e-9)), 0);
      for (int k = 1; k < 1000; ++k) EXPECT_GT(difference(p * k / 1000), 0);  // the smallest root
    }
}

TEST(PipeCodes, PressuresAlone) {
  const PipeCodes p(sixteen());
  EXPECT_NEAR(p.local_buckling({0, 0}, p.collapse() / (1.15 * 1.04), 0), 1, 1e-12);
  const double beta = (60 - 0.4064 / 0.021) / 90;
  const double flow = 1 - beta + beta * 535 / 450;
  EXPECT_NEAR(p.flow_stress(), flow, 1e-12);
  for (const double share : {0.3, 0.9}) {
    const double weaker = share < 2.0 / 3 ? 1 - beta : 1 - 3 * beta * (1 - share);
    EXPECT_NEAR(p.local_buckling({0, 0}, 0, share * p.burst()), std::pow(weaker * share / flow, 2), 1e-12);
  }
  EXPECT_NEAR(p.burst(), 2 * 0.021 / (0.4064 - 0.021) * 450e6 * 2 / std::sqrt(3.0), 1);
}

TEST(PipeCodes, TensionAlone) {
  const PipeCodes p(sixteen());
  EXPECT_NEAR(p.plastic_tension(), M_PI * 450e6 * (0.4064 - 0.021) * 0.021, 1);
  const double by_hand = std::pow(1.15 * 1.04 * 0.3 / p.flow_stress(), 4);
  EXPECT_NEAR(p.local_buckling({0, 0.3 * p.plastic_tension()}, 0, 0), by_hand, 1e-12);
  EXPECT_NEAR(p.pulled({0, 0, 1e6}, {0, 0, 2e6}, 1) * p.plastic_tension(), 1.1e6 + 1.3e6, 1e-3);
}

// gamma_F is 1/1.1 for relieving functional loads; gamma_C applies to functional loads; moments are added by
// components.
TEST(PipeCodes, FunctionalAndEnvironmentalLoads) {
  const PipeCodes p(sixteen());
  const auto moment = [&](const PipeLoads& rest, const PipeLoads& now, double condition) {
    return std::sqrt(p.local_buckling(rest, now, condition, 0, 0)) * p.flow_stress() * p.plastic_moment() /
           (1.15 * 1.04);
  };
  const auto in_kN = [&](const PipeLoads& rest, const PipeLoads& now, double condition = 1) {
    return moment(rest, now, condition) / 1e3;
  };
  const PipeLoads rest{100e3, 0, 0};
  EXPECT_NEAR(in_kN(rest, rest), 120, 1e-6);                        // combination a
  EXPECT_NEAR(in_kN(rest, {300e3, 0, 0}), 110 + 260, 1e-6);         // combination b
  EXPECT_NEAR(in_kN(rest, {-100e3, 0, 0}), 260 - 100 / 1.1, 1e-6);  // relieving functional load
  EXPECT_NEAR(in_kN(rest, {-100e3, 0, 0}, 0.8), 260 - 80 / 1.1, 1e-6);
  EXPECT_NEAR(in_kN(rest, {100e3, 200e3, 0}), std::hypot(110, 260), 1e-6);
}

TEST(PipeCodes, ApiRp1111) {
  PipeSteel s = sixteen();
  const double inner = 0.4064 - 0.042;
  const double area = M_PI / 4 * (0.4064 * 0.4064 - inner * inner);
  const double p_y = 2 * 450e6 * 0.021 / 0.4064;
  const double p_el = 2 * 207e9 * std::pow(0.021 / 0.4064, 3) / 0.91;
  const double p_c = p_y * p_el / std::hypot(p_y, p_el);
  for (const bool expanded : {true, false})
    for (const double oval : {0.005, 0.02}) {
      s.cold_expanded = expanded;
      s.ovality = oval;
      const PipeCodes p(s);
      EXPECT_NEAR(p.bending_and_pressure(0, (expanded ? 0.6 : 0.7) * p_c, 0), 1, 1e-12);
      // The strain t/2D divided by 3.33 and multiplied by g has a utilisation of 1; internal pressure does
      // not reduce it.
      EXPECT_NEAR(p.bending_and_pressure(0.021 / (2 * 0.4064) / 3.33 / (1 + 10 * oval), 0, 1e6), 1, 1e-12);
    }
  const PipeCodes p(s);
  EXPECT_NEAR(p.tension_and_pressure(0.6 * 450e6 * area, 0, 0), 1, 1e-12);
  const double p_b = 0.45 * 985e6 * std::log(0.4064 / inner);
  EXPECT_NEAR(p.tension_and_pressure(0.3 * 450e6 * area, 0, 0.85 * p_b), std::hypot(0.85, 0.3) / 0.9, 1e-12);
}

}  // namespace
}  // namespace hawser::test::pipe_codes_test
