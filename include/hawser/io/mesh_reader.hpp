// Triangle meshes from STL, OBJ and PLY files, welded, checked and turned outward.
#pragma once

#include <string>
#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"
#include "hawser/model/case.hpp"

namespace hawser::io {

// m; no coordinate of a file is farther from the origin. The earth has 4e7 around, and squares stay numbers.
inline constexpr double kFarthest = 1e8;

struct LoadedMesh {
  TriangleMesh mesh;               // m, welded, outward
  bool open = false;               // not closed, or not consistently oriented, after all
  MeshReport report;               // of the mesh as returned
  std::vector<std::string> notes;  // what was repaired, one sentence each
};

// Read `path` (by its extension .stl, .obj, .ply), multiply coordinates by `scale`, weld equal vertices
// (STL lists every corner anew, in single precision), turn triangles outward by repair(). Notes say what is
// wrong with a mesh and what is assumed. With `closed` one that is open, or cannot be turned outward, is
// refused. Parts are the groups or objects of an OBJ, the solids of an STL.
// Throws InputError "path: ..." for a file that is absent, empty or no mesh, and for a mesh
// that encloses nothing.
LoadedMesh read_mesh(const std::string& path, double scale = 1, bool closed = false);

// A sheet from the same files, welded and nothing else: open, facing any way. Throws InputError as above.
TriangleMesh read_sheet(const std::string& path, double scale = 1);

// One flag a triangle: does it take part in contact? By the volume's active_part or active_box.
// Throws InputError if there is no such part (with the nearest name) or no triangle in the box.
std::vector<bool> active_triangles(const TriangleMesh& mesh, const model::Volume& volume);

}  // namespace hawser::io
