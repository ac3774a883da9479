// PLY files of triangles and polygons, text and binary. Our own: Assimp trusts what a PLY file says, and some
// make it loop for ever or read beyond its memory.
#pragma once

#include <cstdint>
#include <string>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::io {

// Vertices (x, y, z of the element `vertex`, times scale) and faces (the list `vertex_indices` or
// `vertex_index`; polygons as fans, fewer than three corners excluded) to `mesh`. Returns what is wrong with
// the file, a sentence, or nothing. `bytes`: size of the file.
std::string read_ply(const std::string& path, std::uintmax_t bytes, double scale, TriangleMesh& mesh);

}  // namespace hawser::io
