// Checks of volume meshes, alone and for their purpose in the case.
#pragma once

#include <vector>

#include "hawser/io/mesh_reader.hpp"
#include "hawser/model/case.hpp"

namespace hawser::io {

// Properties of a checked volume mesh.
struct FitMesh {
  std::vector<bool> active;  // one flag per triangle
  bool blunt = false;        // has no sharp edge or corner, although contact is by edges or corners
};

// Refuses a mesh of wrong scale, unsuitable for the volume's `sign`, or without its `active` part.
FitMesh check_mesh(const model::Case& c, const model::Volume& v, const LoadedMesh& loaded);

// Checks that each pair of bodies in contact has edges or corners on one side: a smooth mesh alone would be
// penetrated undetected. blunt: one flag per volume.
void check_leaders(const model::Case& c, const std::vector<bool>& blunt);

}  // namespace hawser::io
