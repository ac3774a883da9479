// What is wrong with the meshes of a case's volumes, alone and for what they are to do.
#pragma once

#include <vector>

#include "hawser/io/mesh_reader.hpp"
#include "hawser/model/case.hpp"

namespace hawser::io {

// What the mesh of a volume is, once it is found fit for it.
struct FitMesh {
  std::vector<bool> active;  // one flag a triangle
  bool blunt = false;        // no edge or corner leads, where edges or corners are to
};

// Refuses a mesh of the wrong scale, not fit for the volume's `sign`, or without its `active` part.
FitMesh check_mesh(const model::Case& c, const model::Volume& v, const LoadedMesh& loaded);

// Of two bodies that touch something must stand out of one: through a smooth mesh they would pass unseen.
// blunt: one a volume.
void check_leaders(const model::Case& c, const std::vector<bool>& blunt);

}  // namespace hawser::io
