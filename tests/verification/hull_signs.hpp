// Compares the classification of points as inside or outside real hulls with the winding number of all
// triangles.
#pragma once

#include <gtest/gtest.h>

#include <chrono>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/io/mesh_reader.hpp"
#include "support/hulls.hpp"

namespace hawser::test {

struct Signs {
  long points = 0, inside = 0, wrong = 0, near = 0;  // near: between facets and patches, not compared
  double microseconds = 0;                           // a query
};

// A hundred points on each of some lines through the box or through the surface; half of the latter points
// are near the surface.
inline Signs compare_signs(const TriangleMesh& mesh, const MeshSurface& surface, int lines) {
  const auto boundary = boundary_of(mesh);
  std::mt19937 gen(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const Box box = surface.bounds();
  const double size = box.diagonal();
  Signs out;
  for (int l = 0; l < lines; ++l) {
    Vec3 p, d;
    for (int a = 0; a < 3; ++a) {
      d[a] = unit(gen) - 0.5;
      p[a] = box.lo[a] + unit(gen) * (box.hi[a] - box.lo[a]);
    }
    d.normalize();
    if (l % 2) {
      const auto& t = mesh.triangles[gen() % mesh.triangles.size()];
      const double a = unit(gen);
      const double b = unit(gen) * (1 - a);
      const auto v = [&](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(t[i])]; };
      p = v(0) + a * (v(1) - v(0)) + b * (v(2) - v(0));
    }
    const WindingAlong line(mesh, p, d);
    for (int k = 0; k < 100; ++k) {
      const double there = l % 2 == 0 || k % 2
                               ? size * (unit(gen) - 0.5) * (k % 3 ? 0.2 : 1)
                               : size * std::pow(10, -1 - 5 * unit(gen)) * (unit(gen) < 0.5 ? -1 : 1);
      const double w = line.at(there, mesh, boundary);
      const auto start = std::chrono::steady_clock::now();
      const auto s = surface.query(p + there * d, std::numeric_limits<double>::infinity());
      out.microseconds +=
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() * 1e6;
      ++out.points;
      if (std::abs(s->distance) <= surface.bulge() + 1e-12 * size || std::abs(w - 0.5) < 1e-9) {
        ++out.near;
        continue;
      }
      out.inside += w > 0.5;
      out.wrong += (w > 0.5) != (s->distance < 0);
    }
  }
  out.microseconds /= static_cast<double>(out.points);
  return out;
}

inline void expect_signs(const std::string& name, double scale, bool smooth, int lines) {
  const std::string path = unpacked_hull(name, ::testing::TempDir() + "hawser_hulls");
  if (path.empty()) GTEST_SKIP() << "the hull meshes are not beside the sources";
  const io::LoadedMesh hull = io::read_mesh(path, scale);
  const MeshSurface surface(hull.mesh, {}, {smooth, 40 * M_PI / 180, hull.open});
  const Signs s = compare_signs(hull.mesh, surface, lines);
  std::printf("%s, %s facets: %ld points, %ld inside, %ld wrong; %.2f us a query\n", name.c_str(),
              smooth ? "curved" : "flat", s.points, s.inside, s.wrong, s.microseconds);
  for (const auto& n : hull.notes) std::printf("  %s\n", n.c_str());
  EXPECT_EQ(s.wrong, 0);
  EXPECT_GT(s.inside, s.points / 10);
}

}  // namespace hawser::test
