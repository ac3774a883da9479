// Steps from a mesh file to a closed outward surface: import, welding, closing of cracks, removal of
// duplicates, orientation and repair, each with a note for the user.
#include "hawser/io/mesh_reader.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <filesystem>
#include <limits>

#include "hawser/advice/meshes.hpp"
#include "hawser/base/error.hpp"
#include "hawser/geometry/mesh_duplicates.hpp"
#include "hawser/geometry/mesh_repair.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/mesh_weld.hpp"
#include "hawser/io/input_file.hpp"
#include "hawser/model/nearest.hpp"
#include "ply_reader.hpp"
#include "stl_reader.hpp"

namespace hawser::io {
namespace {

template <class... Args>
[[noreturn]] void refuse(const std::string& path, fmt::format_string<Args...> text, Args&&... args) {
  std::string s = path + ": " + fmt::format(text, std::forward<Args>(args)...);
  for (char& c : s)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  throw InputError(s);
}

void append(const aiMesh& from, const std::string& name, const aiMatrix4x4& to_root, double scale,
            TriangleMesh& mesh) {
  const int first = static_cast<int>(mesh.vertices.size());
  const int part = mesh.part_named(name);
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    const aiVector3D v = to_root * from.mVertices[i];
    mesh.vertices.push_back(scale * Vec3(v.x, v.y, v.z));
  }
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace& f = from.mFaces[i];
    if (f.mNumIndices != 3) continue;  // points and lines bound no volume
    mesh.triangles.push_back({first + static_cast<int>(f.mIndices[0]),
                              first + static_cast<int>(f.mIndices[1]),
                              first + static_cast<int>(f.mIndices[2])});
    mesh.part.push_back(part);
  }
}

void append(const aiScene& scene, const aiNode& node, const aiMatrix4x4& above, double scale,
            TriangleMesh& mesh) {
  const aiMatrix4x4 to_root = above * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& m = *scene.mMeshes[node.mMeshes[i]];
    // An OBJ has the names of its groups on the meshes.
    append(m, m.mName.length > 0 ? m.mName.C_Str() : node.mName.C_Str(), to_root, scale, mesh);
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) append(scene, *node.mChildren[i], to_root, scale, mesh);
}

TriangleMesh import(const std::string& path, double scale) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (const std::string why = unreadable(path, "mesh", kMostMesh); !why.empty()) refuse(path, "{}", why);
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension != ".stl" && extension != ".obj" && extension != ".ply")
    refuse(path, "meshes are read from STL, OBJ and PLY files (.stl, .obj, .ply), not from '{}'", extension);
  if (fs::file_size(path, error) == 0 || error) refuse(path, "the mesh file is empty or cannot be read");

  TriangleMesh mesh;
  if (extension != ".obj") {
    const auto read = extension == ".ply" ? read_ply : read_stl;
    if (const std::string problem = read(path, fs::file_size(path), scale, mesh); !problem.empty())
      refuse(path, "{}", problem);
  } else {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate | aiProcess_SortByPType);
    if (!scene || !scene->mRootNode) refuse(path, "cannot be read as a mesh: {}", importer.GetErrorString());
    append(*scene, *scene->mRootNode, aiMatrix4x4(), scale, mesh);
  }
  if (mesh.triangles.empty()) refuse(path, "holds no triangles");
  for (const Vec3& v : mesh.vertices) {
    if (!v.allFinite()) refuse(path, "has a vertex that is no finite number");
    if (const double far = v.cwiseAbs().maxCoeff(); far > kFarthest)
      refuse(path, "{}", advice::vertex_too_far(far, scale));
  }
  return mesh;
}

}  // namespace

namespace {

// Repairs a mesh that is open, inconsistent or inside out, and notes faults and assumptions.
void repair_mesh(const std::string& path, LoadedMesh& loaded, bool closed) {
  const MeshReport report = loaded.report;
  const RepairResult repaired = repair(loaded.mesh);
  loaded.report = inspect(loaded.mesh);
  loaded.open = !loaded.report.valid();
  if (closed && loaded.open) refuse(path, "{}", advice::mesh_cannot_be_closed(repaired));
  if (repaired.enclosing < 0.5) refuse(path, "{}", advice::mesh_encloses_nothing(report, repaired));
  loaded.notes.push_back(path + ": " + advice::mesh_not_clean(report, repaired));
  if (loaded.open) loaded.notes.push_back(path + ": " + advice::holes_not_filled(repaired));
}

// Tolerance of equal corners: rounding to single precision.
double rounding(const TriangleMesh& mesh) {
  double size = 0;
  for (const Vec3& v : mesh.vertices) size = std::max(size, v.cwiseAbs().maxCoeff());
  return 4.0 * std::numeric_limits<float>::epsilon() * size;
}

WeldResult weld_corners(const std::string& path, TriangleMesh& mesh) {
  const WeldResult welded = weld(mesh, rounding(mesh));
  if (mesh.triangles.empty()) refuse(path, "holds only triangles without area");
  return welded;
}

// Closes cracks between corners that differ by noise or rounding.
void close_cracks(const std::string& path, LoadedMesh& loaded) {
  const CrackResult c = weld_cracks(loaded.mesh);
  if (c.welded == 0) return;
  loaded.notes.push_back(path + ": " + advice::cracks_closed(c));
}

// Removes duplicate triangles and pieces without thickness.
void drop_double(const std::string& path, LoadedMesh& loaded) {
  if (const std::string text = advice::duplicates_excluded(drop_duplicates(loaded.mesh)); !text.empty())
    loaded.notes.push_back(path + ": " + text);
  if (const int flat = drop_flat_pieces(loaded.mesh, rounding(loaded.mesh)); flat > 0)
    loaded.notes.push_back(path + ": " + advice::flat_pieces_excluded(flat));
  weld(loaded.mesh);  // removes unused corners
  if (loaded.mesh.triangles.empty()) refuse(path, "{}", advice::only_flat_pieces());
}

}  // namespace

TriangleMesh read_sheet(const std::string& path, double scale) {
  TriangleMesh mesh = import(path, scale);
  weld_corners(path, mesh);
  return mesh;
}

LoadedMesh read_mesh(const std::string& path, double scale, bool closed) {
  LoadedMesh loaded;
  loaded.mesh = import(path, scale);
  TriangleMesh& mesh = loaded.mesh;
  const WeldResult welded = weld_corners(path, mesh);
  if (welded.removed > 0)
    loaded.notes.push_back(path + ": " + advice::triangles_without_area(welded.removed));
  close_cracks(path, loaded);
  drop_double(path, loaded);

  MeshReport& report = loaded.report;
  report = inspect(mesh);
  if (closed && !report.closed) refuse(path, "{}", advice::mesh_not_closed(report));
  if (!report.valid()) repair_mesh(path, loaded, closed);
  report.welded = welded.welded;
  report.removed = welded.removed;
  return loaded;
}

std::vector<bool> active_triangles(const TriangleMesh& mesh, const model::Volume& volume) {
  if (volume.active_box) {
    const Vec3& a = volume.active_box->lower;
    const Vec3& b = volume.active_box->upper;
    Box box;
    box.lo = a;
    box.hi = b;
    std::vector<bool> active = active_by_box(mesh, box);
    if (std::none_of(active.begin(), active.end(), [](bool x) { return x; }))
      throw InputError("no triangle of the mesh lies in this box");
    return active;
  }
  if (!volume.active_part.empty()) {
    if (std::find(mesh.parts.begin(), mesh.parts.end(), volume.active_part) == mesh.parts.end())
      throw InputError("the mesh has no part {}{} (parts: {})", model::quote(volume.active_part),
                       model::did_you_mean(volume.active_part, mesh.parts), fmt::join(mesh.parts, ", "));
    return active_by_part(mesh, {volume.active_part});
  }
  return std::vector<bool>(mesh.triangles.size(), true);
}

}  // namespace hawser::io
