// Statistics over steps of any length equal those of the piecewise linear curve.
#include "hawser/record/node_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hawser::record {
namespace {

const std::vector<io::ResultField> kFields = {{"position", "m", 3},
                                              {.name = "effective_tension", .unit = "N", .statistics = true},
                                              {.name = "curvature", .unit = "1/m", .statistics = true}};

std::vector<std::vector<double>> values(double tension, double curvature) {
  return {std::vector<double>(6, 7), {tension, 2 * tension}, {curvature, -curvature}};
}

// Steps of varying length over ten periods of 1000 + 50 sin(2 pi t).
template <class Each>
void wave(Each&& each) {
  for (double t = 0, h = 0.002; t < 10; t += h) {
    each(t, 1000 + 50 * std::sin(2 * M_PI * t));
    h = 0.002 * (1.5 + std::sin(3 * t));
  }
  each(10.0, 1000);
}

std::vector<std::vector<double>> tables(const NodeStatistics& s) {
  std::vector<std::vector<double>> all;
  for (std::size_t f = 0; f < s.fields().size(); ++f) all.push_back(s.table(f));
  return all;
}

TEST(NodeStatistics, OfASineWithStepsOfAnyLength) {
  NodeStatistics s(kFields, 2, 0);
  ASSERT_EQ(s.fields().size(), 2u);
  EXPECT_EQ(s.fields()[0].name, "effective_tension");
  wave([&](double t, double v) { s.add(t, values(v, 0.5)); });
  const auto all = tables(s);
  ASSERT_EQ(all[0].size(), 2u * io::kStatistics);
  const double* row = all[0].data();
  EXPECT_NEAR(row[0], 950, 0.01);
  EXPECT_NEAR(std::fmod(row[1], 1), 0.75, 0.005);
  EXPECT_NEAR(row[2], 1050, 0.01);
  EXPECT_NEAR(std::fmod(row[3], 1), 0.25, 0.005);
  EXPECT_NEAR(row[4], 1000, 1e-3);
  EXPECT_NEAR(row[5], 50 / std::sqrt(2.0), 2e-3);
  EXPECT_NEAR(all[0][io::kStatistics + 4], 2000, 2e-3);  // of the second node
  // Constant values have no deviation.
  EXPECT_EQ(all[1][0], 0.5);
  EXPECT_EQ(all[1][2], 0.5);
  EXPECT_DOUBLE_EQ(all[1][4], 0.5);
  EXPECT_EQ(all[1][5], 0);
  EXPECT_EQ(all[1][io::kStatistics], -0.5);
}

// The checkpoint as it is read back from a file.
io::Checkpoint written(io::Checkpoint c) {
  for (auto& [name, field] : c.nodes) field.values = field.make();
  return c;
}

// Values that exist only from 0 to 1 s and from 3 to 4 s, also if a checkpoint is between.
TEST(NodeStatistics, ExcludeMissingValues) {
  NodeStatistics first(kFields, 2, 0), s(kFields, 2, 0);
  const double none = std::nan("");
  first.add(0, values(none, none));
  first.add(0.5, values(0, none));
  first.add(1, values(1, none));
  first.add(2, values(none, none));
  io::Checkpoint kept;
  first.save(kept);
  s.restore(written(kept));
  s.add(3, values(4, none));
  s.add(4, values(6, none));
  const std::vector<double> tension = s.table(0);
  const std::vector<double> curvature = s.table(1);
  // 0.5 s with mean 0.5 and variance 1/12 of its square, and 1 s with mean 5 and variance 4/12.
  const double mean = (0.5 * 0.5 + 5) / 1.5;
  const double square = (0.5 * (0.25 + 1.0 / 12) + 25 + 4.0 / 12) / 1.5;
  EXPECT_EQ(tension[0], 0);
  EXPECT_EQ(tension[1], 0.5);
  EXPECT_EQ(tension[2], 6);
  EXPECT_EQ(tension[3], 4);
  EXPECT_NEAR(tension[4], mean, 1e-14);
  EXPECT_NEAR(tension[5], std::sqrt(square - mean * mean), 1e-13);
  for (size_t i = 0; i < io::kStatistics; ++i) EXPECT_TRUE(std::isnan(curvature[i])) << i;
}

// A straight line from 0 to 1: mean 1/2, variance 1/12, also in one step.
TEST(NodeStatistics, OfAStraightLineAreExact) {
  for (const int steps : {1, 3, 100}) {
    NodeStatistics s(kFields, 2, 0);
    for (int i = 0; i <= steps; ++i) {
      const double t = std::pow(static_cast<double>(i) / steps, 2);
      s.add(t, values(t, 0));
    }
    const auto all = tables(s);
    EXPECT_NEAR(all[0][4], 0.5, 1e-14);
    EXPECT_NEAR(all[0][5], std::sqrt(1.0 / 12), 1e-14);
  }
}

TEST(NodeStatistics, BeginAtTheTimeOfTheCase) {
  NodeStatistics s(kFields, 2, 2.5);
  s.add(0, values(100, 0));
  s.add(2, values(100, 0));
  EXPECT_TRUE(std::isnan(tables(s)[0][0]));
  s.add(3, values(10, 0));
  s.add(4, values(20, 0));
  const auto all = tables(s);
  EXPECT_EQ(all[0][0], 10);
  EXPECT_EQ(all[0][1], 3);
  EXPECT_EQ(all[0][2], 20);
  EXPECT_EQ(all[0][3], 4);
  EXPECT_DOUBLE_EQ(all[0][4], 15);
}

TEST(NodeStatistics, GoOnFromACheckpoint) {
  NodeStatistics whole(kFields, 2, 0), half(kFields, 2, 0), rest(kFields, 2, 0), empty(kFields, 2, 0);
  io::Checkpoint c;
  bool saved = false;
  wave([&](double t, double v) {
    whole.add(t, values(v, t));
    if (t < 4) {
      half.add(t, values(v, t));
      return;
    }
    if (!saved) {
      half.save(c);
      rest.restore(written(c));
      saved = true;
    }
    rest.add(t, values(v, t));
  });
  EXPECT_EQ(tables(whole), tables(rest));
  // Older files have no statistics: these start again.
  empty.restore({});
  EXPECT_TRUE(std::isnan(tables(empty)[0][0]));
}

}  // namespace
}  // namespace hawser::record
