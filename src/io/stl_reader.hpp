// Reader of STL files, text and binary. Assimp rejects text that does not begin with a lower-case "solid" and
// has no clear message for truncated files.
#pragma once

#include <cstdint>
#include <string>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::io {

// Appends facets (corners times scale; normals are not used) to `mesh`, one part per solid. Returns a
// sentence on an error in the file, or empty. `bytes`: size of the file.
std::string read_stl(const std::string& path, std::uintmax_t bytes, double scale, TriangleMesh& mesh);

}  // namespace hawser::io
