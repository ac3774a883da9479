// Choice of the automatic stiffness of a volume at the start of a run.
#pragma once

#include <string>
#include <vector>

#include "hawser/mesh/mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/contact_volumes.hpp"

namespace hawser::run {

// Sets the stiffness of a volume with the basis `automatic`, from the line with the largest demand. Adds a
// note that gives the reason, and whether the steps are too long to resolve a bounce.
void choose_stiffness(const model::Case& c, const Mesh& mesh, ContactVolume& volume,
                      std::vector<std::string>& notes);

}  // namespace hawser::run
