// A coarser mesh of a surface, for pictures.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct CoarseMesh {
  std::vector<Vec3> vertices;                 // m
  std::vector<std::array<int, 3>> triangles;  // corners, from 0
  std::vector<int> from;                      // triangle of the fine mesh for each of them
};

// Vertex clustering (Rossignac and Borrel 1993): the vertices in each cell of a regular grid are merged at
// the point nearest to the planes of their triangles (Lindstrom 2000), and triangles with corners in three
// cells remain. Uses the finest grid, within 15 %, with at most `max_vertices` (> 0) vertices; no vertex
// moves by more than two diagonals of a cell.
CoarseMesh coarse_mesh(std::span<const Vec3> vertices, std::span<const std::array<int, 3>> triangles,
                       int max_vertices);

}  // namespace hawser
