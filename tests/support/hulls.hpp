// Hulls of ../shared/data beside the sources, and the winding number of a mesh by a method independent of the
// product's.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"
#include "hawser/math/ordered.hpp"
#include "support/gzip.hpp"

namespace hawser::test {

// Path of the hull file after unpacking it into `folder`; empty if the data are absent.
inline std::string unpacked_hull(const std::string& name, const std::string& folder) {
  namespace fs = std::filesystem;
  const fs::path packed = fs::path(HAWSER_SOURCE_DIR) / "../shared/data/hulls" / (name + ".gz");
  if (!fs::exists(packed)) return "";
  fs::create_directories(folder);
  const std::string path = (fs::path(folder) / name).string();
  std::ofstream(path, std::ios::binary) << read_gzip(packed.string());
  return path;
}

// Winding numbers at points of the line from p along the unit vector d, summed over all triangles: the number
// of facets through which the rest of the line leaves the body, less those through which it enters, plus the
// solid angle of the surface that closes the mesh, which the boundary of the mesh sweeps in direction -d.
class WindingAlong {
 public:
  WindingAlong(const MeshView& mesh, const Vec3& p, const Vec3& d) : p_(p), d_(d) {
    for (const auto& t : mesh.triangles) {
      const auto v = [&](std::size_t i) { return Vec3(mesh.vertices[static_cast<std::size_t>(t[i])] - p); };
      const Vec3 a = v(0);
      const Vec3 b = v(1);
      const Vec3 c = v(2);
      const double x = d.dot(a.cross(b));
      const double y = d.dot(b.cross(c));
      const double z = d.dot(c.cross(a));
      if (!((x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0))) continue;
      met_.emplace_back((y * a + z * b + x * c).dot(d) / (x + y + z), x > 0 ? 1 : -1);
    }
  }
  // `boundary`: edges (from, to, excess) of boundary_of.
  double at(double along, const MeshView& mesh, const std::vector<std::array<int, 3>>& boundary) const {
    const Vec3 y = p_ + along * d_;
    double w = 0, angle = 0;
    for (const auto& [place, way] : met_) w += place > along ? way : 0;
    for (const auto& [from, to, excess] : boundary) {
      const Vec3 a = mesh.vertices[static_cast<std::size_t>(from)] - y;
      const Vec3 b = mesh.vertices[static_cast<std::size_t>(to)] - y;
      const double la = a.norm();
      const double lb = b.norm();
      angle -=
          2 * excess * std::atan2(a.cross(b).dot(d_), la * lb + a.dot(b) - b.dot(d_) * la - a.dot(d_) * lb);
    }
    return w + angle / (4 * M_PI);
  }

 private:
  Vec3 p_, d_;
  std::vector<std::pair<double, int>> met_;
};

inline std::vector<std::array<int, 3>> boundary_of(const MeshView& mesh) {
  std::map<std::pair<int, int>, int> excess;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = t[i];
      const int b = t[(i + 1) % 3];
      excess[ordered(a, b)] += a < b ? 1 : -1;
    }
  std::vector<std::array<int, 3>> out;
  for (const auto& [edge, n] : excess)
    if (n != 0) out.push_back({edge.first, edge.second, n});
  return out;
}

}  // namespace hawser::test
