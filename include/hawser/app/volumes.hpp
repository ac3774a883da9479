// The volumes of a case with their meshes read.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/io/results.hpp"
#include "hawser/model/case.hpp"

namespace hawser::app {

struct LoadedVolume {
  std::string name;
  std::shared_ptr<const MeshSurface> surface;
  std::vector<bool> active;
  std::string report;              // what the mesh is
  std::vector<std::string> notes;  // what was repaired
};

// In the order of the case. Throws InputError.
std::vector<LoadedVolume> load_volumes(const model::Case& c);

std::vector<std::shared_ptr<const Surface>> surfaces(const std::vector<LoadedVolume>& volumes);
std::vector<io::VolumeMesh> volume_meshes(const model::Case& c, const std::vector<LoadedVolume>& volumes);

}  // namespace hawser::app
