// Cases of bodies that touch each other: what a mesh must be for that, alone and beside its counterpart.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "hawser/app/volumes.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
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

// What is wrong with two volumes of two floating bodies; empty: nothing.
std::string wrong(const std::string& a, const std::string& b) {
  write("ball.obj", test::sphere_mesh(4));
  write("box.obj", test::box_mesh({-1, -1, -1}, {1, 1, 1}));
  try {
    app::load_volumes(
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
  EXPECT_EQ(wrong(ball("per_length"), box + "{per_length: 1e6}"), "");  // the box's edges meet it
  EXPECT_EQ(wrong(ball("per_length"), box + "{per_point: 1e6}"), "");   // its corners do
  EXPECT_EQ(wrong(ball("per_length"),
                  "shape: {sphere: {centre: [0, 0, 0], radius: 1}}, "
                  "normal_stiffness: {per_point: 1e6}"),
            "");
  const std::string both = wrong(ball("per_length"), ball("per_length"));
  EXPECT_NE(both.find(":6: volumes.a.normal_stiffness: 'a' is to meet 'b' with its edges (per_length), but "
                      "neither mesh has an edge of more than 10 deg"),
            std::string::npos)
      << both;
  // Points lead before edges.
  const std::string one = wrong(ball("per_point"), box + "{per_length: 1e6}");
  EXPECT_NE(one.find("with its corners (per_point), but its mesh has none of more than 10 deg"),
            std::string::npos)
      << one;
  EXPECT_NE(one.find("give a stiffness per_area"), std::string::npos) << one;
}

}  // namespace
}  // namespace hawser::case_bodies_test
