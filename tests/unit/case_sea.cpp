// Valid case files of the sea and the bed, with tables from a file or in the case.
#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "hawser/io/case_reader.hpp"
#include "hawser/model/summary.hpp"
#include "hawser/model/wave_components.hpp"

namespace hawser::case_sea_test {
namespace {

namespace fs = std::filesystem;

model::Case read(const std::string& environment, const fs::path& folder = HAWSER_SOURCE_DIR "/tests/data/bad",
                 const std::string& height = "0") {
  return io::read_case_text("hawser: 1\nenvironment: " + environment +
                                "\nline_types: {hose: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, "
                                "EI: 1e4, GJ: 1e4}}\nlines: {a: {sections: [{type: hose, length: 10, "
                                "elements: 2}], end_a: {anchor: [0, 0, " +
                                height + "]}, end_b: free}}\n",
                            (folder / "text.yaml").string());
}

void expect_part(const model::Case& c, const char* part) {
  const std::string s = model::summary(c);
  EXPECT_NE(s.find(part), std::string::npos) << part << "\n" << s;
}

TEST(CaseSea, TimeFactorOfTheCurrent) {
  const fs::path folder = fs::path(testing::TempDir()) / "hawser_factor";
  fs::create_directories(folder);
  std::ofstream(folder / "tide.txt") << "# t factor\n0 1\n\n3600, -0.5  # back\n";
  const std::vector<TimeFactor::Row> rows{{0, 1}, {3600, -0.5}};
  for (const char* table : {"{file: tide.txt}", "{rows: [[0, 1], [3600, -0.5]]}"}) {
    const model::Case c =
        read(std::string("{water: {}, current: {speed: 1, ramp: 5, time_factor: ") + table + "}}", folder);
    const model::Current& current = c.environment.water.current;
    EXPECT_EQ(current.time_factor.rows(), rows);
    EXPECT_EQ(current.ramp, 5);
    expect_part(c, "times a factor by 2 rows from 0 to 3600 s");
  }
  EXPECT_TRUE(read("{water: {}, current: {speed: 1}}").environment.water.current.time_factor.rows().empty());
}

TEST(CaseSea, SeabedByTable) {
  for (const bool by_length : {false, true}) {
    const std::string per = by_length ? "length" : "area";
    const model::Case c = read(
        "{seabed: {depth: 90, normal_stiffness: {table: [[0.01, 100], [0.05, 2e3]], per: " + per + "}}}");
    const model::Seabed& bed = c.environment.seabed;
    EXPECT_EQ(bed.basis, by_length ? model::StiffnessBasis::per_length : model::StiffnessBasis::per_area);
    ASSERT_TRUE(bed.force_table);
    EXPECT_NEAR(bed.force_table->at(0.01).force, 100, 1e-9);
    EXPECT_EQ(bed.normal_stiffness, bed.force_table->largest_slope());
    expect_part(c, ("force by a table of 2 rows up to 0.05 m per " + per).c_str());
  }
}

TEST(CaseSea, AnAnchorUnderTheSeabedIsReported) {
  const auto notes = [](const char* height) {
    return read("{water: {}, seabed: {depth: 90}}", HAWSER_SOURCE_DIR "/tests/data/bad", height).notes;
  };
  ASSERT_EQ(notes("-90.15").size(), 1U);
  EXPECT_NE(
      notes("-90.15")[0].find(
          "lines.a.end_a.anchor: is 0.15 m below the seabed, so the program lowers the seabed there along "),
      std::string::npos)
      << notes("-90.15")[0];
  EXPECT_TRUE(notes("-90.05").empty());  // within half a diameter: the rest position
  EXPECT_TRUE(notes("-89.9").empty());
}

TEST(CaseSea, SuctionOfTheSeabed) {
  const model::Case c = read("{seabed: {depth: 90, suction: {limit: 2e3, length: 50 mm}}}");
  EXPECT_EQ(c.environment.seabed.suction, 2000);
  EXPECT_EQ(c.environment.seabed.suction_length, 0.05);
  expect_part(c, "suction up to 2000 N/m² over 0.05 m");
}

// The smooth surface of a grid overshoots its heights beside a cliff, which a note reports; on a slope there
// is no note.
TEST(CaseSea, GridWithAStep) {
  const fs::path folder = fs::path(testing::TempDir()) / "hawser_step";
  fs::create_directories(folder);
  const auto notes = [&](double rise, double slope) {
    std::ofstream file(folder / "bed.xyz");
    for (int x = -200; x <= 200; x += 10)
      for (int y = -20; y <= 20; y += 10)
        file << x << " " << y << " " << -100 + (x < 0 ? 0 : rise) + slope * x << "\n";
    file.close();
    std::vector<std::string> out;
    for (const std::string& n : read("{seabed: {grid: {file: bed.xyz}}}", folder).notes)
      if (n.find("the smooth surface") != std::string::npos) out.push_back(n);
    return out;
  };
  const auto cliff = notes(10, 0);
  ASSERT_EQ(cliff.size(), 1U);
  EXPECT_TRUE(cliff[0].starts_with("environment.seabed.grid: the smooth surface through the heights of "))
      << cliff[0];
  EXPECT_NE(cliff[0].find("bed.xyz goes 1.1 m "), std::string::npos) << cliff[0];
  EXPECT_NE(
      cliff[0].find(
          ", beside a step or a bend, and less elsewhere; if lines come there, give more heights across the "
          "step, or a mesh"),
      std::string::npos)
      << cliff[0];
  EXPECT_TRUE(notes(0.9, 0).empty());  // 0.097 m
  EXPECT_TRUE(notes(0, 0.5).empty());
}

std::vector<WaveComponent> components(const std::string& waves) {
  return model::wave_field(read("{water: {depth: 300}, waves: {" + waves + "}}").environment).components();
}

bool equal(const WaveComponent& a, const WaveComponent& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

struct Moments {
  double energy = 0;     // m²
  double direction = 0;  // deg, mean by energy
};
Moments moments(const std::vector<WaveComponent>& all, size_t first, size_t count) {
  Moments m;
  std::complex<double> sum = 0;
  for (size_t i = first; i < first + count; ++i) {
    const double energy = 0.5 * all[i].amplitude * all[i].amplitude;
    m.energy += energy;
    sum += energy * std::complex<double>(all[i].x, all[i].y);
  }
  m.direction = std::arg(sum) * 180 / M_PI;
  return m;
}

// Energy and direction of each system are those of the case, and the components of the first are those of the
// same system alone.
TEST(CaseSea, SumOfWaveSystems) {
  const std::string wind_sea = "jonswap: {hs: 3, tp: 8, gamma: 2, direction_deg: 20, components: 80}";
  const std::string waves =
      "sum: [{" + wind_sea +
      "}, {pierson_moskowitz: {hs: 2, tp: 15, direction_deg: 110, spreading: 20, components: 60}}, {regular: "
      "{height: 1, period: 20, direction_deg: -90, phase_deg: 30}}], stretching: vertical";
  const std::vector<WaveComponent> all = components(waves);
  ASSERT_EQ(all.size(), 141U);
  const Moments first = moments(all, 0, 80);
  const Moments second = moments(all, 80, 60);
  const Moments third = moments(all, 140, 1);
  EXPECT_NEAR(first.energy, 9.0 / 16, 1e-12);
  EXPECT_NEAR(second.energy, 4.0 / 16, 1e-12);
  EXPECT_NEAR(third.energy, 1.0 / 8, 1e-12);
  EXPECT_NEAR(first.direction, 20, 1e-9);
  EXPECT_NEAR(second.direction, 110, 0.5);
  EXPECT_NEAR(third.direction, -90, 1e-9);
  EXPECT_NEAR(all[140].omega, 2 * M_PI / 20, 1e-12);
  EXPECT_NEAR(all[140].phase, M_PI / 6, 1e-12);
  const std::vector<WaveComponent> alone = components(wind_sea);
  for (size_t i = 0; i < 80; ++i) EXPECT_TRUE(equal(all[i], alone[i])) << i;
  const model::Case c = read("{water: {depth: 300}, waves: {" + waves + "}}");
  EXPECT_EQ(c.environment.water.waves.ramp, 20);
  EXPECT_EQ(c.environment.water.waves.stretching, Stretching::vertical);
  expect_part(
      c,
      ", a sea of Hs 3.873 m in 3 systems: waves of Hs 3 m, Tp 8 s in 80 components, seed 1; waves of "
      "Hs 2 m, Tp 15 s in 60 components, seed 1; a wave of 1 m and 20 s\n");
}

TEST(CaseSea, OneSystemInASumIsTheSameSea) {
  for (const std::string waves :
       {"jonswap: {hs: 3, tp: 8, direction_deg: 20, spreading: 4, seed: 5}",
        "pierson_moskowitz: {hs: 3, tp: 8}", "spectrum: {rows: [[0.05, 0], [0.1, 9], [0.2, 0]], seed: 2}",
        "regular: {height: 2, period: 9}", "components: [{height: 2, period: 9}, {height: 1, period: 7}]"}) {
    const std::vector<WaveComponent> alone = components(waves);
    const std::vector<WaveComponent> in_sum = components("sum: [{" + waves + "}]");
    ASSERT_EQ(alone.size(), in_sum.size());
    for (size_t i = 0; i < alone.size(); ++i) EXPECT_TRUE(equal(alone[i], in_sum[i])) << waves << i;
  }
}

// The mean of exp(i (phase difference)) of n independent pairs is about 1/sqrt(n).
TEST(CaseSea, SystemsOfOneSeedHaveIndependentPhases) {
  constexpr size_t kCount = 400;
  for (const std::string seed : {"1", "2", "77"}) {
    const std::string one = "{jonswap: {hs: 3, tp: 9, components: 400, seed: " + seed + "}}";
    const std::vector<WaveComponent> all = components("sum: [" + one + ", " + one + ", " + one + "]");
    ASSERT_EQ(all.size(), 3 * kCount);
    for (const auto& [a, b] : {std::pair{0, 1}, {0, 2}, {1, 2}})
      for (size_t shift = 0; shift < 3; ++shift) {
        std::complex<double> sum = 0;
        for (size_t i = 0; i + shift < kCount; ++i)
          sum += std::polar(1.0, all[a * kCount + i + shift].phase - all[b * kCount + i].phase);
        EXPECT_LT(std::abs(sum), 4 * std::sqrt(kCount)) << seed << " " << a << " " << b << " " << shift;
      }
  }
}

// The height of an anchor above a sloped bed is vertical; its distance from the bed is half of that at 60
// deg.
TEST(CaseSea, AnchorsAboveASlopedBed) {
  const auto noted = [](const char* height) {
    const model::Case c = read("{water: {depth: 100}, seabed: {depth: 100, slope_deg: 60}}", ".", height);
    return std::count_if(c.notes.begin(), c.notes.end(), [](const std::string& n) {
      return n.find("is 18 m above the seabed, which is at z = -100 m there") != std::string::npos;
    });
  };
  EXPECT_EQ(noted("-82"), 1);
  EXPECT_EQ(noted("-91"), 0);
}

}  // namespace
}  // namespace hawser::case_sea_test
