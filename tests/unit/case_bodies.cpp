// Contact between bodies in a case: requirements on the volumes of a pair, and the keys of bodies in water.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "support/shapes.hpp"

namespace hawser::case_bodies_test {
namespace {

namespace fs = std::filesystem;

std::string folder() {
  const fs::path path = fs::path(testing::TempDir()) / "hawser_case_bodies";
  fs::create_directories(path);
  return path.string();
}

void write(const char* name, const TriangleMesh& m) {
  std::ofstream out(folder() + "/" + name);
  for (const Vec3& x : m.vertices) out << "v " << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
  for (const auto& t : m.triangles) out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
}

// Message about two volumes of two floating bodies; empty: valid.
std::string wrong(const std::string& a, const std::string& b) {
  write("ball.obj", test::sphere_mesh(4));
  write("box.obj", test::box_mesh({-1, -1, -1}, {1, 1, 1}));
  try {
    run::load_volumes(
        io::read_case_text("hawser: 1\nbodies:\n"
                           "  A: {floating: {mass: 1000, inertia: [500, 600, 400]}}\n"
                           "  B: {position: [3, 0, 0], floating: {mass: 2000, inertia: [500, 600, 400]}}\n"
                           "volumes:\n  a: {" +
                               a + ", body: A}\n  b: {" + b +
                               ", body: B}\n"
                               "statics: false\ndynamics: {duration: 4}\n",
                           folder() + "/text.yaml"));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(CaseBodies, MeshesNeedNoLine) {
  const std::string box = "mesh: box.obj, normal_stiffness: {per_point: 1e6}";
  EXPECT_EQ(wrong(box, box), "");
  const std::string large = wrong("scale: 1e4, " + box, box);
  EXPECT_NE(
      large.find(":6: volumes.a.scale: the mesh, with scale 10000, is 2e+04 m large; is it in other units"),
      std::string::npos)
      << large;
}

TEST(CaseBodies, SomethingMustStandOutOfOne) {
  const auto ball = [](const char* basis) {
    return std::string("mesh: ball.obj, normal_stiffness: {") + basis + ": 1e6}";
  };
  const std::string box = "mesh: box.obj, normal_stiffness: ";
  EXPECT_EQ(wrong(ball("per_area"), ball("per_area")), "");
  EXPECT_EQ(wrong(ball("per_length"), box + "{per_length: 1e6}"),
            "");  // contact points are on the edges of the box
  EXPECT_EQ(wrong(ball("per_length"), box + "{per_point: 1e6}"), "");  // and here on its corners
  EXPECT_EQ(wrong(ball("per_length"),
                  "shape: {sphere: {centre: [0, 0, 0], radius: 1}}, "
                  "normal_stiffness: {per_point: 1e6}"),
            "");
  const std::string both = wrong(ball("per_length"), ball("per_length"));
  EXPECT_NE(both.find(":6: volumes.a.normal_stiffness: 'a' is to meet 'b' with its edges (per_length), but "
                      "neither mesh has an edge of more than 10 deg"),
            std::string::npos)
      << both;
  // Contact points are placed on corners before edges.
  const std::string one = wrong(ball("per_point"), box + "{per_length: 1e6}");
  EXPECT_NE(one.find("with its corners (per_point), but its mesh has none of more than 10 deg"),
            std::string::npos)
      << one;
  EXPECT_NE(one.find("give a stiffness per_area"), std::string::npos) << one;
}

// Message about a body in water; empty: valid.
std::string wrong_in_water(const std::string& in_water,
                           const std::string& environment = "water: {density: 1000}",
                           const std::string& weight = "true") {
  try {
    io::read_case_text(
        "hawser: 1\nenvironment: {" + environment +
            "}\nbodies:\n  A:\n    floating:\n      mass: 1000\n      inertia: [500, 600, 400]\n"
            "      weight: " +
            weight + "\n      in_water: {" + in_water + "}\ndynamics: {duration: 4}\n",
        folder() + "/text.yaml");
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(CaseBodies, BodyInWater) {
  const std::string fine = "volume: 2 m3, height: 3";
  EXPECT_EQ(wrong_in_water(fine), "");
  const auto expect_message = [](const std::string& all, const std::string& part) {
    EXPECT_NE(all.find(part), std::string::npos) << all;
  };
  expect_message(wrong_in_water(fine, "gravity: 9.81"),
                 ":9: bodies.A.floating.in_water: there is no water: give 'environment: {water: ...}'");
  expect_message(
      wrong_in_water(fine, "water: {density: 1000}", "false"),
      ":9: bodies.A.floating.in_water: adds the buoyancy of the body, so its weight must act as well");
  expect_message(wrong_in_water("volume: -2, height: 3"), "in_water.volume");
  expect_message(wrong_in_water("volume: 2, height: 0"), "in_water.height");
  expect_message(wrong_in_water("volume: 2"), "height");
  expect_message(wrong_in_water(fine + ", drag_area: [1, -1, 1]"), "in_water.drag_area");
  expect_message(wrong_in_water(fine + ", Ca: [1, 1, 1], added_mass: [1, 1, 1]"), "added_mass");
  expect_message(wrong_in_water(fine + ", center_of_buoyancy: [1, 1, 1]"), "centre_of_buoyancy");
}

// Drag coefficients times areas, added mass by coefficient or directly, drag at the centre of buoyancy or a
// given one.
TEST(CaseBodies, KeysOfABodyInWater) {
  const auto read = [](const std::string& keys) {
    return *io::read_case_text(
                "hawser: 1\nenvironment: {water: {density: 1000}}\nbodies: {A: {floating: {mass: "
                "1000, inertia: [500, 600, 400], weight: true, in_water: {volume: 2, height: 3, " +
                    keys + "}}}}\ndynamics: {duration: 4}\n",
                folder() + "/text.yaml")
                .bodies[0]
                .mass->in_water;
  };
  model::BodyInWater w =
      read("centre_of_buoyancy: [1, 2, 3], drag_area: [1, 2, 3], Cd: [2, 1, 0.5], Ca: [1, 0, 2]");
  EXPECT_EQ(w.drag_centre, Vec3(1, 2, 3));
  EXPECT_EQ(w.drag_area, Vec3(2, 2, 1.5));
  EXPECT_EQ(w.added_mass, Vec3(2000, 0, 4000));
  w = read("centre_of_drag: [0, 0, 1], drag_area: [1, 2, 3], added_mass: [1 t, 2 t, 3 t]");
  EXPECT_EQ(w.drag_centre, Vec3(0, 0, 1));
  EXPECT_EQ(w.drag_area, Vec3(1, 2, 3));
  EXPECT_EQ(w.added_mass, Vec3(1000, 2000, 3000));
}

}  // namespace
}  // namespace hawser::case_bodies_test
