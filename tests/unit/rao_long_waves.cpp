// Response tables in the conventions of other programs, by their longest waves.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "hawser/advice/rao_tables.hpp"

namespace hawser::rao_long_waves_test {
namespace {

using Row = RaoTable::Row;
constexpr double kGravity = 9.81;
constexpr std::complex<double> kI(0, 1);

// A vessel that moves as a point of the water in waves of 10 to 40 s and a third less in shorter ones.
std::vector<Row> table(const std::vector<double>& directions = {0, 30, 90, 135, 180}) {
  std::vector<Row> rows;
  for (const double direction : directions)
    for (const double period : {8.0, 16.0, 32.0, 40.0}) {
      Row row;
      row.omega = 2 * M_PI / period;
      row.direction = direction * M_PI / 180;
      const double k = row.omega * row.omega / kGravity;
      const double size = period < 10 ? 0.3 : period < 20 ? 0.8 : 1;
      const double c = std::cos(row.direction);
      const double s = std::sin(row.direction);
      row.response = {-kI * (size * c), -kI * (size * s), size, -kI * (size * k * s), kI * (size * k * c), 0};
      rows.push_back(row);
    }
  return rows;
}

std::vector<std::string> notes(std::vector<Row> rows, const std::function<void(Row&)>& change) {
  for (Row& row : rows) change(row);
  return advice::odd_in_long_waves("bodies.ship.motion.rao", rows, kGravity);
}

void expect(const std::function<void(Row&)>& change, const std::string& part) {
  const std::vector<std::string> found = notes(table(), change);
  ASSERT_EQ(found.size(), 1U) << part << "\n" << testing::PrintToString(found);
  EXPECT_NE(found.front().find("bodies.ship.motion.rao: in its longest waves, "), std::string::npos);
  EXPECT_NE(found.front().find(part), std::string::npos) << part << "\n" << found.front();
}

void scale(Row& row, double factor) {
  for (std::complex<double>& r : row.response) r *= factor;
}

TEST(RaoLongWaves, NoneOfAVesselThatFollowsTheWater) {
  const std::vector<std::string> none;
  EXPECT_EQ(notes(table(), [](Row&) {}), none);
  // A resonance of heave and pitch, for which the response lags.
  EXPECT_EQ(notes(table(),
                  [](Row& row) {
                    row.response[2] *= 3.0 * std::polar(1.0, -row.omega * 5);
                    row.response[4] *= -4.0;
                  }),
            none);
  // Long directions of shallow water, and a body that does not surge.
  EXPECT_EQ(notes(table(), [](Row& row) { row.response[0] *= 1.8; }), none);
  EXPECT_EQ(notes(table(), [](Row& row) { row.response[0] = 0; }), none);
}

// A cylinder of 150 m draught with a natural period of 27 s: heave is e^(-k T)/(1 - (omega/omega_n)²) without
// added mass, against the waves and steep in the period.
TEST(RaoLongWaves, NoneOfASparBelowItsNaturalPeriod) {
  std::vector<Row> rows;
  for (const double period : {8.0, 22.5, 23.0, 23.5}) {
    Row row;
    row.omega = 2 * M_PI / period;
    const double k = row.omega * row.omega / kGravity;
    const double heave = std::exp(-k * 150) / (1 - std::pow(27 / period, 2));
    row.response = {-kI, 0, heave, 0, kI * k, 0};
    rows.push_back(row);
  }
  EXPECT_GT(std::abs(rows.back().response[2]), 0.85);
  EXPECT_EQ(notes(rows, [](Row&) {}), std::vector<std::string>());
}

TEST(RaoLongWaves, OtherConventions) {
  const auto conjugate = [](Row& row) {
    for (std::complex<double>& r : row.response) r = std::conj(r);
  };
  const char* const kAgainst =
      "the vessel moves against the water: are directions those from which the waves come";
  expect(conjugate, kAgainst);
  expect([](Row& row) { row.direction += M_PI; }, kAgainst);
  expect([](Row& row) { row.direction = -row.direction; }, "sway is opposite to the motion of the water");
  expect([](Row& row) { row.response[0] = -row.response[0]; },
         "surge is opposite to the motion of the water");
  expect([](Row& row) { row.response[2] = -row.response[2]; }, "heave is opposite to the elevation");
  expect([](Row& row) { row.response[4] = -row.response[4]; }, "pitch is opposite to the slope of the water");
  expect([](Row& row) { scale(row, -1); }, "do the phases refer to the trough");
  expect([](Row& row) { scale(row, 0.5); },
         "it heaves 0.5 m: are the amplitudes those for 1 m of wave height");
  expect([](Row& row) { scale(row, 2); }, "it heaves 2 m: are the amplitudes from crest to trough");
  const std::vector<std::string> both = notes(table(), [&](Row& row) {
    conjugate(row);
    scale(row, 0.5);
  });
  EXPECT_EQ(both.size(), 2U) << testing::PrintToString(both);
  // Waves from one side only.
  const std::vector<std::string> beam = notes(table({90}), conjugate);
  ASSERT_EQ(beam.size(), 1U);
  EXPECT_NE(beam.front().find(kAgainst), std::string::npos) << beam.front();
}

TEST(RaoLongWaves, NoneOfShortWaves) {
  std::vector<Row> rows = table();
  for (Row& row : rows) row.omega *= 3;
  EXPECT_TRUE(notes(rows, [](Row& row) { scale(row, 0.5); }).empty());
}

}  // namespace
}  // namespace hawser::rao_long_waves_test
