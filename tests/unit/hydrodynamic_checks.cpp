// Single errors in the coefficients of the tutorial: each is refused or noted by one sentence; the unchanged
// set has no notes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "support/spar_files.hpp"

namespace hawser::hydrodynamic_checks_test {
namespace {

using spar_files::Row;

class HydrodynamicChecks : public spar_files::SparFiles {};

bool is_entry(const Row& r, double i, double j) { return r[1] == i && r[2] == j; }

TEST_F(HydrodynamicChecks, NothingIsReportedOfWhatIsRight) { EXPECT_EQ(reported(), ""); }

TEST_F(HydrodynamicChecks, RowsOfAddedMass) {
  with(".1", [](auto& rows) {
    for (Row& r : rows) r[3] = -r[3];
  });
  expect("added mass of surge at infinite frequency is negative");
  with(".1", [](auto& rows) {  // rows at infinity and at omega = 0 exchanged
    const std::vector<Row> before = rows;
    for (Row& r : rows) {
      if (r[0] != 0) continue;
      for (const Row& other : before)
        if (other[0] > 125 && is_entry(other, r[1], r[2])) r[3] = other[3];
    }
    for (const Row& r : before)
      if (r[0] == 0) rows.push_back({-1, r[1], r[2], r[3]});
  });
  expect("these rows are swapped, or the first column has frequencies");
  with(".1", [](auto& rows) {
    for (Row& r : rows)
      if (r[0] > 0) r[0] = 2 * M_PI / r[0];
  });
  expect("or the first column has frequencies");
  with(".1", [](auto& rows) {
    const auto heave = [](const Row& r) { return r[0] > 9 && is_entry(r, 3, 3); };
    rows.erase(std::find_if(rows.begin(), rows.end(), heave));
  });
  expect("spar.1: has no row 3 3 (heave) at ");
  with(".1", [](auto& rows) {
    const auto pitch = [](const Row& r) { return r[0] == 0 && is_entry(r, 1, 5); };
    rows.erase(std::find_if(rows.begin(), rows.end(), pitch));
  });
  expect("has no row 1 5 (surge and pitch) at period 0 (infinite frequency)");
  with(".1", [](auto& rows) {
    const auto surge = [](const Row& r) { return r[0] > 0 && r[0] < 12 && is_entry(r, 1, 1); };
    (*std::find_if(rows.begin(), rows.end(), surge))[3] *= 1.5;
  });
  expect("added mass of surge at ");
  with(".1", [](auto& rows) {
    for (Row& r : rows)
      if (r.size() > 4) r[4] *= 2.2;
  });
  expect("added mass and damping do not belong together", ", excitation: false");
  with(".1", [](auto& rows) {
    for (Row& r : rows)
      for (size_t k = 3; k < r.size(); ++k) r[k] *= 1025;
  });
  expect("the largest added mass of ", ", excitation: false, displaced_volume: 28274");
}

TEST_F(HydrodynamicChecks, WaveForces) {
  const auto conjugated = [](double mode) {
    return [mode](auto& rows) {
      for (Row& r : rows)
        if (mode == 0 || r[2] == mode) {
          r[4] = -r[4];
          r[6] = -r[6];
        }
    };
  };
  with(".3", conjugated(0));
  expect("the surge force lags the crest by 90 deg");
  with(".3", conjugated(2));
  expect("the sway force alone is against the waves");
  with(".3", [](auto& rows) { rows[7][6] *= 1.1; });
  expect("spar.3:8: modulus ");
  with(".3", [](auto& rows) {
    for (Row& r : rows) r[6] = -r[6];
  });
  expect("spar.3:1: modulus ");
  with(".3", [](auto& rows) {
    for (Row& r : rows)
      for (const size_t k : {3, 5, 6}) r[k] *= 1.6;
  });
  expect("times the hydrostatic stiffness C33");
  with(".3", [](auto& rows) {  // only forces of long waves are right
    for (Row& r : rows)
      for (const size_t k : {3, 5, 6})
        if (r[0] < 45) r[k] *= 2;
  });
  expect("by Haskind's relation");
}

// Errors that long waves show in forces: phases, volume and stiffness.
TEST_F(HydrodynamicChecks, LongWaves) {
  const auto times = [](double mode, double factor) {
    return [=](auto& rows) {
      for (Row& r : rows)
        if (r[2] == mode)
          for (const size_t k : {3, 5, 6}) r[k] *= factor;
    };
  };
  const auto turned = [](double mode, double angle) {
    return [=](auto& rows) {
      for (Row& r : rows)
        if (r[2] == mode) {
          r[4] += angle;
          r[5] = r[3] * std::cos(r[4] * M_PI / 180);
          r[6] = r[3] * std::sin(r[4] * M_PI / 180);
        }
    };
  };
  with(".3", turned(1, 60));
  expect("the surge force leads the crest by 150 deg, but the acceleration of the water leads it by 90 deg");
  with(".3", turned(3, 90));
  expect("the heave force leads the crest by 90 deg, but a body goes up and down with the water");
  with(".3", times(3, 1.1));
  expect("the heave force of ");
  with(".3", times(5, -1));
  expect("the pitch moment of ");
  with(".3", times(4, 1.2));
  expect("the roll moment of ");
  with(".1", [](auto& rows) {  // z axis downwards
    for (Row& r : rows)
      if (is_entry(r, 1, 5) || is_entry(r, 5, 1)) r[3] = -r[3];
  });
  expect("the pitch moment of ");
  expect("and the body displaces 26000 m³: are depth of the water", ", displaced_volume: 26000");
}

// Two notes of each of two bodies: no kind has more than three.
TEST_F(HydrodynamicChecks, NotesOfDifferentKindsAreNotGrouped) {
  with(".3", [](auto& rows) {
    for (Row& r : rows)
      for (const size_t k : {3, 5, 6})
        if (r[0] < 45 || r[2] == 4) r[k] *= r[2] == 4 ? 1.2 : 2;
  });
  const std::string text = reported("", "", {"fore", "aft"});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4) << text;
  EXPECT_EQ(text.find("more like it"), std::string::npos) << text;
  for (const char* body : {"fore", "aft"})
    for (const char* part : {"the roll moment of ", "by Haskind's relation"}) {
      const size_t at = text.find(part, text.find(std::string("bodies.") + body));
      EXPECT_NE(at, std::string::npos) << body << ", " << part << "\n" << text;
    }
}

// If all files are scaled by the length, they differ from a body of another volume.
TEST_F(HydrodynamicChecks, LengthOfAllFiles) {
  const auto scaled = [](double of_forces, double of_moments) {
    return [=](auto& rows) {
      for (Row& r : rows)
        for (const size_t k : {3, 5, 6}) r[k] *= r[2] > 3 ? of_moments : of_forces;
    };
  };
  with(".3", scaled(4, 8));
  with(".1", [](auto& rows) {
    for (Row& r : rows)
      for (size_t k = 3; k < r.size(); ++k) r[k] *= std::pow(2, 3 + (r[1] > 3) + (r[2] > 3));
  });
  with(".hst", [](auto& rows) {
    for (Row& r : rows) r[2] *= r[0] > 3 ? 16 : 4;
  });
  const std::string text = reported(", displaced_volume: 28274");
  EXPECT_NE(text.find("is that of a displaced volume of "), std::string::npos) << text;
}

TEST_F(HydrodynamicChecks, WeightInTheStiffness) {
  constexpr double kPart = 2.8981e7 * 50 / 1025;  // -m g zG over rho g
  const auto weight = [](double times) {
    return [=](auto& rows) {
      for (Row& r : rows)
        if (r[0] > 3) r[2] += times * kPart;
    };
  };
  const std::string stated = ", gravity_in_stiffness: true";
  with(".hst", weight(1));
  EXPECT_EQ(reported(stated), "");
  expect("this is the part of the body's weight: set 'gravity_in_stiffness: true'");
  with(".hst", weight(0));
  EXPECT_NE(reported(stated).find("which the files do not have: remove 'gravity_in_stiffness'"),
            std::string::npos)
      << reported(stated);
  with(".hst", weight(2));
  expect("this is twice the part of the body's weight: the files have it doubled", stated);
  with(".hst", weight(2));
  expect("this is twice the part of the body's weight: the files have it doubled");
}

TEST_F(HydrodynamicChecks, StiffnessThatCannotBe) {
  with(".hst", [](auto& rows) { rows.front()[2] = -rows.front()[2]; });
  EXPECT_NE(reported().find("cannot be negative: does the file have the other sign?"), std::string::npos)
      << reported();
  with(".hst", [](auto& rows) { rows.push_back({3, 5, 500}); });
  EXPECT_EQ(reported(), "");  // the upper triangle stands for both
  with(".hst", [](auto& rows) {
    rows.push_back({3, 5, 5000});
    rows.push_back({5, 3, 0.1});
  });
  EXPECT_NE(reported().find("the hydrostatic stiffness of heave and pitch has "), std::string::npos)
      << reported();
}

TEST_F(HydrodynamicChecks, RowsOfTwoRuns) {
  const auto again = [](int mode, double factor, size_t column) {
    return [=](auto& rows) {
      const auto selected = [=](const Row& r) { return r[0] > 4 && r[0] < 9 && is_entry(r, mode, mode); };
      rows.push_back(*std::find_if(rows.begin(), rows.end(), selected));
      rows.back()[column] *= factor;
    };
  };
  with(".1", again(1, 1, 3));
  EXPECT_EQ(reported(), "");
  with(".1", again(1, 1.1, 3));
  expect("for an entry that the file has already as");
  with(".1", again(1, 5, 4));  // damping
  expect("for an entry that the file has already as");
  with(".hst", [](auto& rows) { rows.push_back({3, 3, 1.05 * rows.front()[2]}); });
  expect("for an entry that the file has already as");
  with(".3", [](auto& rows) {
    rows.push_back(rows[1]);
    for (const size_t k : {3, 5, 6}) rows.back()[k] *= 1.1;
  });
  expect("twice, with different values: are these rows of two runs?");
}

// Three periods in the order of the file, with pairs that are the mean of both, or far from the mean.
TEST_F(HydrodynamicChecks, DifferenceForces) {
  const auto pairs = [](double of_pair, const char* more = "") {
    std::string text;
    const double periods[] = {16, 12, 8};
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) {
        const double value = i == j ? 0.2 : 0.2 * of_pair;
        text += fmt::format("{} {} 0 0 1 {} {} {} 0\n", periods[i], periods[j], std::abs(value),
                            value < 0 ? 180 : 0, value);
      }
    return text + more;
  };
  const std::string full = ", second_order: full";
  write(".12d", pairs(0.9));
  EXPECT_EQ(reported(full), "");
  write(".12d", pairs(0.2));
  expect("its periods are too sparse for 'second_order: full'", full);
  write(".12d", pairs(0.9, "12 16 0 0 1 0.18 0 0.18 0\n"));
  EXPECT_EQ(reported(full), "");
  write(".12d", pairs(0.9, "12 16 0 0 1 0.1 0 0.1 0\n"));
  expect("or is F_ji not the conjugate of F_ij?", full);
}

// A swell of 4/13 of the energy across the wind sea.
TEST_F(HydrodynamicChecks, DifferenceForcesOfCrossingWaves) {
  std::string pairs;
  for (const auto& [one, other] : {std::pair(16, 16), {16, 12}, {16, 8}, {12, 12}, {12, 8}, {8, 8}})
    for (const int at : {0, 25, 60}) pairs += fmt::format("{0} {1} {2} {2} 1 0.2 0 0.2 0\n", one, other, at);
  write(".12d", pairs);
  const auto systems = [](int direction) {
    return fmt::format(
        ", waves: {{sum: [{{jonswap: {{hs: 3, tp: 11}}}}, {{jonswap: {{hs: 2, tp: 13, direction_deg: "
        "{}}}}}]}}",
        direction);
  };
  waves_ = systems(100);
  const std::string part = "30.8 % of the sea's energy goes to directions more than 45 deg from the mean";
  EXPECT_NE(reported(", second_order: full").find(part), std::string::npos)
      << reported(", second_order: full");
  EXPECT_EQ(reported(", second_order: full").find("the drift forces of the files have"), std::string::npos)
      << reported(", second_order: full");
  EXPECT_EQ(reported().find("from the mean"), std::string::npos) << reported();
  waves_ =
      ", waves: {sum: [{regular: {height: 3, period: 11}}, {regular: {height: 3, period: 12, direction_deg: "
      "120}}]}";
  expect("second_order: 'full' takes the forces of the mean direction of the waves, 60 deg",
         ", second_order: full");
  waves_ = systems(30);
  EXPECT_EQ(reported(", second_order: full").find("from the mean"), std::string::npos);
}

TEST_F(HydrodynamicChecks, AsymmetricDamping) {
  with(".1", [](auto& rows) {
    for (Row& r : rows)
      if (r[0] > 0 && is_entry(r, 1, 5)) r[4] = -r[4];
  });
  EXPECT_NE(reported().find("damping differs from its transpose by up to "), std::string::npos) << reported();
}

// A wide float, whose damping affects the phase of heave.
TEST_F(HydrodynamicChecks, ConjugatedHeave) {
  const auto force = [](double sign) {
    return [sign](auto& rows) {
      for (Row& r : rows)
        if (r[2] == 3) {
          const double angle = 30 * M_PI / 180 * std::min(1.0, 12 / r[0]);
          r[4] = sign * angle * 180 / M_PI;
          r[5] = r[3] * std::cos(angle);
          r[6] = sign * r[3] * std::sin(angle);
        }
    };
  };
  const auto damped = [](auto& rows) {
    for (Row& r : rows)
      if (r[0] > 0 && is_entry(r, 3, 3)) r[4] *= 30;
  };
  with(".3", force(1));
  with(".1", damped);
  EXPECT_EQ(reported().find("its phases in"), std::string::npos) << reported();
  with(".3", force(-1));
  EXPECT_NE(reported().find("but the damping of"), std::string::npos) << reported();
}

TEST_F(HydrodynamicChecks, FilesThatAreCutOff) {
  const auto listed = [](auto& rows) {  // all entries, most of which are zero
    const std::vector<Row> before = rows;
    rows.clear();
    for (const double i : {1, 2, 3, 4, 5, 6})
      for (const double j : {1, 2, 3, 4, 5, 6}) {
        rows.push_back({i, j, 0});
        for (const Row& r : before)
          if (r[0] == i && r[1] == j) rows.back() = r;
      }
  };
  with(".hst", listed);
  EXPECT_EQ(reported(), "");
  with(".hst", [&](auto& rows) {
    listed(rows);
    rows.resize(20);
  });
  expect("spar.hst: has rows of zero and no row 4 3 (roll and heave): complete the file");
  with(".3", [](auto& rows) {
    const auto heave = [](const Row& r) { return r[0] < 12 && r[2] == 3; };
    rows.erase(std::find_if(rows.begin(), rows.end(), heave));
  });
  expect("spar.3: has no row 3 (heave) at ");
  with(".1", [](auto& rows) { std::erase_if(rows, [](const Row& r) { return r[0] > 0 && r[0] < 9; }); });
  EXPECT_NE(reported().find("is the file cut off?"), std::string::npos) << reported();
}

TEST_F(HydrodynamicChecks, FirstRowWithAnError) {
  write(".hst", "WAMIT Output 36\n3 3 ****\n4 4 -1264491\n");
  expect("spar.hst:2: a row of this file has 3 numbers, but this one has 2 and something that is no number");
  for (const char* title : {"3 bodies of a set", "1 body alone"}) {
    write(".hst", std::string(title) + "\n3 3 314.159265\n4 4 -1264491.04\n5 5 -1264491.04\n");
    EXPECT_EQ(reported(), "") << title;
  }
  expect("body: is 2, and ", ", body: 2");
}

// A spar of 28274 m³ that displaces ten times its mass, or has a negative metacentric height; damping that
// adds energy; stiffness that pushes the body away; a fairlead whose position is given in space axes.
TEST_F(HydrodynamicChecks, WhatCannotFloat) {
  expect("mean that without lines it floats 810 m higher, which is more than its size (65.6 m",
         ", excitation: false, displaced_volume: 282740");
  const auto top_heavy = [](auto& rows) {
    for (Row& r : rows)
      if (r[0] > 3) r[2] = -1.6e6;
  };
  with(".hst", top_heavy);
  expect("capsizes: its metacentric height in roll and pitch is -6.59 m; is the centre of mass",
         ", excitation: false");
  const auto damping = [](double coupling) {
    return fmt::format(
        ", damping: [[1e4, 0, 0, 0, {0}, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], "
        "[{0}, 0, "
        "0, 0, 1e6, 0], [0, 0, 0, 0, 0, 0]]",
        coupling);
  };
  EXPECT_EQ(reported(damping(0.9e5)), "");
  expect("adds energy to the motion for some combination of velocities", damping(1.1e5));
  const auto stiffness = [](double surge, double heave) {
    return fmt::format(
        ", stiffness: [[{}, 0, 0, 0, 0, 0], [0, 1e4, 0, 0, 0, 0], [0, 0, {}, 0, 0, 0], [0, 0, 0, 0, 0, 0], "
        "[0, 0, "
        "0, 0, 0, 0], [0, 0, 0, 0, 0, 1e7]]",
        surge, heave);
  };
  EXPECT_EQ(reported(stiffness(1e4, -1e3)), "");
  expect("pushes the body away from its position in surge, sway or yaw", stiffness(-1e4, 0));
  const auto line = [](double x) {
    return fmt::format(
        "line_types: {{chain: {{library: chain-studless, diameter: 100 mm, grade: R4}}}}\nlines: {{mooring: "
        "{{sections: [{{type: chain, length: 300, elements: 10}}], end_a: {{anchor: [{}, 0, -100]}}, end_b: "
        "{{body: spar, at: [{}, 0, -20]}}}}}}\n",
        x + 270, x);
  };
  EXPECT_EQ(reported("", line(6)).find("lines.mooring.end_b.at"), std::string::npos) << reported("", line(6));
  EXPECT_NE(
      reported("", line(400)).find("lines.mooring.end_b.at: is 401.1 m from the centre of mass of body spar"),
      std::string::npos)
      << reported("", line(400));
  with(".hst", top_heavy);
  expect(
      "without its lines its metacentric height in roll and pitch is -6.59 m; its lines must keep it upright",
      ", excitation: false", line(6));
}

TEST_F(HydrodynamicChecks, StiffnessTimesTheDensity) {
  with(".hst", [](auto& rows) {
    for (Row& r : rows) r[2] *= 1025;
  });
  EXPECT_NE(reported(", excitation: false").find("means a waterplane of"), std::string::npos) << reported();
}

// Forces from momentum have surge, sway and yaw only.
TEST_F(HydrodynamicChecks, DriftWithoutHeave) {
  std::string text;
  for (const int period : {5, 10, 20})
    for (const int mode : {1, 2, 6}) text += fmt::format("{} 0 0 {} 0.1 0 0.1 0\n", period, mode);
  write(".8", text);
  expect("has no rows of heave, roll and pitch", ", second_order: newman");
}

TEST_F(HydrodynamicChecks, ExponentsOfFortran) {
  std::ifstream in(HAWSER_SOURCE_DIR "/docs/tutorial/spar.1");
  std::string text((std::istreambuf_iterator<char>(in)), {});
  for (char& letter : text)
    if (letter == 'e') letter = 'D';
  write(".1", "PER I J Added Damping\n" + text);
  EXPECT_EQ(reported(), "");
}

}  // namespace
}  // namespace hawser::hydrodynamic_checks_test
