// Warnings about long elements: sag between nodes, and bending moments that decay within an element.
#include "hawser/record/element_errors.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::record::element_errors_test {
namespace {

// Warnings for a line whose elements of 10 m turn by equal angles.
std::vector<std::string> warnings_of_arc(int elements, double degrees, double tension, double largest,
                                         const std::string& more = "") {
  const model::Case c = io::read_case_text(fmt::format(R"(
hawser: 1
line_types: {{wire: {{outer_diameter: 0.05, mass_per_length: 5, EA: 1.0e15, bending: false}}}}
lines:
  wire:
    sections: [{{type: wire, length: {}, elements: {}}}]
    end_a: {{anchor: [0, 0, 0]}}
    end_b: {{anchor: [9, 0, 0]}}{}
)",
                                                       10 * elements, elements, more),
                                           "/nowhere/case.yaml");
  const run::Simulation sim(MPI_COMM_SELF, c);
  ElementErrors errors(MPI_COMM_SELF, c, sim.local(), nullptr);
  State s;
  const size_t nodes = static_cast<size_t>(elements) + 1;
  s.resize(static_cast<int>(nodes));
  for (size_t n = 0; n < nodes; ++n) {
    const double a =
        (static_cast<double>(n) - 0.5 * static_cast<double>(elements) - 0.5) * degrees * M_PI / 180;
    s.x[n] = n == 0 ? Vec3(Vec3::Zero()) : Vec3(s.x[n - 1] + 10 * Vec3(std::cos(a), 0, std::sin(a)));
  }
  errors.update(s.at_rest(), {std::vector<double>(nodes, tension), {}, {}, std::vector<bool>(nodes, false)});
  return errors.warnings(0, largest, HUGE_VAL);
}

// N elements with equal turns theta: theta²/24 over theta² (N² - 1)/12, the variance of their directions, is
// 1/2(N² - 1). 3.3 % for 4, 0.79 % for 8; 1 % remains for 4 with elements shorter by sqrt(0.01/0.0333).
TEST(ElementErrors, SagOfCablesBetweenNodes) {
  const std::vector<std::string> warnings = warnings_of_arc(4, 2, 1000, 1000);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_TRUE(warnings.front().starts_with(
      "line wire sags between the nodes of its elements of 10 m: it turns by 2 degrees from one to the next "
      "(arc length "))
      << warnings.front();
  EXPECT_TRUE(warnings.front().ends_with(
      " m, t = 0 s), and its tension is wrong by about 3.3 % of the largest: use elements of 5.5 m there"))
      << warnings.front();
  EXPECT_TRUE(warnings_of_arc(8, 2, 1000, 1000).empty());
  EXPECT_TRUE(warnings_of_arc(4, 2, 1000, 1700)
                  .empty());  // 2.0 % of the largest tension of the line, which occurs at another time
  EXPECT_EQ(warnings_of_arc(4, 2, 1000, 1600).size(), 1U);
  // The kink at a mass does not count as sag.
  EXPECT_TRUE(warnings_of_arc(2, 2, 1000, 1000, "\n    masses: [{at: 10, mass: 100}]").empty());
  EXPECT_EQ(warnings_of_arc(2, 2, 1000, 1000).size(), 1U);
}

double least_tension(int elements, std::string& warnings) {
  const model::Case c = io::read_case_text(fmt::format(R"(
hawser: 1
environment: {{gravity: 9.80665}}
line_types: {{wire: {{outer_diameter: 0.05, mass_per_length: 5, EA: 1.0e8, bending: false}}}}
lines:
  wire:
    sections: [{{type: wire, length: 100, elements: {}}}]
    end_a: {{anchor: [0, 0, 0]}}
    end_b: {{anchor: [98, 0, 0]}}
)",
                                                       elements),
                                           "/nowhere/case.yaml");
  run::Simulation sim(MPI_COMM_SELF, c);
  sim.solve_statics();
  const Kinematics at = sim.state().at_rest();
  std::vector<double> tension(static_cast<size_t>(elements) + 1);
  const FieldRegistry fields = sim.system().fields();
  for (const FieldSource& f : fields.sources())
    if (f.name == "effective_tension") f.fill(at, tension);
  ElementErrors errors(MPI_COMM_SELF, c, sim.local(), nullptr);
  errors.update(at, {tension, {}, {}, std::vector<bool>(tension.size(), false)});
  const auto all = errors.warnings(0, *std::max_element(tension.begin(), tension.end()), HUGE_VAL);
  warnings = all.empty() ? "" : all.front();
  return *std::min_element(tension.begin(), tension.end());
}

// A cable with a sag of a tenth of its span: the error reported for four elements equals their difference
// from 64 elements.
TEST(ElementErrors, SagIsWhatShorterElementsShow) {
  std::string warnings, fine;
  const double coarse = least_tension(4, warnings);
  const double exact = least_tension(64, fine);
  EXPECT_EQ(fine, "");
  const size_t at = warnings.find("wrong by about ");
  ASSERT_NE(at, std::string::npos) << warnings;
  const double percent = std::stod(warnings.substr(at + 15));
  EXPECT_NEAR(percent, 100 * (exact - coarse) / exact, 0.3 * percent) << warnings;
}

// A slack chain that hangs vertically to the bed: the upper tension is its submerged weight times the height
// of its axis above the bed, 5842.1 N/m times 199.83 m, by hand. Elements of 10 m assign half of the lifting
// element to each end, which causes the reported errors. Elements of 2 m give no warning.
TEST(ElementErrors, ASlackChainThatLeavesTheBedSteeply) {
  const auto top = [](int elements, std::vector<std::string>& warnings) {
    const model::Case c = io::read_case_text(fmt::format(R"(
hawser: 1
environment: {{water: {{depth: 200}}, seabed: {{depth: 200, normal_stiffness: {{per_area: 3.0e6}}}}}}
line_types: {{chain: {{outer_diameter: 0.333, mass_per_length: 685, EA: 3.27 GN, bending: false}}}}
lines:
  chain:
    sections: [{{type: chain, length: 850, elements: {}}}]
    end_a: {{anchor: [-400, 0, -200]}}
    end_b: {{anchor: [0, 0, 0]}}
)",
                                                         elements),
                                             "/nowhere/case.yaml");
    run::Simulation sim(MPI_COMM_SELF, c);
    sim.solve_statics();
    const Kinematics at = sim.state().at_rest();
    std::vector<double> tension(static_cast<size_t>(elements) + 1);
    const FieldRegistry fields = sim.system().fields();
    for (const FieldSource& f : fields.sources())
      if (f.name == "effective_tension") f.fill(at, tension);
    std::vector<bool> supported;
    for (const Vec3& x : at.x) supported.push_back(x.z() < -200 + 0.17);
    ElementErrors errors(MPI_COMM_SELF, c, sim.local(), nullptr);
    errors.update(at, {tension, {}, {}, supported});
    warnings = errors.warnings(0, tension.back(), HUGE_VAL);
    const size_t end = 3 * static_cast<size_t>(sim.local().block[static_cast<size_t>(elements)]);
    return Eigen::Map<const Vec3>(sim.system().reactions().data() + end).norm();
  };
  const double exact = (685 - 1025 * M_PI / 4 * 0.333 * 0.333) * 9.80665 * (200 - 0.1665);
  EXPECT_NEAR(exact, 1167.5e3, 100);
  std::vector<std::string> warnings;
  const double coarse = top(85, warnings);
  ASSERT_EQ(warnings.size(), 1U);
  const size_t at = warnings[0].find("wrong by about ");
  ASSERT_NE(at, std::string::npos) << warnings[0];
  const double percent = std::stod(warnings[0].substr(at + 15));
  EXPECT_NEAR(percent, 100 * std::abs(exact - coarse) / coarse, 0.3) << warnings[0];
  EXPECT_NEAR(top(425, warnings), exact, 0.006 * exact);
  EXPECT_TRUE(warnings.empty()) << warnings[0];
}

// Three nodes on the bed and two above the last one, with tensions that differ by forty times the weight of
// an element. Elements of 16 m, longer than the present ones of 10 m, are not recommended; a touch of a
// volume or line ends the estimate.
TEST(ElementErrors, ATensionThatIsNoErrorOfTheLiftoff) {
  const model::Case c = io::read_case_text(R"(
hawser: 1
environment: {gravity: 9.80665}
line_types: {wire: {outer_diameter: 0.05, mass_per_length: 5, EA: 1.0e15, bending: false}}
lines:
  wire:
    sections: [{type: wire, length: 40, elements: 4}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [20, 0, 20]}
)",
                                           "/nowhere/case.yaml");
  const run::Simulation sim(MPI_COMM_SELF, c);
  State s;
  s.resize(5);
  s.x = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(20, 0, 0), Vec3(20, 0, 10), Vec3(20, 0, 20)};
  const std::vector<double> tension{2e4, 2e4, 2e4, 1e4, 1e4};
  const auto warnings = [&](double largest, const std::vector<bool>& pressed) {
    ElementErrors errors(MPI_COMM_SELF, c, sim.local(), nullptr);
    errors.update(s.at_rest(), {tension, {}, pressed, {true, true, true, false, false}});
    return errors.warnings(0, largest, HUGE_VAL).size();
  };
  EXPECT_EQ(warnings(2e4, {}), 1U);
  EXPECT_EQ(warnings(4e4, {}), 0U);
  EXPECT_EQ(warnings(2e4, {false, false, true, false, false}), 0U);
}

// Nodal moments at intervals of 1 m of a beam under tension with decay length 1 m, exp(-|s|) about its
// middle: the curvature of the cubic is too small by 1/16.2 of its value. At a mass the moment follows from
// the forces.
TEST(ElementErrors, PeaksOfBendingMoment) {
  const auto warnings = [](double decay, double smooth, const std::string& more = "") {
    const model::Case c = io::read_case_text(fmt::format(R"(
hawser: 1
line_types: {{pipe: {{outer_diameter: 0.1, mass_per_length: 10, EA: 1.0e8, EI: {}, GJ: 1000}}}}
lines:
  pipe:
    sections: [{{type: pipe, length: 8, elements: 8}}]
    end_a: {{anchor: [0, 0, 0]}}
    end_b: {{anchor: [8, 0, 0]}}{}
)",
                                                         1e4 * decay * decay, more),
                                             "/nowhere/case.yaml");
    const run::Simulation sim(MPI_COMM_SELF, c);
    ElementErrors errors(MPI_COMM_SELF, c, sim.local(), nullptr);
    State s;
    s.resize(9);
    std::vector<double> moment(9);
    for (size_t n = 0; n < 9; ++n) {
      s.x[n] = Vec3(static_cast<double>(n), 0, 0);
      moment[n] = -500 * std::exp(-std::abs(static_cast<double>(n) - 4) / (smooth * decay));
    }
    errors.update(s.at_rest(), {std::vector<double>(9, 1e4), moment, {}, std::vector<bool>(9, false)});
    const auto all = errors.warnings(0, 1e4, 500);
    return all.empty() ? "" : all.front();
  };
  EXPECT_EQ(warnings(1, 1),
            "the bending moment of line pipe decays within 1 m at arc length 4 m (t = 0 s), and with "
            "elements of 1 m it is wrong by about 6.2 % of the largest: use elements of 0.37 m there");
  EXPECT_EQ(warnings(2, 1), "");                                        // 1.7 %
  EXPECT_EQ(warnings(1, 10), "");                                       // no peak
  EXPECT_EQ(warnings(1, 1, "\n    masses: [{at: 4, mass: 100}]"), "");  // 0.07 %
}

}  // namespace
}  // namespace hawser::record::element_errors_test
