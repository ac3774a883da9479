// STL files, text and binary. Our own: Assimp takes a text that does not begin with a small "solid" at once
// for none, and says of a file cut short what nobody can make sense of.
#pragma once

#include <cstdint>
#include <string>

#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::io {

// Facets (corners times scale; the normals are not read) to `mesh`, each solid a part. Returns what is wrong
// with the file, a sentence, or nothing. `bytes`: size of the file.
std::string read_stl(const std::string& path, std::uintmax_t bytes, double scale, TriangleMesh& mesh);

}  // namespace hawser::io
