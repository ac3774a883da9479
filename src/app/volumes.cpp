#include "hawser/app/volumes.hpp"

#include "hawser/base/error.hpp"
#include "hawser/io/mesh_reader.hpp"

namespace hawser::app {

std::vector<LoadedVolume> load_volumes(const model::Case& c) {
  std::vector<LoadedVolume> out;
  for (const auto& v : c.volumes) {
    io::LoadedMesh loaded = io::read_mesh(v.mesh, v.scale);
    LoadedVolume l;
    l.name = v.name;
    l.active = io::active_triangles(loaded.mesh, v);
    l.report = summary(loaded.report);
    l.notes = loaded.notes;
    try {
      l.surface = std::make_shared<MeshSurface>(std::move(loaded.mesh), l.active);
    } catch (const std::invalid_argument& e) {
      throw InputError(c.path + ": volumes." + v.name + ".mesh: " + e.what());
    }
    out.push_back(std::move(l));
  }
  return out;
}

std::vector<std::shared_ptr<const Surface>> surfaces(const std::vector<LoadedVolume>& volumes) {
  std::vector<std::shared_ptr<const Surface>> out;
  for (const auto& v : volumes) out.push_back(v.surface);
  return out;
}

std::vector<io::VolumeMesh> volume_meshes(const model::Case& c, const std::vector<LoadedVolume>& volumes) {
  std::vector<io::VolumeMesh> out;
  for (size_t i = 0; i < volumes.size(); ++i) {
    const TriangleMesh& m = volumes[i].surface->mesh();
    out.push_back({volumes[i].name,
                   c.body_index(c.volumes[i].body),
                   m.vertices,
                   m.triangles,
                   {volumes[i].active.begin(), volumes[i].active.end()}});
  }
  return out;
}

}  // namespace hawser::app
