// Triangle meshes from STL, OBJ and PLY files, welded, checked and turned outward.
#pragma once

#include <string>
#include <vector>

#include "hawser/geometry/triangle_mesh.hpp"
#include "hawser/model/case.hpp"

namespace hawser::io {

// Largest coordinate in a file, m: above the circumference of the earth, 4e7 m, and safe when squared.
inline constexpr double kFarthest = 1e8;

struct LoadedMesh {
  TriangleMesh mesh;               // m, welded, outward
  bool open = false;               // still not closed or not consistently oriented after repair
  MeshReport report;               // of the returned mesh
  std::vector<std::string> notes;  // repairs, one sentence each
};

// Reads `path` (by its extension .stl, .obj, .ply), multiplies coordinates by `scale`, welds equal vertices
// (STL repeats every corner, in single precision) and orients triangles outward by repair(). Notes report
// faults and assumptions. With `closed`, a mesh that is open or cannot be oriented is refused. Parts are the
// groups or objects of an OBJ, the solids of an STL. Throws InputError "path: ..." for a missing, empty or
// invalid file and for a mesh that encloses no volume.
LoadedMesh read_mesh(const std::string& path, double scale = 1, bool closed = false);

// Reads a surface from the same formats, welded but otherwise unchanged: open, of any orientation. Throws
// InputError as above.
TriangleMesh read_sheet(const std::string& path, double scale = 1);

// One flag per triangle, true if it takes part in contact, by the volume's active_part or active_box. Throws
// InputError if there is no such part (with the nearest name) or no triangle in the box.
std::vector<bool> active_triangles(const TriangleMesh& mesh, const model::Volume& volume);

}  // namespace hawser::io
