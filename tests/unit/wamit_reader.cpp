// WAMIT's files: scales, missing rows, gzip files, and refusals.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "hawser/io/hydrodynamic_files.hpp"
#include "hawser/model/platform.hpp"

namespace hawser::wamit_reader_test {
namespace {

class WamitReader : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / "hawser_wamit" / test->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    write(".1", kRadiation);
    write(".hst", "3 3 2.0\n4 4 5.0\n5 5 6.0\n3 5 0.5\n5 3 0.5\n");
    write(".3", kExcitation);
  }
  void write(const std::string& ending, const std::string& text) { std::ofstream(stem() + ending) << text; }
  std::string stem() const { return (folder_ / "body").string(); }
  model::HydrodynamicData read(SecondOrder order = SecondOrder::none) {
    return io::read_wamit(stem(), form, order, files, notes);
  }
  std::string refusal(SecondOrder order = SecondOrder::none) {
    try {
      read(order);
    } catch (const std::runtime_error& e) {
      return e.what();
    }
    return "";
  }
  io::HydrodynamicForm form{2, 1000, 10};
  std::vector<std::string> files, notes;

 private:
  static constexpr const char* kRadiation =
      "PER I J Abar Bbar\n"
      "-1 1 1 0.7\n 0 1 1 0.5\n 0 3 3 0.25\n 0 1 5 0.3\n 0 5 1 0.3\n 0 5 5 0.4\n"
      "6.283185307179586 1 1 0.6 0.1\n6.283185307179586 1 5 0.3 0.02\n6.283185307179586 5 1 0.3 0.02\n"
      "6.283185307179586 5 5 0.4 0.3\n3.141592653589793 1 5 0.3 0.02\n3.141592653589793 5 1 0.3 0.02\n"
      "3.141592653589793 1 1 0.55 0.05\n3.141592653589793 5 5 0.4 0.3\n";
  static constexpr const char* kExcitation =
      "6.283185307179586 -180 3 2.23607 63.4349 1 2\n6.283185307179586 0 3 5 53.1301 3 4\n6.283185307179586 "
      "0 5 7.81025 50.1944 5 6\n"
      "3.141592653589793 -180 3 10.6301 48.8141 7 8\n3.141592653589793 0 3 13.4536 48.0128 9 10\n"
      "3.141592653589793 0 5 15.6205 50.1944 10 12\n";
  std::filesystem::path folder_;
};

// rho = 1000 and L = 2: A11 = rho L³ Abar, A15 with L⁴, A55 with L⁵, B with omega.
TEST_F(WamitReader, ScalesByLengthDensityAndFrequency) {
  const model::HydrodynamicData d = read();
  EXPECT_EQ(d.bodies, 1);
  ASSERT_EQ(d.omega.size(), 2u);
  EXPECT_NEAR(d.omega[0], 1, 1e-14);
  EXPECT_NEAR(d.omega[1], 2, 1e-14);
  EXPECT_NEAR(d.added_mass[0](0, 0), 0.6 * 8000, 1e-9);
  EXPECT_NEAR(d.added_mass[0](0, 4), 0.3 * 16000, 1e-9);
  EXPECT_NEAR(d.damping[1](4, 4), 0.3 * 32000 * 2, 1e-9);
  EXPECT_EQ(d.damping[1](2, 2), 0);
  EXPECT_NEAR(d.infinite(0, 0), 0.5 * 8000, 1e-9);
  EXPECT_FALSE(d.infinite_estimated);
  EXPECT_NEAR(d.hydrostatic(2, 2), 2 * 1e4 * 4, 1e-9);
  EXPECT_NEAR(d.hydrostatic(2, 4), 0.5 * 1e4 * 8, 1e-9);
  EXPECT_NEAR(d.hydrostatic(4, 4), 6 * 1e4 * 16, 1e-9);
  ASSERT_EQ(d.excitation.size(), 1u);
  const ComplexVec6 ahead = d.excitation[0].at(1, 0);
  const ComplexVec6 astern = d.excitation[0].at(2, M_PI);
  EXPECT_NEAR(std::abs(ahead[2] - 4e4 * Complex(3, 4)), 0, 1e-9);
  EXPECT_NEAR(std::abs(ahead[4] - 8e4 * Complex(5, 6)), 0, 1e-9);
  EXPECT_NEAR(std::abs(astern[2] - 4e4 * Complex(7, 8)), 0, 1e-9);
  EXPECT_EQ(files.size(), 3u);
}

// Sway in a wave to 315 deg is the reverse of that to 45 deg; 270 deg is interpolated between 180 and 315
// deg.
TEST_F(WamitReader, MirrorsTheOtherSide) {
  std::string rows;
  for (const int deg : {0, 45, 180})
    for (const char* period : {"6.283185307179586", "3.141592653589793"})
      for (int mode = 1; mode <= 6; ++mode)
        rows += fmt::format("{} {} {} {} {} {} {}\n", period, deg, mode, std::hypot(deg + mode, mode),
                            std::atan2(mode, deg + mode) * 180 / M_PI, deg + mode, mode);
  write(".3", rows);
  form = {1, 1, 1, true};
  const model::HydrodynamicData d = read();
  const WaveForceTable& table = d.excitation[0];
  EXPECT_EQ(table.directions().size(), 4u);
  for (int mode = 1; mode <= 6; ++mode) {
    const double sign = mode % 2 == 0 ? -1 : 1;
    EXPECT_NEAR(std::abs(table.at(1.5, 315 * M_PI / 180)[mode - 1] - sign * Complex(45 + mode, mode)), 0,
                1e-9)
        << mode;
    EXPECT_NEAR(std::abs(table.at(1.5, 45 * M_PI / 180)[mode - 1] - Complex(45 + mode, mode)), 0, 1e-9)
        << mode;
    const Complex between = (2 * sign * Complex(45 + mode, mode) + Complex(180 + mode, mode)) / 3.0;
    EXPECT_NEAR(std::abs(table.at(1.5, 270 * M_PI / 180)[mode - 1] - between), 0, 1e-9) << mode;
  }
  write(".3", rows + "6.283185307179586 300 1 1.41421 45 1 1\n3.141592653589793 300 1 1.41421 45 1 1\n");
  EXPECT_NE(refusal().find("has directions on both sides of the body"), std::string::npos) << refusal();
  write(".3", rows);
  write(".1", "6.28 1 1 1 1\n6.28 7 7 1 1\n3.14 1 1 1 1\n3.14 7 7 1 1\n");
  EXPECT_NE(refusal().find("has 2 bodies, which are no mirror image"), std::string::npos) << refusal();
}

TEST_F(WamitReader, ReadsPackedFiles) {
  std::ifstream in(stem() + ".1");
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  std::filesystem::remove(stem() + ".1");
  gzFile packed = gzopen((stem() + ".1.gz").c_str(), "wb");
  gzwrite(packed, text.data(), static_cast<unsigned>(text.size()));
  gzclose(packed);
  EXPECT_NEAR(read().added_mass[0](0, 0), 0.6 * 8000, 1e-9);
}

// Damping and added mass of a heaving hemisphere (Hulme 1982), whose added mass at infinite frequency is
// 1.047198 a^3 rho/2. Without that row, with frequencies up to 3 rad/s and a tenth of the rows wrong as at
// irregular frequencies, the estimate is within 0.5 %; the mean over the rows would be wrong by 5 %.
TEST_F(WamitReader, EstimatesTheInfiniteFrequencyWithANote) {
  std::ifstream whole(HAWSER_SOURCE_DIR "/tests/data/hemisphere.1");
  std::string text, line;
  int kept = 0;
  while (std::getline(whole, line)) {
    std::istringstream words(line);
    double period = 0, i = 0, j = 0, A = 0, B = 0;
    words >> period >> i >> j >> A >> B;
    if (period < 2 * M_PI / 3) continue;
    if (++kept % 10 == 5) A += 0.5;
    text += fmt::format("{:.7g} 3 3 {:.7g} {:.7g}\n", period, A, B);
  }
  ASSERT_GT(kept, 90);
  write(".1", text);
  const model::HydrodynamicData d = read();
  EXPECT_TRUE(d.infinite_estimated);
  EXPECT_NEAR(d.infinite(2, 2) / (1.047198 * 1000 * 8), 1, 5e-3);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("Ogilvie"), std::string::npos);
}

TEST_F(WamitReader, ReadsDifferenceFrequencies) {
  write(
      ".12d",
      "6.2832 6.2832 0 0 1 4 0 4 0\n6.2832 3.1416 0 0 1 2.23607 26.5651 2 1\n3.1416 3.1416 0 0 1 3 0 3 0\n");
  const model::HydrodynamicData d = read(SecondOrder::full);
  ASSERT_EQ(d.difference.size(), 1u);
  const model::DifferenceForces& of = d.difference[0];
  EXPECT_NEAR(std::abs(of.pairs.at(2, 1)[0] - 2e4 * Complex(2, -1)), 0, 1);
  EXPECT_NEAR(std::abs(of.pairs.at(1, 2)[0] - 2e4 * Complex(2, 1)), 0, 1);
  EXPECT_NEAR(of.drift[0].at(2, 0)[0].real(), 6e4, 1);
  write(".12d", "6.2832 6.2832 0 0 1 4 0 4 0\n3.1416 3.1416 0 0 1 3 0 3 0\n");
  EXPECT_NE(refusal(SecondOrder::full).find("no row for the periods"), std::string::npos);
  write(".12d", "6.2832 6.2832 0 0 1 4 0 4 0\n0 0 0 0 1 4 0 4 0\n");
  EXPECT_NE(refusal(SecondOrder::full).find("above 0 s"), std::string::npos);
  write(".12d", "6.2832 6.2832 0 30 1 4 0 4 0\n");
  EXPECT_NE(refusal(SecondOrder::full).find("two waves of one direction"), std::string::npos);
}

// Rows of two directions: those of equal periods are mean drift forces of both, unless a file .8 has these.
// The forces of all pairs are read of both, and a body has those nearest to the sea's direction from its bow.
TEST_F(WamitReader, ReadsDifferenceFrequenciesOfTwoDirections) {
  std::string text;
  for (const int direction : {0, 30})
    for (const char* row : {"6.2832 6.2832 {0} {0} 1 {1} 0 {1} 0\n", "6.2832 3.1416 {0} {0} 1 {1} 0 {1} 0\n",
                            "3.1416 3.1416 {0} {0} 1 {1} 0 {1} 0\n"})
      text += fmt::format(fmt::runtime(row), direction, direction == 0 ? 4 : 3);
  write(".12d", text);
  const auto is = [](Complex value, double expected) { EXPECT_NEAR(value.real(), expected, 1); };
  for (const SecondOrder order : {SecondOrder::mean, SecondOrder::newman}) {
    const model::HydrodynamicData d = read(order);
    is(d.drift[0].at(2, 0)[0], 8e4);
    is(d.drift[0].at(2, M_PI / 6)[0], 6e4);
  }
  EXPECT_TRUE(notes.empty() || notes[0].find("heave") != std::string::npos);
  model::BodyHydrodynamics h;
  h.data = std::make_shared<model::HydrodynamicData>(read(SecondOrder::full));
  WaveComponent wave;
  wave.amplitude = 1;
  for (const double degrees : {0, 12, 20, 45, 360}) {
    const bool second = degrees > 15 && degrees < 360;
    for (const double turned : {0.0, 2.0}) {
      wave.x = std::cos(turned + degrees * M_PI / 180);
      wave.y = std::sin(turned + degrees * M_PI / 180);
      const model::DifferenceForces& of = model::difference_forces(h, {wave}, turned);
      is(of.pairs.at(1, 2)[0], second ? 6e4 : 8e4);
      is(of.drift[0].at(1, of.direction())[0], second ? 6e4 : 8e4);
      EXPECT_NEAR(of.direction(), second ? M_PI / 6 : 0, 1e-12);
    }
  }
  write(".8", "6.2832 0 0 1 1 0 1 0\n3.1416 0 0 1 1 0 1 0\n6.2832 60 60 1 2 0 2 0\n3.1416 60 60 1 2 0 2 0\n");
  is(read(SecondOrder::newman).drift[0].at(2, M_PI / 3)[0], 4e4);
}

TEST_F(WamitReader, RefusesWithFileAndLine) {
  write(".1", "6.28 1 1 0.6 0.1\n3.14 1 7.5 0.6 0.1\n");
  EXPECT_NE(refusal().find("body.1:2: 7.5 is no mode of motion"), std::string::npos) << refusal();
  write(".1", "6.28 1 1 0.6 0.1\n3.14 1 1 0.6 nonsense\n");
  EXPECT_NE(refusal().find("body.1:2: "), std::string::npos) << refusal();
  std::filesystem::remove(stem() + ".1");
  EXPECT_NE(refusal().find("body.1: there is no such file"), std::string::npos) << refusal();
}

TEST_F(WamitReader, NamesThePeriodOfSkewAddedMass) {
  std::string text = "0 1 1 0.5\n0 2 2 0.5\n";
  for (const char* period : {"6.283185307179586", "3.141592653589793"})
    for (const char* entry : {" 1 1 0.5 1", " 2 2 0.5 1"}) text += std::string(period) + entry + "\n";
  text += "6.283185307179586 1 2 0 0\n6.283185307179586 2 1 0 0\n0 1 2 0\n0 2 1 0\n";
  text += "3.141592653589793 1 2 0.1 0\n3.141592653589793 2 1 0.2 0\n";
  write(".1", text);
  read();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("by up to 20 % of the diagonal, at 3.142 s"), std::string::npos) << notes[0];
}

// Damping (1, 2; 2, 1) has the eigenvalues 3 and -1, the second of which is removed: (1.5, 1.5; 1.5, 1.5).
TEST_F(WamitReader, ExcludesNegativeDamping) {
  std::string text = "0 1 1 0.5\n0 2 2 0.5\n";
  for (const char* period : {"6.283185307179586", "3.141592653589793", "2.0943951023931953"})
    for (const char* entry : {" 1 1 0.5 1", " 2 2 0.5 1", " 1 2 0 0", " 2 1 0 0"})
      text += std::string(period) + entry + "\n";
  text.replace(text.rfind(" 1 2 0 0"), 8, " 1 2 0 2");
  text.replace(text.rfind(" 2 1 0 0"), 8, " 2 1 0 2");
  write(".1", text);
  const model::HydrodynamicData d = read();
  EXPECT_NEAR(d.damping[2](0, 0), 1.5 * 3 * 8000, 1e-6);
  EXPECT_NEAR(d.damping[2](0, 1), 1.5 * 3 * 8000, 1e-6);
  EXPECT_NEAR(d.damping[0](0, 0), 8000, 1e-6);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("is excluded"), std::string::npos);
  write(".1", "0 1 1 0.5\n6 1 1 0.5 -0.1\n3 1 1 0.5 -0.1\n");
  EXPECT_NE(refusal().find("cannot drive it"), std::string::npos) << refusal();
}

TEST_F(WamitReader, RefusesDriftThatIsNotThere) {
  EXPECT_NE(refusal(SecondOrder::newman).find("'second_order' needs"), std::string::npos);
}

}  // namespace
}  // namespace hawser::wamit_reader_test
