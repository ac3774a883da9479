// History transported along a line: integrals are conserved, extremes do not increase, and the work of
// material that enters and leaves equals closed forms.
#include "hawser/kernels/plastic_history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hawser/math/so3.hpp"

namespace hawser::test::plastic_history {
namespace {

using Values = std::vector<double>;
using Cells = std::vector<RememberedCell>;

void add(Cells& to, double from, double end, const Values& v) {
  for (const RememberedCell& c : remembered_cells(from, end, v.data(), v.size() / 3)) to.push_back(c);
}
double sum(double from, double to, const Values& v) {
  double all = 0;
  for (const RememberedCell& c : remembered_cells(from, to, v.data(), 1))
    all += (c.to - c.from) * c.values[0];
  return all;
}

// Elements are divided and joined: integrals over the length are conserved, and no value exceeds the earlier
// ones.
TEST(PlasticHistory, DividedAndJoined) {
  const Values whole{1, 3, 2};
  Cells cells;
  add(cells, 0, 1.4, whole);
  Values a(3), b(3), both(3);
  remember_cells(cells, 1, 0, 0.9, a.data());
  remember_cells(cells, 1, 0.9, 1.4, b.data());
  EXPECT_NEAR(sum(0, 0.9, a) + sum(0.9, 1.4, b), sum(0, 1.4, whole), 1e-14);
  cells.clear();
  add(cells, 0, 0.9, a);
  add(cells, 0.9, 1.4, b);
  remember_cells(cells, 1, 0, 1.4, both.data());
  EXPECT_NEAR(sum(0, 1.4, both), sum(0, 1.4, whole), 1e-14);
  EXPECT_GE(*std::min_element(both.begin(), both.end()), 1);
  EXPECT_LE(*std::max_element(both.begin(), both.end()), 3);
}

// Material with values 1 over the first 0.4 m, then 0, then 3, is paid out in many steps and hauled in again.
TEST(PlasticHistory, PaidOutAndHauledIn) {
  Values now{1, 1, 1};
  const Values none{0}, more{3};
  double length = 0.4, expected = 0.4;
  for (int i = 0; i < 300; ++i) {
    const Values old = now;
    const double to = length + 0.002;
    Cells cells;
    add(cells, 0, length, old);
    cells.push_back({length, to, (i < 150 ? none : more).data()});
    remember_cells(cells, 1, 0, to, now.data());
    expected += 0.002 * (i < 150 ? 0 : 3);
    length = to;
    EXPECT_NEAR(sum(0, length, now), expected, 1e-12);
    EXPECT_GE(*std::min_element(now.begin(), now.end()), 0);
    EXPECT_LE(*std::max_element(now.begin(), now.end()), i < 150 ? 1 : 3);
  }
  printf("  1 over 0.4 m, then 0 over 0.3 m, then 3 over 0.3 m: %.3f %.3f %.3f\n", now[0], now[1], now[2]);
  EXPECT_GT(now[2], 2);
  EXPECT_NEAR(now[0], 1, 0.15);  // an edge is spread over the cells that it passed
  // Uniform values stay uniform.
  for (const double to : {0.7, 0.3, 0.9}) {
    const Values same{2, 2, 2};
    Cells cells;
    add(cells, 0, 0.5, same);
    cells.push_back({0.5, 1, same.data()});
    remember_cells(cells, 1, 0, to, now.data());
    for (const double v : now) EXPECT_NEAR(v, 2, 1e-14);
  }
}

PlasticBending law() {
  return PlasticBending(std::vector<PlasticBending::Row>{{0.02, 100e3}, {0.06, 140e3}, {0.5, 200e3}});
}

BeamSection section(const PlasticBending& p, bool yields) {
  BeamSection s;
  s.length = 0.8;
  s.EA = 1e9;
  s.EI2 = s.EI3 = p.initial();
  s.GJ = 4e6;
  if (yields) s.plastic = &p;
  return s;
}

// Rotated by these angles at the ends [rad].
BeamEnds bent(double length, const Vec3& at1, const Vec3& at2) {
  return {Vec3::Zero(), Vec3(length, 0, 0), Quat(exp_so3(at1)), Quat(exp_so3(at2))};
}

// Below yield a feeder works against the bending energy M²/2EI for any shape, at either end.
TEST(PlasticHistory, WorkOnElasticBends) {
  const PlasticBending p = law();
  const BeamEnds e = bent(0.79, {0, 0.0015, -0.0007}, {0, -0.003, 0.0025});
  const Values never(p.memory(), 0);
  const BeamSection linear = section(p, false);
  const BeamSection yields = section(p, true);
  const double feeder_force = beam_feed(linear, {}, e).force - beam_feed(yields, {}, e).force;
  EXPECT_GT(feeder_force, 50);
  for (const bool second_end : {false, true})
    for (const double* entering : {never.data(), static_cast<const double*>(nullptr)})
      EXPECT_NEAR(fed_bending_work(yields, {}, e, second_end, entering), -feeder_force, 1e-9 * feeder_force)
          << second_end;
}

// A yielded arc: material that enters is bent from straight along the first curve; material that leaves
// returns the recoverable energy and removes the locked-in energy.
TEST(PlasticHistory, WorkOnAnArcThatYielded) {
  const PlasticBending p = law();
  const BeamSection s = section(p, true);
  const double c = 0.2;
  const double M = p.at(c, 0, nullptr).m[0];
  const BeamEnds e = bent(0.79, {0, -0.5 * c * s.length, 0}, {0, 0.5 * c * s.length, 0});
  Values set(3 * p.memory(), 0);
  beam_bend(s, {}, e, set.data());
  BeamReference r;
  r.set = set.data();
  const Values never(p.memory(), 0);
  const double area =
      0.5 * 0.02 * 100e3 + 0.04 * 120e3 + 0.14 * 0.5 * (140e3 + M);  // area below the curve, by hand
  Values one(p.memory(), 0);
  p.bend(c, 0, one.data());
  const double stored = p.at(c, 0, one.data()).energy;
  for (const bool second_end : {false, true}) {
    EXPECT_NEAR(fed_bending_work(s, r, e, second_end, never.data()), area - M * c, 1e-6 * M * c);
    EXPECT_NEAR(fed_bending_work(s, r, e, second_end, nullptr), stored - M * c, 1e-6 * M * c);
  }
}

}  // namespace
}  // namespace hawser::test::plastic_history
