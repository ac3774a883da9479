// Vertex clustering: cells of a regular grid, and the position of the vertex of each cell.
#include "hawser/geometry/coarse_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "hawser/math/symmetric.hpp"

namespace hawser {
namespace {

// Number of the cell of each vertex, in the order in which cells occur.
std::vector<int> cells_of(std::span<const Vec3> vertices, double edge) {
  std::map<std::array<double, 3>, int> cells;
  std::vector<int> out;
  for (const Vec3& x : vertices) {
    const std::array<double, 3> cell{std::floor(x.x() / edge), std::floor(x.y() / edge),
                                     std::floor(x.z() / edge)};
    out.push_back(cells.try_emplace(cell, static_cast<int>(cells.size())).first->second);
  }
  return out;
}

// Quadric of the triangles with a corner in a cell: the sum of the squared distances of the vertex from their
// planes, weighted with their squared areas, as x·planes x - 2 x·offset.
struct Cell {
  Mat3 planes = Mat3::Zero();
  Vec3 offset = Vec3::Zero(), sum = Vec3::Zero();
  int members = 0;

  // Minimum of the quadric; in directions with almost no information, along a plane or along the edge of two,
  // the mean of the vertices.
  Vec3 vertex(double edge) const {
    constexpr double kAgreed = 1e-2;
    const Vec3 mean = sum / members;
    const Vec3 off = offset - planes * mean;
    const Eigenpairs along = eigenpairs(planes);
    Vec3 move = Vec3::Zero();
    for (int i = 0; i < 3; ++i)
      if (along.values[i] > kAgreed * along.values[2]) {
        const Vec3 axis = along.vectors.col(i);
        move += axis.dot(off) / along.values[i] * axis;
      }
    return move.norm() < edge ? Vec3(mean + move) : mean;
  }
};

}  // namespace

CoarseMesh coarse_mesh(std::span<const Vec3> vertices, std::span<const std::array<int, 3>> triangles,
                       int max_vertices) {
  // Start with a grid in which `max_vertices` cells would cover the surface, and coarsen.
  double area = 0, extent = 0;
  for (const auto& [a, b, c] : triangles)
    area += 0.5 * (vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]).norm();
  for (const Vec3& x : vertices) extent = std::max(extent, (x - vertices[0]).norm());
  double edge = std::max({std::sqrt(area / max_vertices), extent / max_vertices, 1e-9});
  std::vector<int> cell = cells_of(vertices, edge);
  int count = 0;
  while ((count = 1 + *std::max_element(cell.begin(), cell.end())) > max_vertices)
    cell = cells_of(vertices, edge *= 1.15);

  CoarseMesh out;
  std::vector<Cell> at(static_cast<size_t>(count));
  for (size_t i = 0; i < cell.size(); ++i) {
    at[cell[i]].sum += vertices[i];
    ++at[cell[i]].members;
  }
  for (const auto& t : triangles) {
    const Vec3& x = vertices[t[0]];
    const Vec3 area_normal = (vertices[t[1]] - x).cross(vertices[t[2]] - x);
    for (const int corner : t) {
      at[cell[corner]].planes += area_normal * area_normal.transpose();
      at[cell[corner]].offset += area_normal * area_normal.dot(x);
    }
  }
  for (const Cell& c : at) out.vertices.push_back(c.vertex(edge));
  for (size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    if (cell[a] == cell[b] || cell[b] == cell[c] || cell[c] == cell[a]) continue;
    out.triangles.push_back({cell[a], cell[b], cell[c]});
    out.from.push_back(static_cast<int>(t));
  }
  return out;
}

}  // namespace hawser
