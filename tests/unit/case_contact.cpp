// Largest width of contact ramps relative to the thickness of the lines, and friction between bodies.
#include <gtest/gtest.h>

#include <string>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/model/body_pairs.hpp"

namespace hawser::case_contact_test {
namespace {

// Message about a chain of 0.1 m beside two hoses of 0.6 m, a fender and this contact; empty: valid.
std::string wrong(const std::string& fender, const std::string& contact) {
  try {
    io::read_case_text(R"(hawser: 1
line_types:
  thick: {outer_diameter: 0.6, mass_per_length: 300, EA: 1e8, EI: 1e5, GJ: 1e5}
  thin: {outer_diameter: 0.1, mass_per_length: 30, EA: 1e8, bending: false}
lines:
  hose: {sections: [{type: thick, length: 100, elements: 10}], end_a: {anchor: [0, 0, 0]}, end_b: {anchor: [90, 0, 0]}}
  other: {sections: [{type: thick, length: 100, elements: 10}], end_a: {anchor: [0, 9, 0]}, end_b: {anchor: [90, 9, 0]}}
  chain: {sections: [{type: thin, length: 100, elements: 10}], end_a: {anchor: [0, 5, 0]}, end_b: {anchor: [90, 5, 0]}}
bodies:
  ship: {position: [0, 40, 0], floating: {mass: 1000, inertia: [500, 600, 400]}}
  quay: {position: [0, 60, 0]}
volumes:
  fender: {shape: {sphere: {centre: [0, 0, 0], radius: 1}}, smoothing: )" +
                           std::string(contact.empty() ? "0.2, " : "0.05, ") + fender + "}\n" + contact +
                           "dynamics: {duration: 1}\n",
                       "ramps.yaml");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

std::string crate(const std::string& slope, const std::string& load, const std::string& shape,
                  const char* basis) {
  return R"(hawser: 1
bodies:
  crate: {position: [0, 0, 0.3], floating: {mass: 600, inertia: [26, 58, 68], weight: true}}
volumes:
  slope: {shape: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}})" +
         slope + "}\n  crate: {shape: {" + shape + "}, body: crate, normal_stiffness: {" + basis +
         ": 1.0e7}" + load + "}\nstatics: false\ndynamics: {duration: 1}\n";
}

constexpr const char* kCrate = "box: {centre: [0, 0, 0], size: [1, 0.6, 0.4]}";
constexpr const char* kBar = "capsule: {from: [0, 0, 0], to: [1, 0, 0], radius: 0.2}";

// Contact between two volumes uses the lowest coefficient.
TEST(CaseContact, FrictionBetweenBodies) {
  const auto between = [](const std::string& slope, const std::string& load) {
    const auto pairs =
        model::body_pairs(io::read_case_text(crate(slope, load, kCrate, "per_point"), "crate.yaml"));
    EXPECT_EQ(pairs.size(), 1U);
    return pairs.at(0).friction;
  };
  EXPECT_EQ(between("", "").axial, 0);
  EXPECT_EQ(between(", friction: 0.5", ", friction: 0.3").axial, 0.3);
  EXPECT_EQ(between(", friction: 0.2", ", friction: 0.3").axial, 0.2);
  EXPECT_EQ(between(", friction: {axial: 0.1, lateral: 0.4}", ", friction: 0.3").lateral, 0.1);
  // The other parts of the law are those of the volume whose corners lead.
  const std::string soft = ", friction: {axial: 0.3, shear_stiffness: 1e6}";
  EXPECT_EQ(between(", friction: 0.2", soft).shear_stiffness, 1e6);
  EXPECT_EQ(between(soft, ", friction: 0.2").shear_stiffness, 0);
}

// The lowest coefficient counts when sliding as well; a volume without `kinetic` has its coefficient at rest.
// The corners of the crate, given second, are those of the slave, and its blend speed counts before the
// other.
TEST(CaseContact, KineticFrictionBetweenBodies) {
  const auto expect = [](const std::string& slope, const std::string& load, double kinetic, double speed) {
    const auto pairs = model::body_pairs(io::read_case_text(
        crate(", friction: " + slope, ", friction: " + load, kCrate, "per_point"), "crate.yaml"));
    ASSERT_EQ(pairs.size(), 1U);
    const model::Friction& f = pairs[0].friction;
    EXPECT_EQ(f.axial_kinetic, kinetic) << slope << load;
    EXPECT_EQ(f.lateral_kinetic, kinetic) << slope << load;
    EXPECT_EQ(f.blend_speed, speed) << slope << load;
    EXPECT_LE(f.axial_kinetic, f.axial) << slope << load;
  };
  const std::string fast = "{axial: 0.5, kinetic: 0.2, blend_speed: 0.1}";
  const std::string slow = "{axial: 0.5, kinetic: 0.3, blend_speed: 0.01}";
  expect(fast, slow, 0.2, 0.01);
  expect(slow, fast, 0.2, 0.1);
  expect(fast, "0.5", 0.2, 0.1);
  expect("0.5", fast, 0.2, 0.1);
  expect("0.1", fast, 0.1, 0.1);
  expect(fast, "0.1", 0.1, 0.1);
  expect("{axial: 0.5, kinetic: {axial: 0.4, lateral: 0.15}, blend_speed: 1}", slow, 0.15, 0.01);
}

TEST(CaseContact, FrictionOfBodiesWithoutEffect) {
  const auto refused = [](const std::string& text) {
    try {
      io::read_case_text(text, "crate.yaml");
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string
      half = ", friction: 0.5",
      line =
          "line_types: {rope: {outer_diameter: 0.1, mass_per_length: 10, EA: 1e7, bending: false}}\n"
          "lines: {l: {sections: [{type: rope, length: 10, elements: 5}], end_a: {anchor: [5, 5, 5]}, end_b: "
          "free}}\n";
  EXPECT_NE(
      refused(crate(half, "", kCrate, "per_point")).find("volumes.slope.friction: has no effect: between"),
      std::string::npos);
  EXPECT_EQ(refused(crate(half, "", kCrate, "per_point") + line), "");
  for (const char* basis : {"per_point", "per_length"})
    EXPECT_EQ(refused(crate(half, half, kBar, basis)), "");
  // A smooth volume of a body that has a rough one, too.
  const std::string two = crate(half, half, kCrate, "per_point");
  const auto statics = two.find("statics:");
  EXPECT_EQ(refused(two.substr(0, statics) +
                    "  hull: {shape: {sphere: {centre: [0, 0, 2], radius: 0.1}}, body: crate, "
                    "normal_stiffness: {per_point: 1e7}, friction: 0}\n" +
                    two.substr(statics)),
            "");
}

TEST(CaseContact, RampsGoByTheLinesTheyActOn) {
  for (const char* body : {"body: ship", "body: quay"})
    EXPECT_NE(wrong(body, "").find("volumes.fender.smoothing: a ramp of 0.2 m"), std::string::npos);
  const auto pair = [](const char* lines, const char* ramp) {
    return std::string("contact: {between_lines: {pairs: [{lines: [") + lines + "], smoothing: " + ramp +
           "}]}}\n";
  };
  EXPECT_EQ(wrong("body: ship", pair("hose, other", "0.3")), "");
  EXPECT_NE(wrong("body: ship", pair("hose, chain", "0.3")).find("pairs[0].smoothing: a ramp of 0.3 m"),
            std::string::npos);
}

}  // namespace
}  // namespace hawser::case_contact_test
