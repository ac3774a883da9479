// Valid case files of the sea and the bed, with tables from a file or in the case.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "hawser/io/case_reader.hpp"
#include "hawser/model/summary.hpp"

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

}  // namespace
}  // namespace hawser::case_sea_test
