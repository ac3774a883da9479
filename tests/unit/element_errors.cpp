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

// First warning for a beam of eight elements of 1 m with a tension of 10 kN, decay length [m] and moments
// [N m] at its nodes, of which 500 N m is the largest; empty: none. keys: of the line; touched: nodes on a
// volume.
std::string moment_warning(double decay, const std::vector<double>& moment, const std::string& keys,
                           const std::vector<bool>& touched = std::vector<bool>(9, false)) {
  const model::Case c = io::read_case_text(fmt::format(R"(
hawser: 1
line_types: {{pipe: {{outer_diameter: 0.1, mass_per_length: 10, EA: 1.0e8, EI: {}, GJ: 1000}}}}
lines:
  pipe:
    sections: [{{type: pipe, length: 8, elements: 8}}]
    end_a: {{anchor: [0, 0, 0]}}
    {}
)",
                                                       1e4 * decay * decay, keys),
                                           "/nowhere/case.yaml");
  const run::Simulation sim(MPI_COMM_SELF, c);
  ElementErrors errors(MPI_COMM_SELF, c, sim.local(), nullptr);
  State s;
  s.resize(9);
  for (size_t n = 0; n < 9; ++n) s.x[n] = Vec3(static_cast<double>(n), 0, 0);
  errors.update(s.at_rest(), {std::vector<double>(9, 1e4), moment, touched, touched, touched});
  const auto all = errors.warnings(0, 1e4, 500);
  return all.empty() ? "" : all.front();
}

// Nodal moments at intervals of 1 m of a beam under tension with decay length 1 m, exp(-|s|) about its
// middle: the curvature of the cubic is too small by 1/16.2 of its value. At a mass the moment follows from
// the forces.
TEST(ElementErrors, PeaksOfBendingMoment) {
  const auto warning = [](double decay, double smooth, const std::string& more = "") {
    std::vector<double> moment;
    for (int n = 0; n < 9; ++n) moment.push_back(-500 * std::exp(-std::abs(n - 4) / (smooth * decay)));
    return moment_warning(decay, moment, "end_b: {anchor: [8, 0, 0]}" + more);
  };
  EXPECT_EQ(warning(1, 1),
            "the bending moment of line pipe decays within 1 m at arc length 4 m (t = 0 s), and with "
            "elements of 1 m it is wrong by about 6.2 % of the largest: use elements of 0.37 m there");
  EXPECT_EQ(warning(2, 1), "");                                        // 1.7 %
  EXPECT_EQ(warning(1, 10), "");                                       // no peak
  EXPECT_EQ(warning(1, 1, "\n    masses: [{at: 4, mass: 100}]"), "");  // 0.07 %
}

// A cable from 10 m on one side of an edge to 10 m on the other, with one element of 1 m across it, level,
// that turns by 0.2 rad and 0.3 rad at its nodes. It touches at 0.6 m of its length. Contact radius 0.1 m:
// 0.6 0.2²/2 + 0.4 0.3²/2 - 0.1 (0.2³ + 0.3³)/6 = 0.030 - 0.000583 m. Straight spans of 20 m and the element
// with T/EA = 0.2: 0.0294/4.2 of the tension.
std::vector<std::string> warnings_over_edge(const std::string& end_b, const std::string& more, double largest,
                                            std::vector<bool> on_volume = {false, true, true, false},
                                            std::vector<bool> on_line = {}) {
  const model::Case c = io::read_case_text(fmt::format(R"(
hawser: 1
line_types: {{wire: {{outer_diameter: 0.2, mass_per_length: 5, EA: 5000, bending: false}}}}
bodies:
  ship: {{motion: {{velocity: [0.1, 0, 0]}}}}
  buoy: {{floating: {{mass: 100, inertia: [10, 10, 10]}}}}
lines:
  wire:
    sections: [{{type: wire, length: 10, elements: 1}}, {{type: wire, length: 1, elements: 1}}, {{type: wire, length: 10, elements: 1}}]
    end_a: {{anchor: [-9.8, 0, -2]}}
    end_b: {}
{}
)",
                                                       end_b, more),
                                           "/nowhere/case.yaml");
  run::Simulation sim(MPI_COMM_SELF, c);
  State s;
  s.resize(sim.local().nodes());
  s.x[0] = Vec3(-10 * std::cos(0.2), 0, -10 * std::sin(0.2));
  s.x[1] = Vec3(0, 0, 0);
  s.x[2] = Vec3(1, 0, 0);
  s.x[3] = Vec3(1 + 10 * std::cos(0.3), 0, -10 * std::sin(0.3));
  ElementErrors errors(MPI_COMM_SELF, c, sim.local(), nullptr, sim.system().find<LinePairs>());
  std::vector<bool> supported{false, true, true, false};
  for (std::vector<bool>* at : {&supported, &on_volume, &on_line}) at->resize(s.x.size(), false);
  const std::vector<double> tension(s.x.size(), 1000);
  errors.update(s.at_rest(), {tension, {}, {}, supported, on_volume, on_line, {{0, 1, 500}}});
  return errors.warnings(0, largest, HUGE_VAL);
}

// 7.0 N, 3.5 % of 200 N and less than 2 % of 400 N; 1 % with a length of 1 m/3.5.
TEST(ElementErrors, LongerThanTheCurveOverAnEdge) {
  const std::string held = "{anchor: [10.6, 0, -3]}";
  const std::vector<std::string> warnings = warnings_over_edge(held, "", 200);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(
      warnings.front(),
      "the straight elements of line wire over a volume are 0.029 m longer than the curve over it, most at "
      "arc length 10.5 m (elements of 1 m, turn 29 degrees, t = 0 s); because both ends of the line are "
      "held, its tension is wrong by about 3.5 % of the largest: use elements of 0.29 m there");
  EXPECT_TRUE(warnings_over_edge(held, "", 400).empty());
  EXPECT_EQ(warnings_over_edge("{body: ship, at: [10.6, 0, -3]}", "", 200).size(), 1U);
  EXPECT_TRUE(warnings_over_edge("{body: buoy, at: [10.6, 0, -3]}", "", 200).empty());
  EXPECT_TRUE(warnings_over_edge(held, "", 200, {}).empty());
  EXPECT_TRUE(warnings_over_edge(held, "contact: {method: nodes}", 200).empty());
}

// The volume does not yield with a line that touches the same cable beside it or on it.
TEST(ElementErrors, OverAnEdgeBesideALineThatYields) {
  const std::string held = "{anchor: [10.6, 0, -3]}";
  const std::string other = R"(  other:
    sections: [{type: wire, length: 10, elements: 1}]
    end_a: {anchor: [0, 5, 0]}
    end_b: {body: buoy, at: [9, 5, 0]})";
  const std::vector<bool> on_volume{false, true, true, false};
  const std::vector<std::string> alone = warnings_over_edge(held, "", 200);
  for (const std::vector<bool>& on_line : {on_volume, {false, true, false, false}})
    EXPECT_EQ(warnings_over_edge(held, other, 200, on_volume, on_line), alone);
}

// The same cable, ten times as stiff, over another one of the same elements. If that is straight it has no
// excess, but takes up half of that of the cable: 3.5 % of 1 kN, 1.7 % of 2 kN. If it turns as much both have
// the whole error of 7.0 %, half of it by its own elements. If the other one is slack or its end floats there
// is none, nor without contact. Of forces equal within rounding that of the line on itself counts, the first,
// with the whole error.
TEST(ElementErrors, LongerThanTheCurveOverAnotherLine) {
  struct Other {
    double tension = 1000;   // N, of its first leg
    double on_itself = 0.1;  // force of the line on itself, as a fraction of that on the other one
  };
  const auto warnings = [](bool turns, const std::string& end_b, double force, double largest,
                           const Other& other = {}) {
    const model::Case c = io::read_case_text(fmt::format(R"(
hawser: 1
line_types: {{wire: {{outer_diameter: 0.2, mass_per_length: 5, EA: 5.0e4, bending: false}}}}
bodies: {{buoy: {{floating: {{mass: 100, inertia: [10, 10, 10]}}}}}}
lines:
  wire:
    sections: &sections [{{type: wire, length: 10, elements: 1}}, {{type: wire, length: 1, elements: 1}}, {{type: wire, length: 10, elements: 1}}]
    end_a: {{anchor: [-9.8, 0, -2]}}
    end_b: {{anchor: [10.6, 0, -3]}}
  other:
    sections: *sections
    end_a: {{anchor: [-9.8, 5, -2]}}
    end_b: {}
)",
                                                         end_b),
                                             "/nowhere/case.yaml");
    run::Simulation sim(MPI_COMM_SELF, c);
    State s;
    s.resize(sim.local().nodes());
    const auto place = [&](size_t first, double y, bool bent) {
      const double a = bent ? 0.2 : 0;
      const double b = bent ? 0.3 : 0;
      s.x[first] = Vec3(-10 * std::cos(a), y, -10 * std::sin(a));
      s.x[first + 1] = Vec3(0, y, 0);
      s.x[first + 2] = Vec3(1, y, 0);
      s.x[first + 3] = Vec3(1 + 10 * std::cos(b), y, -10 * std::sin(b));
    };
    place(0, 0, true);
    place(4, 5, turns);
    std::vector<bool> touched(s.x.size(), false);
    for (const size_t n : {1, 2, 5, 6}) touched[n] = true;
    ElementErrors errors(MPI_COMM_SELF, c, sim.local(), nullptr, sim.system().find<LinePairs>());
    std::vector<double> tension(s.x.size(), 1000);
    for (const size_t n : {4, 5}) tension[n] = other.tension;
    ElementErrors::Values v{tension, {}, touched, touched};
    v.on_line = touched;
    if (force > 0) v.contacts = {{0, 0, other.on_itself * force}, {0, 1, force}};
    errors.update(s.at_rest(), v);
    return errors.warnings(0, largest, HUGE_VAL);
  };
  const std::string held = "{anchor: [10.6, 5, -3]}";
  ASSERT_EQ(warnings(false, held, 500, 1000).size(), 1U);
  EXPECT_EQ(
      warnings(false, held, 500, 1000).front(),
      "the straight elements of line wire over a line are 0.029 m longer than the curve over it, most "
      "at arc length 10.5 m (elements of 1 m, turn 29 degrees, t = 0 s); because both ends of the line are "
      "held, its tension is wrong by about 3.5 % of the largest: use elements of 0.29 m there");
  EXPECT_TRUE(warnings(false, held, 500, 2000).empty());
  ASSERT_EQ(warnings(true, held, 500, 2000).size(), 1U);
  EXPECT_TRUE(warnings(true, held, 500, 2000)
                  .front()
                  .ends_with("wrong by about 3.5 % of the largest: use elements of 0.57 m there"))
      << warnings(true, held, 500, 2000).front();
  EXPECT_TRUE(warnings(true, held, 500, 1000, {.tension = 0}).empty());
  for (const double on_itself : {2.0, 1 - 1e-9, 1 + 1e-9}) {
    const std::vector<std::string> of_itself = warnings(false, held, 500, 2000, {.on_itself = on_itself});
    ASSERT_EQ(of_itself.size(), 1U);
    EXPECT_TRUE(
        of_itself.front().ends_with("wrong by about 3.5 % of the largest: use elements of 0.29 m there"))
        << of_itself.front();
  }
  EXPECT_TRUE(warnings(true, held, 0, 2000).empty());
  EXPECT_TRUE(warnings(true, "{body: buoy, at: [10.6, 5, -3]}", 500, 1000).empty());
}

// A beam with decay length 0.5 m and elements of 1 m: the moment is constant on a volume from node 3 on and
// decays before. x = 2: 0.06 2/1.6 = 7.5 %.
TEST(ElementErrors, MomentWhereABendOnAVolumeBegins) {
  const auto warning = [](double decay, bool on_volume, const std::string& end_b = "free") {
    std::vector<double> moment;
    std::vector<bool> touched;
    for (int n = 0; n < 9; ++n) {
      moment.push_back(500 * std::exp(-std::max(3 - n, 0) / decay));
      touched.push_back(on_volume && n > 2);
    }
    return moment_warning(decay, moment, "end_b: " + end_b + "\n    start: {points: [[0, 0, 0], [8, 0, 0]]}",
                          touched);
  };
  EXPECT_EQ(
      warning(0.5, true),
      "the bending moment of line pipe decays within 0.5 m at arc length 3 m (t = 0 s), and with elements of "
      "1 m it is wrong by about 7.5 % of the largest: use elements of 0.09 m there");
  const std::string held = warning(0.5, true, "{anchor: [8, 0, 0]}");
  EXPECT_NE(held.find("7.5 % of the largest, and the tension between its held ends perhaps by more: use"),
            std::string::npos)
      << held;
  EXPECT_EQ(warning(0.5, false), "");
  EXPECT_EQ(warning(1.1, true), "");  // elements shorter than the decay length
}

}  // namespace
}  // namespace hawser::record::element_errors_test
