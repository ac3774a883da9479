// Errors of the tension of straight elements over an edge, against hand calculations.
#include "hawser/record/edge_errors.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::record::edge_errors_test {
namespace {

constexpr double kDegree = M_PI / 180;

struct Pressed {
  bool by_line = false;     // not by a volume
  double acceleration = 0;  // m/s², of all nodes, in dynamics
};

// A volume presses on an element of 2 m with a tension of 1 kN, and both adjacent elements slope down by
// these angles. By the balance of each node along the middle element, their tensions are 1 kN divided by the
// cosine. The force across the element only balances the adjacent elements.
std::string warning(double before, double after, double friction = 0,
                    const std::string& type = "bending: false", const std::string& end_b = "free",
                    const Pressed& pressed = {}) {
  const model::Case c = io::read_case_text(fmt::format(R"(
hawser: 1
line_types: {{wire: {{outer_diameter: 0.05, mass_per_length: 5, EA: 1.0e8, {}}}}}
lines:
  sling:
    sections: [{{type: wire, length: 6, elements: 3}}]
    end_a: {{anchor: [0, 0, 0]}}
    end_b: {}
    start: {{points: [[0, 0, 0], [6, 0, 0]]}}
)",
                                                       type, end_b),
                                           "/nowhere/case.yaml");
  const run::Simulation sim(MPI_COMM_SELF, c);
  const double a = before * kDegree;
  const double b = after * kDegree;
  const double T1 = 1000 / std::cos(a);
  const double T2 = 1000 / std::cos(b);
  State s;
  s.resize(4);
  s.x = {Vec3(-2 * std::cos(a), 0, -2 * std::sin(a)), Vec3(0, 0, 0), Vec3(2, 0, 0),
         Vec3(2 + 2 * std::cos(b), 0, -2 * std::sin(b))};
  for (Vec3& a_n : s.a) a_n = Vec3(pressed.acceleration, 0, 0);
  const std::vector<double> force{0, 0, 0, friction, 0, T1 * std::sin(a), -friction, 0, T2 * std::sin(b),
                                  0, 0, 0};
  const std::vector<double> of_friction{0, 0, 0, friction, 0, 0, -friction, 0, 0, 0, 0, 0};
  const std::vector<double> tension_before{T1, T1, 1000, T2};
  const std::vector<double> tension_after{T1, 1000, T2, T2};
  EdgeErrors errors(MPI_COMM_SELF, c, sim.local());
  const std::vector<double> none(12, 0);
  const Kinematics at = pressed.acceleration > 0 ? s.after_step(0.1) : s.at_rest();
  if (pressed.by_line)
    errors.update(at, {none, none, tension_before, tension_after, force, of_friction});
  else
    errors.update(at, {force, of_friction, tension_before, tension_after});
  return errors.warning(0, std::max(T1, T2));
}

// 1000/cos 20 deg - 1000 = 64.2 N. Recommends a beam of sqrt(EI/T) = L turn/0.8, 1064 N (2 m 20 deg/0.8)².
TEST(EdgeErrors, TensionOnBothSides) {
  const std::string text = warning(20, 0);
  EXPECT_NE(
      text.find("line sling turns by 20 degrees over a volume from one straight element of 2 m to the next "
                "(arc length 2 m, t = 0 s), which changes its tension there by 64 N, 6 % of the "
                "largest: give its type an 'EI' of 1.1e+03 N m² or more"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("or use elements of 0.005 m there"), std::string::npos)
      << text;  // element length: a fifth of the radius
  EXPECT_EQ(text.find("reduces friction over"), std::string::npos) << text;
  EXPECT_EQ(warning(20, 0, 300), text);  // physical friction does not change the text
  EXPECT_EQ(warning(20, 0, 0, "EI: 1, GJ: 1"), "");
}

// The same by a line; errors of more than 2 % are reported: 1 - cos is 1.8 % at 11 degrees and 2.2 % at 12.
TEST(EdgeErrors, OverAnotherLine) {
  const auto text = [](double before, double friction) {
    return warning(before, 0, friction, "bending: false", "free", {.by_line = true});
  };
  EXPECT_NE(text(20, 0).find("line sling turns by 20 degrees over a line from one straight element of "
                             "2 m to the next (arc length 2 m, t = 0 s), which changes its tension there by "
                             "64 N, 6 % of the largest: give its type an 'EI' of 1.1e+03 N m² or more"),
            std::string::npos)
      << text(20, 0);
  EXPECT_EQ(text(20, 300), text(20, 0));
  EXPECT_EQ(text(11, 0), "");
  EXPECT_NE(text(12, 0), "");
}

// The force of 1064 N sin 20 degrees has the component 63.2 N along the line, which accelerates 10 kg by
// 6.32 m/s².
TEST(EdgeErrors, AnImpactAcceleratesTheNode) {
  const auto text = [](bool by_line, double acceleration) {
    return warning(20, 0, 0, "bending: false", "free", {by_line, acceleration});
  };
  for (const bool by_line : {false, true}) {
    EXPECT_EQ(text(by_line, 6.4), "");
    EXPECT_NE(text(by_line, 3).find("which changes its tension there by 34 N"), std::string::npos)
        << text(by_line, 3);
  }
}

// The length over the edge then changes the tension, and so does the path of a beam.
TEST(EdgeErrors, NoBendingStiffnessForALineThatIsHeld) {
  const std::string text = warning(20, 0, 0, "bending: false", "{anchor: [6, 0, 0]}");
  EXPECT_NE(
      text.find("6 % of the largest: use elements of 0.005 m there (bending stiffness would also change"),
      std::string::npos)
      << text;
  EXPECT_EQ(text.find("'EI'"), std::string::npos) << text;
}

// A beam has less friction over an edge than a cable, 1 - (60 degrees)²/24 of it.
TEST(EdgeErrors, FrictionOfTheRecommendedBeam) {
  const std::string text = warning(60, 0);
  EXPECT_NE(text.find("which itself reduces friction over a sharp edge by 5 %"), std::string::npos) << text;
  const std::string of_line = warning(60, 0, 0, "bending: false", "free", {.by_line = true});
  EXPECT_NE(of_line.find("give its type an 'EI'"), std::string::npos) << of_line;
  EXPECT_EQ(of_line.find("reduces friction"), std::string::npos) << of_line;
}

// 1 - cos is 0.50 % at 5.73 degrees: there is a warning above 0.5 % only.
TEST(EdgeErrors, NoneOfMoreThanHalfAPercentIsKept) {
  EXPECT_EQ(warning(5.7, 0), "");
  EXPECT_NE(warning(5.8, 0), "");
  EXPECT_NE(warning(0, 5.8), "");
  EXPECT_NE(warning(20, 19), "");  // 6.6 N
}

// Equal tensions on both sides, and 3.0 % or 34 % less in the element between them, of which a third counts.
TEST(EdgeErrors, WithinTheElement) {
  EXPECT_EQ(warning(10, 10), "");
  EXPECT_NE(warning(49, 49).find("by 1.6e+02 N"), std::string::npos) << warning(49, 49);
}

// Random turns along one line with an interval without contact: for any cut the joined summary equals the
// sums by definition.
TEST(PressedPart, JoinsHoweverTheLineIsCut) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<PressedTurn> turns;
  for (const int node : {3, 4, 5, 9, 10, 14})
    turns.push_back({node, std::abs(any(random)), any(random), 2 + any(random), 1, 1 + any(random)});
  double sum = 0, high = 0, low = 0, outside_high = 0, outside_low = 0;
  size_t worst = 0;
  for (size_t i = 0; i < turns.size(); ++i) {
    sum += turns[i].tension_change;
    high = std::max(high, sum);
    low = std::min(low, sum);
    if (i == 2 || i == 4) {
      outside_high = std::max(outside_high, sum);
      outside_low = std::min(outside_low, sum);
    }
    if (std::abs(turns[i].tension_change) > std::abs(turns[worst].tension_change)) worst = i;
  }
  const auto beside = [&](size_t i) {
    return i < turns.size() && std::abs(turns[i].node - turns[worst].node) == 1 ? turns[i].angle : 0;
  };
  const auto fold = [&](size_t from, size_t to) {
    PressedPart out;
    for (size_t i = from; i < to; ++i) out = joined(out, PressedPart(turns[i]));
    return out;
  };
  for (size_t a = 0; a <= turns.size(); ++a)
    for (size_t b = a; b <= turns.size(); ++b) {
      const PressedPart w = joined(fold(0, a), joined(fold(a, b), fold(b, turns.size())));
      EXPECT_NEAR(w.sum, sum, 1e-14);
      EXPECT_NEAR(std::max(w.inside.high, 0.0), high, 1e-14);
      EXPECT_NEAR(std::min(w.inside.low, 0.0), low, 1e-14);
      EXPECT_NEAR(std::max(w.outside.high, 0.0), outside_high, 1e-14);
      EXPECT_NEAR(std::min(w.outside.low, 0.0), outside_low, 1e-14);
      EXPECT_EQ(w.worst.node, turns[worst].node);
      EXPECT_EQ(w.before, beside(worst - 1));
      EXPECT_EQ(w.after, beside(worst + 1));
      EXPECT_EQ(w.first.node, 3);
      EXPECT_EQ(w.last.node, 14);
    }
}

}  // namespace
}  // namespace hawser::record::edge_errors_test
