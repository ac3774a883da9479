// Lines from one place, or from places nearer to each other than the lines' diameter: contact does not push
// them apart there.
#include <fmt/format.h>

#include <cmath>

#include "hawser/io/case_reader.hpp"
#include "support/rig.hpp"

namespace hawser::test::shared_places {
namespace {

struct AtRest {
  std::vector<Vec3> x;
  std::vector<double> tension;  // N, effective, at the nodes
  std::vector<std::string> notes;
};

AtRest at_rest(const std::string& text) {
  Simulation sim(PETSC_COMM_SELF, io::read_case_text(text, "places.yaml"));
  sim.solve_statics();
  AtRest out{sim.state().x, std::vector<double>(sim.state().x.size(), 0), sim.notes()};
  const FieldRegistry fields = sim.system().fields();
  for (const FieldSource& f : fields.sources())
    if (f.name == "effective_tension") f.fill(sim.state().at_rest(), out.tension);
  return out;
}

void expect_same(const AtRest& with, const AtRest& without, double tolerance, const std::string& what) {
  ASSERT_EQ(with.x.size(), without.x.size());
  double off = 0, most = 0;
  for (size_t n = 0; n < with.x.size(); ++n) {
    off = std::max(off, std::abs(with.tension[n] - without.tension[n]));
    most = std::max(most, without.tension[n]);
  }
  EXPECT_LT(off, tolerance * most) << what;
}

// A sling of 30 m, 50 kg/m in air, with both ends at one hook or near each other. By hand each end carries
// half of the weight, 0.5 * 30 * 50 * 9.80665 = 7355 N.
TEST(SharedPlaces, EndsOfASlingOnOneHook) {
  for (const double apart : {0.0, 0.02, 0.05, 0.09}) {
    const AtRest r = at_rest(fmt::format(
        "hawser: 1\nline_types: {{c: {{outer_diameter: 0.1, mass_per_length: 50, EA: 250 MN, bending: "
        "false}}}}\n"
        "lines:\n  m: {{sections: [{{type: c, length: 30, elements: 30}}], end_a: {{anchor: [0, 0, 0]}}, "
        "end_b: {{anchor: [{}, 0, 0]}}}}\n",
        apart));
    // The field is the tension in the middle of the last element, less by half of its weight.
    const double half = 0.5 * 30 * 50 * 9.80665 - 0.5 * 50 * 9.80665;
    EXPECT_NEAR(r.tension.front(), half, 0.01 * half) << apart;
    EXPECT_NEAR(r.tension.back(), half, 0.01 * half) << apart;
    const bool reported = std::any_of(r.notes.begin(), r.notes.end(), [](const std::string& n) {
      return n.find("both ends of line m are at one place") == 0;
    });
    EXPECT_TRUE(reported) << apart;
  }
}

// Three slack chains on one fairlead. End forces are those of a quasi-static program and of the case without
// contact: of the middle chain (-12.2, 0, -231.3) kN, 231.6 kN in all.
std::string fairlead(const std::string& contact, double apart = 0) {
  const auto chain = [&](const char* name, double length, double y, double at) {
    return fmt::format(
        "  {}: {{sections: [{{type: main, length: {}, elements: 60}}], end_a: {{anchor: [-152, {}, -50]}}, "
        "end_b: "
        "{{body: p, at: [-34, {}, -10]}}}}\n",
        name, length, y, at);
  };
  return "hawser: 1\nenvironment: {water: {depth: 50}, seabed: {depth: 50, normal_stiffness: {per_area: "
         "3.0e6}}}\n"
         "line_types: {main: {outer_diameter: 0.324, mass_per_length: 644.8, EA: 8.54 GN, bending: false, "
         "Cd_normal: 2.4, Cd_axial: 1.15, Ca_axial: 0.5}}\nbodies: {p: {}}\n" +
         contact + "lines:\n" + chain("l1", 160, -50, -apart) + chain("l2", 152, 0, 0) +
         chain("l3", 160, 50, apart);
}

TEST(SharedPlaces, SlackChainsOnOneFairlead) {
  const std::string none = "contact: {between_lines: false}\n";
  for (const double apart : {0.0, 0.2}) {
    const AtRest with = at_rest(fairlead("", apart));
    const AtRest without = at_rest(fairlead(none, apart));
    expect_same(with, without, 1e-4, fmt::format("{} m apart", apart));
    if (apart > 0) continue;
    const double element = 152.0 / 60, weight = (644.8 - 1025 * M_PI / 4 * 0.324 * 0.324) * 9.80665;
    EXPECT_NEAR(with.tension[121], 231.6e3 - 0.5 * element * weight, 0.01 * 231.6e3);
  }
}

// A line ends at a joint from which two others lead at a small angle; statics finds the position of the
// joint.
TEST(SharedPlaces, LinesThatPartAtAJoint) {
  const auto frame = [](const std::string& contact) {
    return "hawser: 1\nline_types: {c: {outer_diameter: 0.2, mass_per_length: 60, EA: 250 MN, bending: "
           "false}}\n" +
           contact +
           "joints: {j: {start: [0, 0, -15]}}\nlines:\n"
           "  up: {sections: [{type: c, length: 20, elements: 20}], end_a: {anchor: [0, 0, 0]}, end_b: "
           "{joint: j}}\n"
           "  p: {sections: [{type: c, length: 30, elements: 30}], end_a: {joint: j}, end_b: {anchor: [22, "
           "2, -30]}}\n"
           "  q: {sections: [{type: c, length: 30, elements: 30}], end_a: {joint: j}, end_b: {anchor: [22, "
           "-2, -30]}}\n";
  };
  expect_same(at_rest(frame("")), at_rest(frame("contact: {between_lines: false}\n")), 1e-4, "joint");
}

// Straight lines at the angle a do not overlap beyond R/(2 sin(a/2)); contact is excluded up to twice that.
// The excluded length is updated to the angle in statics; in motion it only decreases.
TEST(SharedPlaces, FollowTheAngle) {
  const double R = 0.2, length = 20;
  const auto fan = [&](double angle) {
    model::Case c = one_line(cable_type(1e6, 1), length, 40, anchor({0, 0, 0}), anchor({length, 0, 0}));
    c.lines.push_back(c.lines[0]);
    c.lines[1].name = "other";
    c.lines[1].end_b = anchor({length * std::cos(angle), length * std::sin(angle), 0});
    for (model::Line& l : c.lines) l.start = model::Start::straight;
    return c;
  };
  const auto within = [&](double angle) { return 2 * R / (2 * std::sin(angle / 2)); };
  Simulation sim(PETSC_COMM_SELF, fan(0.2));
  SharedPlaces places(PETSC_COMM_SELF, sim.local(), ContactRadii({R / 2}), {{{0}, {41}}}, {});
  const auto at = [&](double angle, bool in_statics) {
    State s = sim.state();
    for (size_t n = 41; n < 82; ++n) {
      const double r = length * static_cast<double>(n - 41) / 40;
      s.x[n] = Vec3(r * std::cos(angle), r * std::sin(angle), 0);
    }
    places.update(s.at_rest(), in_statics);
    const double once = places.free_length(0);
    places.update(s.at_rest(), in_statics);
    EXPECT_EQ(places.free_length(0), once) << angle;
    return once;
  };
  const double step = R / 4;
  for (const double angle : {0.2, 0.1, 0.05, 0.3})
    EXPECT_NEAR(at(angle, true), within(angle), 2.01 * step) << angle;
  for (const double angle : {0.4, 0.8, 0.2})
    EXPECT_NEAR(at(angle, false), within(std::max(angle, angle == 0.2 ? 0.8 : angle)), 2.01 * step) << angle;
}

}  // namespace
}  // namespace hawser::test::shared_places
