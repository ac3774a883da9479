// Welding of meshes, the report of their faults, and the repair of their orientation.
#include <gtest/gtest.h>

#include <random>

#include "hawser/advice/meshes.hpp"
#include "hawser/geometry/mesh_repair.hpp"
#include "hawser/geometry/triangle_mesh.hpp"
#include "support/shapes.hpp"

namespace hawser::geometry_mesh_test {
namespace {

using namespace hawser::test;

// Triangles with separate corners, as in an STL file.
TriangleMesh soup(const TriangleMesh& m) {
  TriangleMesh s;
  for (const auto& t : m.triangles) {
    const int base = static_cast<int>(s.vertices.size());
    for (const int v : t) s.vertices.push_back(m.vertices[static_cast<std::size_t>(v)]);
    s.triangles.push_back({base, base + 1, base + 2});
  }
  return s;
}

TEST(GeometryMesh, ShapesAreClosedAndOutwardWithTheirVolume) {
  const double drum = 0.5 * 96 * std::sin(2 * M_PI / 96) * 3.6 * 3.6 * 5.5;
  const std::vector<std::pair<TriangleMesh, double>> shapes = {{box_mesh({-1, 0, 1}, {1, 3, 2}), 6},
                                                               {tetrahedron_mesh(), 1.0 / 6},
                                                               {l_prism_mesh(), 3},
                                                               {u_channel_mesh(), 20},
                                                               {hollow_cube_mesh(), 26},
                                                               {drum_mesh(96, 3.6, 5.5), drum}};
  for (const auto& [mesh, volume] : shapes) {
    const MeshReport r = inspect(mesh);
    EXPECT_TRUE(r.valid()) << advice::mesh_summary(r);
    EXPECT_NEAR(r.volume, volume, 1e-12 * volume);
    EXPECT_EQ(r.degenerate, 0);
  }
  const MeshReport hollow = inspect(hollow_cube_mesh());
  EXPECT_EQ(hollow.components, 2);
  EXPECT_NEAR(hollow.area, 60, 1e-12);
  EXPECT_DOUBLE_EQ(hollow.shortest_edge, 1);
  EXPECT_DOUBLE_EQ(hollow.longest_edge, std::sqrt(18.0));
  EXPECT_EQ(hollow.box.hi, Vec3::Constant(3));
  EXPECT_TRUE(inspect(sphere_mesh(3)).valid());
  EXPECT_TRUE(inspect(flanged_drum_mesh(24, 1, 2, 1.5, 0.2)).valid());
}

TEST(GeometryMesh, WeldJoinsASoup) {
  TriangleMesh m = soup(sphere_mesh(2));
  EXPECT_EQ(inspect(m).open_edges, 3 * 128);
  EXPECT_FALSE(inspect(m).closed);
  const WeldResult w = weld(m);
  EXPECT_EQ(m.vertices.size(), 66u);  // Euler: V = 2 + T/2
  EXPECT_EQ(w.welded, 3 * 128 - 66);
  EXPECT_EQ(w.removed, 0);
  EXPECT_TRUE(inspect(m).valid());
}

TEST(GeometryMesh, WeldWithToleranceJoinsAcrossCellsAndDropsSlivers) {
  std::mt19937 gen(1);
  std::uniform_real_distribution<double> u(-1, 1);
  TriangleMesh m = soup(sphere_mesh(3));
  m.part.assign(m.triangles.size(), 0);
  m.part[0] = 7;
  for (Vec3& v : m.vertices) v += 1e-7 * Vec3(u(gen), u(gen), u(gen));
  TriangleMesh exact = m;
  EXPECT_EQ(weld(exact).welded, 0);
  weld(m, 1e-6);
  EXPECT_EQ(m.vertices.size(), 258u);
  EXPECT_TRUE(inspect(m).valid());
  EXPECT_EQ(m.part[0], 7);
  EXPECT_EQ(m.part.size(), m.triangles.size());
  const WeldResult w = weld(m, 0.3);
  EXPECT_GT(w.removed, 0);
  // -0 and 0 are equal coordinates.
  TriangleMesh z{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}}, {{0, 1, 2}, {3, 1, 2}}, {}, {}};
  EXPECT_EQ(weld(z).welded, 1);
}

TEST(GeometryMesh, ReportNamesFaults) {
  TriangleMesh m = box_mesh(Vec3::Zero(), Vec3::Ones());
  m.triangles.pop_back();
  MeshReport r = inspect(m);
  EXPECT_FALSE(r.closed);
  EXPECT_EQ(r.open_edges, 3);
  EXPECT_NE(advice::mesh_summary(r).find("3 edges have a triangle on one side only"), std::string::npos)
      << advice::mesh_summary(r);

  m = box_mesh(Vec3::Zero(), Vec3::Ones());
  std::swap(m.triangles[5][0], m.triangles[5][1]);
  r = inspect(m);
  EXPECT_TRUE(r.closed);
  EXPECT_EQ(r.flipped_edges, 3);
  EXPECT_FALSE(r.valid());

  m = box_mesh(Vec3::Zero(), Vec3::Ones());
  for (auto& t : m.triangles) std::swap(t[0], t[1]);
  r = inspect(m);
  EXPECT_TRUE(r.consistently_oriented);
  EXPECT_FALSE(r.outward);
  EXPECT_NE(advice::mesh_summary(r).find("normals point into the solid"), std::string::npos);

  // A fin on an edge.
  m = box_mesh(Vec3::Zero(), Vec3::Ones());
  m.vertices.push_back({2, 2, 2});
  m.triangles.push_back({0, 1, 8});
  r = inspect(m);
  EXPECT_EQ(r.non_manifold_edges, 1);
  EXPECT_EQ(r.open_edges, 2);

  // A corner in the middle of an edge: a triangle of zero area closes the gap.
  m = tetrahedron_mesh();
  m.vertices.push_back({0.5, 0, 0});
  m.triangles = {{0, 2, 4}, {4, 2, 1}, {0, 1, 3}, {0, 4, 1}, {0, 3, 2}, {1, 2, 3}};
  r = inspect(m);
  EXPECT_TRUE(r.valid()) << advice::mesh_summary(r);
  EXPECT_EQ(r.degenerate, 1);
  EXPECT_NE(advice::mesh_summary(r).find("Note: 1 triangle has no area"), std::string::npos)
      << advice::mesh_summary(r);

  EXPECT_NE(advice::mesh_summary(inspect({})).find("empty"), std::string::npos);
}

TEST(GeometryMesh, OrientationRepair) {
  std::mt19937 gen(5);
  for (const TriangleMesh& valid :
       {hollow_cube_mesh(), u_channel_mesh(), sphere_mesh(3), flanged_drum_mesh(24, 1, 2, 1.5, 0.2)}) {
    TriangleMesh m = valid;
    int turned = 0;
    for (auto& t : m.triangles)
      if (gen() % 2) {
        std::swap(t[1], t[2]);
        ++turned;
      }
    EXPECT_FALSE(inspect(m).valid());
    EXPECT_EQ(repair(m).turned, turned);
    EXPECT_TRUE(inspect(m).valid());
    EXPECT_EQ(m.triangles, valid.triangles);
    EXPECT_EQ(repair(m).turned, 0);
  }
  // Inside out, including the cavity.
  TriangleMesh m = hollow_cube_mesh();
  for (auto& t : m.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(repair(m).turned, static_cast<int>(m.triangles.size()));
  EXPECT_TRUE(inspect(m).valid());
  // A body in the cavity of a body is at nesting depth 2, so it is oriented outward.
  m = hollow_cube_mesh();
  append(m, box_mesh(Vec3::Constant(1.4), Vec3::Constant(1.6)), true);
  EXPECT_FALSE(inspect(m).valid());
  EXPECT_EQ(repair(m).turned, 12);
  EXPECT_TRUE(inspect(m).valid());
}

TEST(GeometryMesh, OneSidedSurfacesAreLeftAsFound) {
  // The real projective plane on six vertices: closed, manifold, one-sided.
  TriangleMesh rp2;
  for (int i = 0; i < 6; ++i) rp2.vertices.push_back(Vec3(std::cos(i), std::sin(2 * i), i));
  rp2.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                   {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  EXPECT_EQ(topology(rp2).open_edges, 0);
  EXPECT_EQ(topology(rp2).non_manifold_edges, 0);
  const auto before = rp2.triangles;
  const RepairResult r = repair(rp2);
  EXPECT_EQ(r.one_sided, 1);
  EXPECT_EQ(rp2.triangles, before);
  EXPECT_NE(advice::repaired(r).find("one-sided"), std::string::npos);
}

}  // namespace

}  // namespace hawser::geometry_mesh_test
