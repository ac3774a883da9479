// Reader of PLY files of triangles and polygons, text and binary. Assimp trusts the counts in a PLY file;
// invalid files make it loop for ever or read beyond its memory.
#pragma once

#include <cstdint>
#include <string>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::io {

// Appends vertices (x, y, z of the element `vertex`, times scale) and faces (the list `vertex_indices` or
// `vertex_index`; polygons as fans, fewer than three corners excluded) to `mesh`. Returns a sentence on an
// error in the file, or empty. `bytes`: size of the file.
std::string read_ply(const std::string& path, std::uintmax_t bytes, double scale, TriangleMesh& mesh);

}  // namespace hawser::io
