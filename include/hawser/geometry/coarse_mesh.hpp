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
  std::vector<int> from;                      // the triangle of the fine mesh that each is
};

// By vertex clustering (Rossignac and Borrel 1993): the vertices in each cell of an even grid become one,
// where it is nearest to the planes of their triangles (Lindstrom 2000), and triangles stay whose corners are
// in three cells. The finest grid, within 15 %, that leaves `most` (> 0) vertices or fewer; no vertex is
// further than two diagonals of a cell from those that it stands for.
CoarseMesh coarse_mesh(std::span<const Vec3> vertices, std::span<const std::array<int, 3>> triangles,
                       int most);

}  // namespace hawser
