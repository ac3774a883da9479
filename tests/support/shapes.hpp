// Closed, outward oriented meshes for tests, whose properties are known in closed form. Lengths in m.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::test {

inline void append(TriangleMesh& to, const TriangleMesh& from, bool inside_out = false) {
  const int base = static_cast<int>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
  for (auto t : from.triangles) {
    for (int& v : t) v += base;
    if (inside_out) std::swap(t[1], t[2]);
    to.triangles.push_back(t);
  }
}

inline TriangleMesh box_mesh(const Vec3& lo, const Vec3& hi) {
  TriangleMesh m;
  for (int i = 0; i < 8; ++i)
    m.vertices.push_back({i & 1 ? hi.x() : lo.x(), i & 2 ? hi.y() : lo.y(), i & 4 ? hi.z() : lo.z()});
  m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return m;
}

inline TriangleMesh tetrahedron_mesh() {
  TriangleMesh m;
  m.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  m.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return m;
}

// Prism over a polygon in the xy plane (anticlockwise), from z = 0 to z = height. The polygon is given as
// convex pieces, which are lists of its corners.
inline TriangleMesh prism_mesh(const std::vector<std::pair<double, double>>& polygon,
                               const std::vector<std::vector<int>>& pieces, double height) {
  TriangleMesh m;
  const int n = static_cast<int>(polygon.size());
  for (const double z : {0.0, height})
    for (const auto& [x, y] : polygon) m.vertices.push_back({x, y, z});
  for (const auto& piece : pieces)
    for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
      m.triangles.push_back({piece[0], piece[i + 1], piece[i]});
      m.triangles.push_back({n + piece[0], n + piece[i], n + piece[i + 1]});
    }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    m.triangles.push_back({i, j, n + j});
    m.triangles.push_back({i, n + j, n + i});
  }
  return m;
}

// L-shaped prism: [0,2]x[0,1] and [0,1]x[0,2], z in [0, 1].
inline TriangleMesh l_prism_mesh() {
  return prism_mesh({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}},
                    {{0, 1, 4, 7}, {1, 2, 3, 4}, {7, 4, 5, 6}}, 1);
}

// A box for a roller: [0,3]x[0,2] without (1,2)x(1,2), z in [0, 4].
inline TriangleMesh u_channel_mesh() {
  return prism_mesh(
      {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}},
      {{0, 1, 8, 11}, {1, 2, 7, 8}, {2, 3, 4, 7}, {11, 8, 9, 10}, {7, 4, 5, 6}}, 4);
}

// The cube [0,3]^3 without its inner part (1,2)^3.
inline TriangleMesh hollow_cube_mesh() {
  TriangleMesh m = box_mesh(Vec3::Zero(), Vec3::Constant(3));
  append(m, box_mesh(Vec3::Constant(1), Vec3::Constant(2)), true);
  return m;
}

// A surface of revolution about the z axis. The profile (radius, z) runs upwards on the outside and starts
// and ends on the axis (radius 0). `facets` facets around, corners at angles 2 pi k / facets.
inline TriangleMesh revolution_mesh(const std::vector<std::pair<double, double>>& profile, int facets) {
  TriangleMesh m;
  const auto at = [&](std::size_t ring, int k) {
    if (profile[ring].first == 0) return ring == 0 ? 0 : 1;
    return 2 + static_cast<int>(ring - 1) * facets + k % facets;
  };
  m.vertices = {{0, 0, profile.front().second}, {0, 0, profile.back().second}};
  for (std::size_t r = 1; r + 1 < profile.size(); ++r)
    for (int k = 0; k < facets; ++k) {
      const double angle = 2 * M_PI * k / facets;
      m.vertices.push_back(
          {profile[r].first * std::cos(angle), profile[r].first * std::sin(angle), profile[r].second});
    }
  for (std::size_t r = 0; r + 1 < profile.size(); ++r)
    for (int k = 0; k < facets; ++k) {
      const int a = at(r, k);
      const int b = at(r, k + 1);
      const int c = at(r + 1, k + 1);
      const int d = at(r + 1, k);
      if (a != b) m.triangles.push_back({a, b, c});
      if (c != d) m.triangles.push_back({a, c, d});
    }
  return m;
}

// A closed cylinder about the z axis, z in [-length/2, length/2], with flat facets inscribed in `radius` and
// divided into `rings` rows.
inline TriangleMesh drum_mesh(int facets, double radius, double length, int rings = 1) {
  std::vector<std::pair<double, double>> profile = {{0, -length / 2}};
  for (int i = 0; i <= rings; ++i)
    profile.emplace_back(radius, length * (static_cast<double>(i) / rings - 0.5));
  profile.emplace_back(0, length / 2);
  return revolution_mesh(profile, facets);
}

// The same cylinder between two flanges; parts "flange" and "barrel".
inline TriangleMesh flanged_drum_mesh(int facets, double radius, double length, double flange_radius,
                                      double flange_thickness) {
  const double h = length / 2;
  const double o = h + flange_thickness;
  TriangleMesh m = revolution_mesh({{0, -o},
                                    {flange_radius, -o},
                                    {flange_radius, -h},
                                    {radius, -h},
                                    {radius, h},
                                    {flange_radius, h},
                                    {flange_radius, o},
                                    {0, o}},
                                   facets);
  m.parts = {"flange", "barrel"};
  for (const auto& t : m.triangles) {
    bool barrel = true;
    for (const int v : t) {
      const Vec3& x = m.vertices[static_cast<std::size_t>(v)];
      barrel = barrel && std::abs(std::hypot(x.x(), x.y()) - radius) < 1e-9 * radius &&
               std::abs(x.z()) < h * (1 + 1e-9);
    }
    m.part.push_back(barrel);
  }
  return m;
}

// A sphere about the origin, made from the octahedron by halving each edge `levels` times: 8 * 4^levels
// triangles.
inline TriangleMesh sphere_mesh(int levels, double radius = 1) {
  TriangleMesh m;
  m.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  m.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int l = 0; l < levels; ++l) {
    std::map<std::pair<int, int>, int> half;
    const auto middle = [&](int a, int b) {
      const auto [it, made] =
          half.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(m.vertices.size()));
      if (made)
        m.vertices.push_back(
            (m.vertices[static_cast<std::size_t>(a)] + m.vertices[static_cast<std::size_t>(b)]).normalized());
      return it->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& t : m.triangles) {
      const int ab = middle(t[0], t[1]);
      const int bc = middle(t[1], t[2]);
      const int ca = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
    }
    m.triangles = std::move(finer);
  }
  for (Vec3& v : m.vertices) v *= radius;
  return m;
}

}  // namespace hawser::test
