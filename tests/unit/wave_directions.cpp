// Wave forces whose directions or axes have another convention, and files with missing or damaged rows.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "support/spar_files.hpp"

namespace hawser::wave_directions_test {
namespace {

using spar_files::Row;

class WaveDirections : public spar_files::SparFiles {
 protected:
  template <class Function>
  void with_directions(const Function& changed) {
    with(".3", [&](auto& rows) {
      for (Row& r : rows) r[1] = changed(r[1]);
    });
  }
  // Removes the rows of a mode, from 1, in one of the columns from `first` to `last`.
  void without_mode(const char* ending, size_t first, size_t last, double mode) {
    with(ending, [&](auto& rows) {
      std::erase_if(rows, [&](const Row& r) {
        const auto begin = r.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = r.begin() + static_cast<std::ptrdiff_t>(last) + 1;
        return std::find(begin, end, mode) != end;
      });
    });
  }
};

TEST_F(WaveDirections, OtherConventions) {
  with_directions([](double beta) { return -beta; });
  expect(
      "the sway force alone is against the waves, as if its directions were clockwise, or y were to "
      "starboard");
  with_directions([](double beta) { return 180 - beta; });
  expect(
      "the surge force alone is against the waves, as if its directions were clockwise and those that waves");
  with_directions([](double beta) { return 90 - beta; });
  expect("surge and sway are exchanged, as if its directions were clockwise from y, as on a compass");
  with_directions([](double beta) { return 270 - beta; });
  expect("surge and sway are exchanged and against the waves, as if its directions were those of a compass");
  with_directions([](double beta) { return beta - 90; });
  expect("surge and sway are turned by 90 deg from its directions, as if its directions were from y");
  with_directions([](double beta) { return beta + 180; });
  expect("or its directions are those that waves come from");
}

TEST_F(WaveDirections, ExchangedModes) {
  with(".3", [](auto& rows) {
    for (Row& r : rows)
      if (r[2] < 3) r[2] = 3 - r[2];
  });
  expect(
      "surge and sway are exchanged, as if its directions were clockwise from y, as on a compass, or modes "
      "1");
}

// Rounded to a tenth they are not recognised by themselves; with directions close to 0 only, waves do not
// turn.
TEST_F(WaveDirections, Radians) {
  with_directions([](double beta) { return beta * M_PI / 180; });
  expect("spar.3: its directions, up to 5.7596, are multiples of 5 deg in radians: give them in degrees");
  with_directions([](double beta) { return std::round(10 * beta * M_PI / 180) / 10; });
  expect("are not those of waves to its directions, 0 to 5.8 deg: are these in degrees from x");
  with(".3", [](auto& rows) { std::erase_if(rows, [](const Row& r) { return r[1] != 0; }); });
  EXPECT_EQ(reported(), "");
}

TEST_F(WaveDirections, FreedomsWithoutRows) {
  without_mode(".3", 2, 2, 1);
  expect("no wave forces of mode 1 (surge) in ");
  without_mode(".3", 2, 2, 3);
  expect("no wave forces of mode 3 (heave) in ");
  without_mode(".3", 2, 2, 5);
  expect("no wave forces of mode 5 (pitch) in ");
  without_mode(".1", 1, 2, 3);
  expect("no added mass and damping of mode 3 (heave) in ");
  with(".1", [](auto& rows) { std::erase_if(rows, [](const Row& r) { return r[1] == 5 && r[2] == 5; }); });
  expect("spar.1: has no rows 5 5 (pitch), although it has rows 1 5 (surge and pitch): complete the file");
}

TEST_F(WaveDirections, DamagedRows) {
  with(".3", [](auto& rows) {
    rows.resize(8);
    rows.back()[6] *= 0.1;
  });
  expect(
      "spar.3:8: the last row is incomplete, its modulus and phase are not those of its real and imaginary");
  with(".3", [](auto& rows) { rows[7][0] = -12; });
  expect("spar.3:8: the period is -12 s: it is above 0 s, or 0 (infinite frequency) or -1 (zero frequency)");
  const std::string stiffness = "3 3 314.159265\n4 4 -1264491.04\n5 5 -1264491.04\n";
  write(".hst", stiffness + "3 4");
  expect("spar.hst:4: a row of this file has 3 numbers, but this one has 2: is the file truncated?");
  const std::string fixed_width =
      "3 3  3.14159265E+02\n4 5  1.00000000E-03\n4 4 -1.26449104E+06\n5 5 -1.26449104E+06";
  write(".hst", fixed_width.substr(0, fixed_width.size() - 1));
  expect(
      "spar.hst:4: the last row is shorter than the others and ends without a line break: is the file "
      "truncated?");
  write(".hst", fixed_width);
  EXPECT_EQ(reported(), "");
  write(".hst", "3 3 314,159265\n4 4 -1264491,04\n5 5 -1264491,04\n");
  expect("spar.hst:1: its numbers have decimal commas: give them decimal points");
  write(".hst", "\xff\xfe" + stiffness);
  expect("spar.hst: is a text in UTF-16: save it in UTF-8");
  write(".hst", "\xef\xbb\xbf" + stiffness);
  EXPECT_EQ(reported(), "");
  std::filesystem::remove(folder_ / "spar.hst");
  std::filesystem::create_directory(folder_ / "spar.hst");
  const std::string text = reported();
  EXPECT_NE(text.find("spar.hst: is a directory, not a table file"), std::string::npos) << text;
}

}  // namespace
}  // namespace hawser::wave_directions_test
