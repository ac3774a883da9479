// The warning about elements too long for how sharply a line is bent over a volume.
#include "hawser/app/sharp_turns.hpp"

#include <gtest/gtest.h>

#include "hawser/app/simulation.hpp"
#include "hawser/io/case_reader.hpp"

namespace hawser::app::sharp_turns_test {
namespace {

// Two elements that meet at a right angle, and at 20 degrees; pressed there or not.
TEST(SharpTurns, AreToldWhereVolumesPress) {
  const model::Case c = io::read_case_text(R"(
hawser: 1
line_types: {wire: {outer_diameter: 0.05, mass_per_length: 5, EA: 1.0e8, bending: false}}
lines:
  sling:
    sections: [{type: wire, length: 4, elements: 2}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [3.9, 0, 0]}
)",
                                           "/nowhere/case.yaml");
  const Simulation sim(MPI_COMM_SELF, c);
  const auto said = [&](double degrees, double pressed, double largest) {
    SharpTurns turns(sim.local());
    State s;
    s.resize(3);
    const double a = degrees * M_PI / 180;
    s.x = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2 + 2 * std::cos(a), 0, -2 * std::sin(a))};
    const std::vector<double> tension{1000, 1000, 1000}, normal{0, pressed, 0};
    turns.look(s.view(0), tension, normal);
    return turns.warning(MPI_COMM_SELF, 0, "sling", largest);
  };
  const std::string sharp = said(90, 1400, 2000);
  EXPECT_NE(sharp.find("line sling turns by 90 degrees from one element to the next"), std::string::npos)
      << sharp;
  EXPECT_NE(sharp.find("arc length 2 m, t = 0 s"), std::string::npos) << sharp;
  EXPECT_NE(sharp.find("up to 1e+03 N, 50 % of the largest"), std::string::npos) << sharp;
  EXPECT_EQ(said(20, 350, 1000), "");
  EXPECT_EQ(said(90, 0, 1000), "");      // a kink in the water
  EXPECT_EQ(said(90, 1400, 11000), "");  // slack against what the line bears elsewhere
}

}  // namespace
}  // namespace hawser::app::sharp_turns_test
