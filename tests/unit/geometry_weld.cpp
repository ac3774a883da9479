// Cracks along open edges from noise and rounding of a file are welded, and holes do not affect the smooth
// surface elsewhere.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "hawser/advice/meshes.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/mesh_weld.hpp"
#include "hawser/io/mesh_reader.hpp"
#include "support/shapes.hpp"

namespace hawser::geometry_weld_test {
namespace {

using namespace hawser::test;

constexpr double kNoise = 1e-4;  // m
constexpr MeshSurfaceOptions kSmooth{true, 40 * M_PI / 180, false};

// Triangles with separate corners, as in an STL file; two per cent of the triangles have corners moved by up
// to 0.1 mm.
TriangleMesh noisy(const TriangleMesh& clean) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> each(-kNoise, kNoise);
  TriangleMesh out;
  for (std::size_t t = 0; t < clean.triangles.size(); ++t) {
    const bool moved = t % 50 == 11;
    for (const int v : clean.triangles[t]) {
      Vec3 x = clean.vertices[static_cast<std::size_t>(v)];
      if (moved) x += Vec3(each(random), each(random), each(random));
      out.vertices.push_back(x);
    }
    const int n = static_cast<int>(3 * t);
    out.triangles.push_back({n, n + 1, n + 2});
  }
  return out;
}

// A box of 4 x 3 x 2 units, its sides divided into squares.
TriangleMesh divided_box(double unit) {
  TriangleMesh out;
  const Vec3 size = unit * Vec3(4, 3, 2);
  constexpr int n = 10;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int a, int b) {
            Vec3 x;
            x[axis] = far ? size[axis] : 0;
            x[(axis + 1) % 3] = a * size[(axis + 1) % 3] / n;
            x[(axis + 2) % 3] = b * size[(axis + 2) % 3] / n;
            return x;
          };
          const int first = static_cast<int>(out.vertices.size());
          for (const Vec3& x : {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)})
            out.vertices.push_back(x);
          const int b = far ? 1 : 2;
          const int c = far ? 2 : 1;
          out.triangles.push_back({first, first + b, first + c});
          out.triangles.push_back({first, first + (far ? 2 : 3), first + (far ? 3 : 2)});
        }
  weld(out, 1e-9);
  return out;
}

// Wigley's hull of 100 x 10 x 6.25 m with a deck: half breadth B/2 (1 - (2x/L)²)(1 - (z/T)²).
TriangleMesh wigley_hull() {
  constexpr int n = 40, m = 10;
  const auto at = [](int i, int j, int side) {
    const double x = -50.0 + 100.0 * i / n;
    const double z = -6.25 * j / m;
    return Vec3(x, side * 5 * (1 - std::pow(x / 50, 2)) * (1 - std::pow(z / 6.25, 2)), z);
  };
  TriangleMesh out;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c, bool turned) {
    const int first = static_cast<int>(out.vertices.size());
    for (const Vec3& x : {a, turned ? c : b, turned ? b : c}) out.vertices.push_back(x);
    out.triangles.push_back({first, first + 1, first + 2});
  };
  for (int i = 0; i < n; ++i) {
    for (const int side : {-1, 1})
      for (int j = 0; j < m; ++j) {
        add(at(i, j, side), at(i, j + 1, side), at(i + 1, j + 1, side), side > 0);
        add(at(i, j, side), at(i + 1, j + 1, side), at(i + 1, j, side), side > 0);
      }
    add(at(i, 0, -1), at(i + 1, 0, -1), at(i + 1, 0, 1), false);
    add(at(i, 0, -1), at(i + 1, 0, 1), at(i, 0, 1), false);
  }
  weld(out, 1e-9);
  return out;
}

void expect_clean_again(const TriangleMesh& clean, double size) {
  ASSERT_TRUE(inspect(clean).valid()) << advice::mesh_summary(inspect(clean));
  TriangleMesh mesh = noisy(clean);
  weld(mesh, 1e-6);
  EXPECT_GT(topology(mesh).components, 5);
  const CrackResult r = weld_cracks(mesh);
  EXPECT_GT(r.welded, 10);
  EXPECT_GT(r.widest, 0.5 * kNoise);
  EXPECT_LT(r.widest, 4 * kNoise);
  EXPECT_EQ(r.open_edges, 0);
  EXPECT_EQ(r.removed, 0);
  const MeshReport report = inspect(mesh);
  EXPECT_TRUE(report.valid()) << advice::mesh_summary(report);
  EXPECT_EQ(report.components, 1);
  EXPECT_EQ(report.vertices, inspect(clean).vertices);
  const MeshSurface surface(mesh, {}, kSmooth);
  const MeshSurface reference(clean, {}, kSmooth);
  EXPECT_NEAR(surface.curved(), reference.curved(), 0.02 * reference.curved());
  std::mt19937 random(3);
  std::uniform_real_distribution<double> each(-size, size);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 y(each(random), each(random), each(random));
    ASSERT_NEAR(surface.query(y, 1e9)->distance, reference.query(y, 1e9)->distance, kNoise) << y.transpose();
  }
}

TEST(GeometryWeld, NoiseOnABox) { expect_clean_again(divided_box(1), 5); }
TEST(GeometryWeld, NoiseOnABoxOfHalfAMetre) { expect_clean_again(divided_box(0.125), 0.6); }
TEST(GeometryWeld, NoiseOnADrum) { expect_clean_again(drum_mesh(48, 1, 3, 6), 3); }
TEST(GeometryWeld, NoiseOnAHull) { expect_clean_again(wigley_hull(), 60); }

// Two bodies at a distance of 1 mm remain separate.
TEST(GeometryWeld, ClosedMeshesStay) {
  TriangleMesh mesh = box_mesh(Vec3::Zero(), Vec3::Ones());
  append(mesh, box_mesh(Vec3(0, 0, 1.001), Vec3(1, 1, 2)));
  const TriangleMesh before = mesh;
  const CrackResult r = weld_cracks(mesh);
  EXPECT_EQ(r.welded, 0);
  EXPECT_EQ(mesh.vertices, before.vertices);
  EXPECT_EQ(mesh.triangles, before.triangles);
}

// A slit of 2 cm along an open edge of 1 m is no rounding error of the file; one of 2 mm is.
TEST(GeometryWeld, SlitsStayAndCracksGo) {
  const auto lid_raised = [](double by) {
    TriangleMesh mesh = box_mesh(Vec3::Zero(), Vec3::Ones());
    TriangleMesh out;
    for (const auto& t : mesh.triangles) {
      bool lid = true;
      for (const int v : t) lid = lid && mesh.vertices[static_cast<std::size_t>(v)].z() > 0.5;
      const int first = static_cast<int>(out.vertices.size());
      for (const int v : t)
        out.vertices.push_back(mesh.vertices[static_cast<std::size_t>(v)] + Vec3(0, 0, lid ? by : 0));
      out.triangles.push_back({first, first + 1, first + 2});
    }
    weld(out);
    return out;
  };
  TriangleMesh slit = lid_raised(0.02);
  TriangleMesh crack = lid_raised(0.002);
  EXPECT_EQ(weld_cracks(slit).welded, 0);
  EXPECT_EQ(topology(slit).open_edges, 8);
  EXPECT_EQ(weld_cracks(crack).welded, 4);
  EXPECT_TRUE(inspect(crack).valid());
}

// A drum without its lid is as round as a closed one up to the rim; between flat and curved facets the sign
// is that of the curved ones.
TEST(GeometryWeld, AHoleCostsNothingElsewhere) {
  const TriangleMesh closed = drum_mesh(24, 1, 3, 6);
  TriangleMesh open = closed;
  open.keep_triangles([&](std::array<int, 3>& t, std::size_t) {
    for (const int v : t)
      if (closed.vertices[static_cast<std::size_t>(v)].z() < 1.5 - 1e-9) return true;
    return false;
  });
  weld(open);
  EXPECT_EQ(topology(open).open_edges, 24);
  const MeshSurface whole(closed, {}, kSmooth);
  const MeshSurface lidless(open, {}, {true, 40 * M_PI / 180, true});
  EXPECT_GT(lidless.curved(), 24 * 2 * 6 - 1);  // all facets of its side are curved
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(0, 2 * M_PI), height(-1.4, 0.9), off(-0.2, 0.2);
  for (int i = 0; i < 3000; ++i) {
    const double a = angle(random);
    const double d = i % 3 ? off(random) : 0.02 * off(random);
    const Vec3 y((1 + d) * std::cos(a), (1 + d) * std::sin(a), height(random));
    const auto p = lidless.query(y, 1e9);
    ASSERT_NEAR(p->distance, whole.query(y, 1e9)->distance, 1e-12) << y.transpose();
    if (y.z() > -1.2) {  // the bottom is farther away
      ASSERT_NEAR(p->distance, d, 1e-4);
    }
  }
}

// Message about the repair, for a typical file.
TEST(GeometryWeld, TheRepairIsReported) {
  const TriangleMesh mesh = noisy(drum_mesh(48, 1, 3, 6));
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "hawser_noisy_drum.stl";
  {
    std::ofstream file(path);
    file.precision(7);
    file << "solid drum\n";
    for (const auto& t : mesh.triangles) {
      file << "facet normal 0 0 0\nouter loop\n";
      for (const int v : t) {
        const Vec3& x = mesh.vertices[static_cast<std::size_t>(v)];
        file << "vertex " << x.x() << " " << x.y() << " " << x.z() << "\n";
      }
      file << "endloop\nendfacet\n";
    }
    file << "endsolid drum\n";
  }
  const io::LoadedMesh loaded = io::read_mesh(path.string(), 1, true);
  EXPECT_TRUE(loaded.report.valid());
  EXPECT_EQ(loaded.report.components, 1);
  ASSERT_EQ(loaded.notes.size(), 1U);
  EXPECT_NE(loaded.notes[0].find("hawser_noisy_drum.stl: "), std::string::npos);
  EXPECT_NE(loaded.notes[0].find(" corners of open edges that lay up to 0.000"), std::string::npos)
      << loaded.notes[0];
  EXPECT_NE(loaded.notes[0].find(" m apart were merged; all edges are now closed"), std::string::npos)
      << loaded.notes[0];
}

}  // namespace
}  // namespace hawser::geometry_weld_test
