// Supports of laid pipes: positions of boxes and rollers, and refusals with remedies.
#include <gtest/gtest.h>

#include <string>

#include "hawser/advice/limits.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/kernels/support_path.hpp"

namespace hawser::case_supports_test {
namespace {

model::Case read(const std::string& boxes,
                 const std::string& path =
                     "from: [-30, 0, 9], direction: [-1, 0, 0], "
                     "segments: [{length: 20}, {length: 100, radius: 150}]",
                 const std::string& end = "[-30, 0, 10.325]", const std::string& more = "") {
  return io::read_case_text(
      "hawser: 1\nline_types: {pipe: {outer_diameter: 0.25, mass_per_length: 90, EA: 2e9, EI: 1.6e7, GJ: "
      "1e7}}\n"
      "bodies: {barge: {position: [50, 0, 0]}}\nsupports:\n  ramp:\n    body: barge\n" +
          (path.empty() ? "" : "    path: {" + path + "}\n") + "    boxes: [" + boxes +
          "]\nlines:\n  pipe: {sections: [{type: pipe, length: 595, elements: 200}], end_a: {body: barge, "
          "at: " +
          end + "}, end_b: {anchor: [-549.9, 0, -99.875]}}\n" + more,
      "supports.yaml");
}

std::string wrong(const std::string& boxes,
                  const std::string& path =
                      "from: [-30, 0, 9], direction: [-1, 0, 0], "
                      "segments: [{length: 20}]",
                  const std::string& end = "[-30, 0, 10.325]", const std::string& more = "") {
  try {
    read(boxes, path, end, more);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

const std::string kRoller = ", roller_diameter: 0.4, roller_length: 2";

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).norm(), 1e-9) << a.transpose(); }

TEST(SupportPath, GoesStraightAndDownAnArc) {
  const SupportPath path(Vec3(0, 0, 5), Vec3(0, 1, 0), {{10, 0}, {M_PI * 20, 40}, {7, 0}});
  EXPECT_DOUBLE_EQ(path.length(), 17 + M_PI * 20);
  expect_near(path.at(4).at, Vec3(0, 4, 5));
  const double a = 0.3;
  expect_near(path.at(10 + 40 * a).at, Vec3(0, 10 + 40 * std::sin(a), 5 - 40 * (1 - std::cos(a))));
  expect_near(path.at(10 + 40 * a).along, Vec3(0, std::cos(a), -std::sin(a)));
  expect_near(path.at(10 + 40 * a).up, Vec3(0, std::sin(a), std::cos(a)));
  EXPECT_NEAR(path.at(10 + 40 * a).dip, a, 1e-12);
  expect_near(path.at(path.length()).at, Vec3(0, 50, 5 - 47));
}

TEST(SupportPath, DirectionsOfPointsAreThoseOfTheirParabola) {
  std::vector<Vec3> p;
  for (const double a : {0., 0.05, 0.1, 0.15}) p.emplace_back(60 * std::sin(a), 0, 60 * std::cos(a));
  for (size_t i = 0; i < p.size(); ++i) {
    const Vec3 tangent(std::cos(0.05 * static_cast<double>(i)), 0, -std::sin(0.05 * static_cast<double>(i)));
    EXPECT_LT((direction_at(p, i) - tangent).norm(), i % 3 ? 1e-9 : 1e-3) << i;
  }
}

TEST(CaseSupports, BoxesOfEachType) {
  const model::Case c = read("{at: [10, 5], above_path: 1, type: U, side_height: 1" + kRoller +
                             "}, {at: 35, type: V, angle_deg: 30, normal_stiffness: 2e6" + kRoller +
                             "}, {at: 60, type: box, side_height: 1" + kRoller + "}, {at: 80, type: flat" +
                             kRoller + ", friction: 0.1}");
  ASSERT_EQ(c.supports.size(), 5u);
  ASSERT_EQ(c.volumes.size(), 3u + 3 + 2 + 4 + 1);
  const auto& first = c.supports[0];
  EXPECT_EQ(first.name, "ramp 1");
  EXPECT_EQ(first.line, "pipe");
  expect_near(first.at,
              Vec3(-35, 0, 10.325));  // half of the roller diameter and half of the pipe's above the axis
  expect_near(c.supports[1].at, Vec3(-40, 0, 10.325));
  const auto cylinder = [&](const std::string& name) {
    for (const model::Volume& v : c.volumes)
      if (v.name == name) {
        EXPECT_EQ(v.body, "barge");
        return std::get<CylinderShape>(*v.shape);
      }
    ADD_FAILURE() << name;
    return CylinderShape{};
  };
  // The path goes to -x, so that left is -y.
  expect_near(cylinder("ramp 1 below").from, Vec3(-35, -1, 10));
  expect_near(cylinder("ramp 1 below").to, Vec3(-35, 1, 10));
  EXPECT_DOUBLE_EQ(cylinder("ramp 1 below").radius, 0.2);
  expect_near(cylinder("ramp 1 left").from, Vec3(-35, -1.2, 10));
  expect_near(cylinder("ramp 1 left").to, Vec3(-35, -1.2, 11.2));
  const double a = 15. / 150;
  const Vec3 v(-50 - 150 * std::sin(a), 0, 9 - 150 * (1 - std::cos(a)));
  const Vec3 up(-std::sin(a), 0, std::cos(a));
  expect_near(cylinder("ramp 3 right").from, v);
  expect_near(cylinder("ramp 3 right").to,
              v + 2 * (std::cos(M_PI / 6) * Vec3::UnitY() + std::sin(M_PI / 6) * up));
  expect_near(c.supports[2].at, v + 0.325 / std::cos(M_PI / 6) * up);
  EXPECT_EQ(c.supports[3].rollers, (std::vector<std::string>{"below", "left", "right", "above"}));
  EXPECT_NEAR((cylinder("ramp 4 above").from - cylinder("ramp 4 below").from).norm(), 1.4, 1e-12);
  // A spring of 2e6 N/m at a penetration of 1 % of the pipe's radius: 4/3 k d sqrt(2 r d) for a parabola.
  const double d = 0.00125;
  const double k = c.volumes[6].normal_stiffness;
  EXPECT_EQ(c.volumes[6].basis, model::StiffnessBasis::per_length);
  EXPECT_NEAR(4. / 3 * k * d * std::sqrt(2 * 0.325 * d), 2e6 * d, 1e-6);
  EXPECT_EQ(c.volumes[0].basis, model::StiffnessBasis::automatic);
  EXPECT_EQ(c.volumes.back().friction.axial, 0.1);
}

TEST(CaseSupports, ByPoints) {
  const model::Case c =
      read("{points: [[-40, 0, 10], [-50, 0, 9.8], [-60, 0, 9.2]], type: flat" + kRoller + "}", "");
  ASSERT_EQ(c.supports.size(), 3u);
  EXPECT_NEAR(c.supports[1].along.x(), -1, 2e-3);
  EXPECT_LT(c.supports[2].along.z(), c.supports[1].along.z());
  expect_near(c.supports[0].at, Vec3(-40, 0, 10) + 0.325 * c.supports[0].up);
}

// Each box of a group on a structure is attached to the nearest point of its beams, at its position in the
// body's frame.
TEST(CaseSupports, OnAStructure) {
  const auto with = [](const std::string& on, const std::string& girder) {
    return io::read_case_text(
        "hawser: 1\nline_types: {pipe: {outer_diameter: 0.25, mass_per_length: 90, EA: 2e9, EI: 1.6e7, GJ: "
        "1e7},"
        " wire: {outer_diameter: 0.1, mass_per_length: 40, EA: 1e8, bending: false}}\n"
        "bodies: {barge: {position: [50, 0, 1], motion: {velocity: [1, 0, 0]}}}\n"
        "supports: {ramp: {body: barge, on: " +
            on +
            ", line: pipe, path: {from: [0, 0, 0], direction: [-1, 0, 0], "
            "segments: [{length: 30}]}, boxes: [{at: [5, 21], type: flat, roller_diameter: 0.4, "
            "roller_length: 2}]}}\n"
            "lines:\n  pipe: {sections: [{type: pipe, length: 95, elements: 20}], end_a: {body: barge, at: "
            "[5, 0, "
            "0.325]}, end_b: {anchor: [-40, 0, 1]}}\n"
            "  front: {sections: [{type: pipe, length: 20, elements: 4}], end_a: {body: barge, at: [0, 0, "
            "-1]}, end_b: "
            "{body: "
            "barge, at: [-20, 0, -1]}}\n  rear: {sections: [{type: " +
            girder +
            ", length: 10, elements: 2}], end_a: {body: barge, "
            "at: [-20, 0, -1]}, end_b: free}\n"
            "contact: {lines: [pipe]}\n",
        "supports.yaml");
  };
  const model::Case c = with("[front]", "pipe");
  ASSERT_EQ(c.bodies.size(), 3u);
  for (const int i : {0, 1}) {
    const model::Body& b = c.bodies[static_cast<size_t>(i + 1)];
    EXPECT_EQ(b.name, c.supports[static_cast<size_t>(i)].name);
    EXPECT_EQ(c.volumes[static_cast<size_t>(i)].body, b.name);
    ASSERT_TRUE(b.ride && b.ride->placed_in_space);
    EXPECT_EQ(b.ride->line, "front");
    EXPECT_NEAR(b.ride->at, i ? 20 : 5, 1e-12);
    expect_near(b.position, Vec3(50, 0, 1));
  }
  const auto message = [&](const std::string& on, const std::string& girder = "pipe") -> std::string {
    try {
      with(on, girder);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(message("[rear]").find("line 'rear' has a free end"), std::string::npos) << message("[rear]");
  EXPECT_NE(message("[pipe]").find("line 'pipe' is laid over these supports itself"), std::string::npos);
  EXPECT_NE(message("[front, stern]").find("'stern'"), std::string::npos);
}

TEST(CaseSupports, WhatIsWrongIsReportedWithItsRemedy) {
  const auto expect_message = [](const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  const std::string flat = ", type: flat" + kRoller + "}";
  expect_message(wrong("{at: 25" + flat), "a box 25 m along the path is beyond its end at 20 m");
  expect_message(wrong("{at: 5, type: V" + kRoller + "}"),
                 "angle_deg: required key is missing: a support of type 'V' needs it");
  expect_message(wrong("{at: 5, type: V, angle_deg: 85" + kRoller + "}"), "angle_deg");
  expect_message(wrong("{at: 5, type: U, angle_deg: 30, side_height: 1" + kRoller + "}"),
                 "a support of type 'U' has none");
  expect_message(wrong("{at: 5, type: box, side_height: 0.2" + kRoller + "}"),
                 "a clear height of 0.2 m is less than");
  expect_message(wrong("{at: 5, type: U, side_height: 1, roller_diameter: 0.4, roller_length: 0.2}"),
                 "a clear width of 0.2 m");
  expect_message(wrong("{points: [[0, 0, 0]]" + flat), "has a 'path'");
  expect_message(wrong("{at: 5" + flat, ""), "is a length along 'path', which the group has not");
  expect_message(wrong("{points: [[0, 0, 0]]" + flat, ""), "one point does not define the direction");
  expect_message(wrong("{at: 5" + flat, "from: [0, 0, 9], direction: [0, 0, -1], segments: [{length: 20}]"),
                 "is vertical");
  expect_message(
      wrong("{at: 95" + flat, "from: [0, 0, 9], direction: [-1, 0, 0], segments: [{length: 95, radius: 60}]"),
      "must stay below 90");
  expect_message(wrong("{at: 5" + flat, "from: [-20, 0, 9], direction: [1, 0, 0], segments: [{length: 20}]",
                       "[-10, 0, 10]"),
                 "lies 5 m behind 'lines.pipe.end_a'");
  expect_message(
      wrong("{at: 5" + flat, "from: [-30, 0, 12], direction: [-1, 0, 0], segments: [{length: 20}]"),
      "the line would start below the roller");
  expect_message(wrong("{points: [[-35, 0, 10], [-50, 0, 10], [-45, 0, 10]]" + flat, ""),
                 "lies behind 'ramp 1'");
  expect_message(wrong("{at: 5" + flat, "from: [-30, 0, 9], direction: [-1, 0, 0], segments: [{length: 20}]",
                       "[-30, 0, 10.325]", "output: {histories: [{line: pipe, at: 5, name: ramp 1}]}\n"),
                 "there is another history called 'ramp 1'");
}

// The yield stress of pipe steel is defined at a strain of 0.5 %; beyond it, the pipe is not elastic.
TEST(CaseSupports, WhatWasBentBeyondYieldIsWarnedOf) {
  const model::Case c = read("{at: 5, type: flat" + kRoller + "}");
  advice::Extreme at{"pipe", 0.041, 2, 12};
  EXPECT_NE(advice::curvature_warning(c, at).find("0.51 % of strain"), std::string::npos)
      << advice::curvature_warning(c, at);
  at.value = 0.039;
  EXPECT_EQ(advice::curvature_warning(c, at), "");
}

TEST(CaseSupports, SharpBendsAndLongElementsGiveWarnings) {
  const auto notes = [](double radius, const std::string& at) {
    const model::Case c =
        read("{at: " + at + ", type: flat" + kRoller + "}",
             "from: [-30, 0, 9], direction: [-1, 0, 0], segments: [{length: 20}, {length: 30, radius: " +
                 std::to_string(radius) + "}]",
             "[-30, 0, 9.325]");
    std::string all;
    for (const std::string& n : c.notes) all += n + "\n";
    return all;
  };
  // The elements are 3 m long, and a pipe of 0.25 m is bent to 0.125 / R.
  EXPECT_EQ(notes(150, "[25, 35, 45]"), "");
  EXPECT_NE(
      notes(150, "[25, 30, 35]").find("elements are 2.98 m long between supports 'ramp 1' and 'ramp 2'"),
      std::string::npos);
  EXPECT_NE(notes(20, "[25, 35, 45]").find("bent to a radius of 20."), std::string::npos)
      << notes(20, "[25, 35, 45]");
}

// Events select rollers by the name of their group, of their box, or by their own.
TEST(TiedNodes, AreSwitchedByName) {
  const auto off = [](const std::string& name) {
    const model::Case c = read(
        "{at: 5, type: flat" + kRoller + "}, {at: 15, type: flat" + kRoller + "}",
        "from: [-30, 0, 9], direction: [-1, 0, 0], segments: [{length: 20}]", "[-30, 0, 10.325]",
        "dynamics: {duration: 5}\nevents: [{contact: {volume: " + name + ", enabled: true}, time: 1}]\n");
    std::string out;
    for (const model::Volume& v : c.volumes) out += c.off_at_start(v) ? '-' : '+';
    return out;
  };
  EXPECT_EQ(off("ramp"), "--");
  EXPECT_EQ(off("ramp 2"), "+-");
  EXPECT_EQ(off("ramp 1 below"), "-+");
}

}  // namespace
}  // namespace hawser::case_supports_test
