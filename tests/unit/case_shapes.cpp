// Volumes given as shapes: their surfaces for contact against closed forms, and their triangles for display.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/model/summary.hpp"
#include "hawser/run/volumes.hpp"

namespace hawser::case_shapes_test {
namespace {

namespace fs = std::filesystem;

model::Case read(const std::string& volumes) {
  const std::string text =
      "hawser: 1\n"
      "line_types:\n"
      "  hose: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, EI: 1e4, GJ: 1e4}\n"
      "bodies:\n"
      "  barge: {position: [0, 0, 10], rotation_deg: [0, 0, 90]}\n"
      "volumes:\n" +
      volumes +
      "lines:\n"
      "  a: {sections: [{type: hose, length: 100, elements: 10}], end_a: {body: barge, at: [0, 0, 0]},\n"
      "      end_b: {anchor: [60, 0, -60]}}\n";
  return io::read_case_text(text, (fs::path(HAWSER_SOURCE_DIR) / "tests/data/bad/text.yaml").string());
}

TEST(CaseShapes, OfEveryKind) {
  const model::Case c = read(
      "  p: {shape: {plane: {point: [0, 0, -60 m], normal: [0, 0, 5]}}}\n"
      "  b: {body: barge, shape: {box: {centre: [1, 2, 3], size: [400 mm, 2, 6], rotation_deg: [0, 0, "
      "90]}}}\n"
      "  s: {shape: {sphere: {centre: [0, 0, 1], radius: 500 mm}}}\n"
      "  y: {shape: {cylinder: {from: [0, -1, 0], to: [0, 1, 0], radius: 0.25}}, friction: 0.3}\n"
      "  c: {shape: {capsule: {from: [0, 0, 0], to: [4, 0, 0], radius: 0.5}}}\n"
      "  t: {shape: {torus: {centre: [0, 0, 1], axis: [0, 2, 0], radius: 4, tube_radius: 1}}}\n"
      "  j: {shape: {tube: {path: [[0, 0, 8], [0, 0, -4], [5, 0, -4], [9 m, 4, -4]], bend_radius: [3, 1500 "
      "mm],\n"
      "                    inner_radius: 0.25, wall_thickness: 30 mm}}}\n"
      "  i: {shape: {tube: {path: [[0, 0, 8], [0, 0, -4]], inner_radius: 0.25, wall_thickness: 0.03}}}\n");
  ASSERT_EQ(c.volumes.size(), 8U);
  for (const model::Volume& v : c.volumes) EXPECT_TRUE(v.shape && v.mesh.empty()) << v.name;
  const auto& box = std::get<BoxShape>(*c.volumes[1].shape);
  EXPECT_EQ(box.size, Vec3(0.4, 2, 6));
  EXPECT_NEAR(box.rotation.z(), std::numbers::pi / 2, 1e-15);
  EXPECT_EQ(std::get<SphereShape>(*c.volumes[2].shape).radius, 0.5);
  EXPECT_EQ(std::get<TorusShape>(*c.volumes[5].shape).axis, Vec3::UnitY());

  const auto& tube = std::get<TubeShape>(*c.volumes[6].shape);
  EXPECT_EQ(tube.path[3], Vec3(9, 4, -4));
  EXPECT_EQ(tube.bend_radius, (std::vector<double>{3, 1.5}));
  EXPECT_EQ(tube.wall_thickness, 0.03);

  // Distance from the point to the surface of each volume, in contact.
  const auto volumes = run::load_volumes(c);
  const auto surfaces = run::surfaces(volumes);
  const auto distance = [&](size_t i, const Vec3& y) { return surfaces[i]->query(y, 1e9)->distance; };
  EXPECT_NEAR(distance(0, {5, 5, -50}), 10, 1e-14);
  EXPECT_NEAR(distance(1, {2.5, 2, 3}), 0.5, 1e-14);  // rotated: 2 m along x, 0.4 m along y
  EXPECT_NEAR(distance(1, {1, 3, 3}), 0.8, 1e-14);
  EXPECT_NEAR(distance(2, {0, 0, 3}), 1.5, 1e-14);
  EXPECT_NEAR(distance(3, {0.3, 0.5, 0.4}), 0.25, 1e-14);
  EXPECT_NEAR(distance(4, {7, 4, 0}), 4.5, 1e-14);
  EXPECT_NEAR(distance(5, {0, 0, 1}), 3, 1e-14);
  EXPECT_NEAR(distance(6, {0.1, 0, 0}), 0.15, 1e-14);

  const std::string text = model::summary(c);
  for (const char* line :
       {"p: plane through (0, 0, -60) facing (0, 0, 1), fixed in space",
        "b: box of 0.4 x 2 x 6 m about (1, 2, 3), turned, on barge",
        "s: sphere of radius 0.5 m about (0, 0, 1)",
        "y: cylinder of radius 0.25 m from (0, -1, 0) to (0, 1, 0), fixed in space, "
        "stiffness automatic, friction 0.3",
        "c: capsule of radius 0.5 m from (0, 0, 0) to (4, 0, 0)",
        "t: torus of radius 4 m, tube 1 m, about (0, 0, 1) with axis (0, 1, 0)",
        "j: tube of inner radius 0.25 m, wall 0.03 m, with 2 bends, from (0, 0, 8) to (9, 4, -4)",
        "i: tube of inner radius 0.25 m, wall 0.03 m, straight, from (0, 0, 8) to (0, 0, -4)"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
}

TEST(CaseShapes, TrianglesForPictures) {
  const model::Case c = read(
      "  y: {body: barge, shape: {cylinder: {from: [0, -1, 0], to: [0, 1, 0], radius: 0.25}}}\n"
      "  p: {body: barge, shape: {plane: {point: [0, 0, -70], normal: [0, 0, 1]}}}\n"
      "  m: {mesh: box.obj}\n");
  const auto volumes = run::load_volumes(c);
  const auto meshes = run::volume_meshes(c, volumes);
  ASSERT_EQ(meshes.size(), 3U);
  EXPECT_EQ(meshes[0].body, 0);
  EXPECT_EQ(meshes[0].triangles.size(), meshes[0].active.size());
  EXPECT_NEAR(inspect(volumes[0].facets->copy()).volume, std::numbers::pi * 0.25 * 0.25 * 2, 2e-3);
  for (const Vec3& v : meshes[0].vertices) EXPECT_NEAR(volumes[0].surface->query(v, 1)->distance, 0, 1e-15);
  // The patch of the plane covers the reach of the line: half its length about the middle of its ends. The
  // barge is rotated by 90 degrees and 10 m up, so that the middle is at (0, -30, -40) in its frame.
  Box patch;
  for (const Vec3& v : meshes[1].vertices) patch.add(v);
  EXPECT_NEAR(patch.lo.z(), -70, 1e-13);
  EXPECT_NEAR(patch.hi.z(), -70, 1e-13);
  EXPECT_NEAR(patch.centre().x(), 0, 1e-12);
  EXPECT_NEAR(patch.centre().y(), -30, 1e-12);
  EXPECT_LE(patch.lo.y(), -80);
  EXPECT_GE(patch.hi.y(), 20);
  EXPECT_LE(patch.diagonal(), 300);
  // A mesh is displayed unchanged.
  EXPECT_EQ(meshes[2].triangles.size(), 12U);
}

}  // namespace
}  // namespace hawser::case_shapes_test
