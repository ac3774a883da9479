// Hydrostatics of hulls by their volumes: whether they float, their stiffness, and what `hawser check` prints
// of them.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/run/volumes.hpp"

namespace hawser::run {

// Puts the restoring stiffness of hulls into the case. InputError where a hull is not closed, or is lighter
// in water than its body.
void set_hydrostatics(model::Case& c, const std::vector<LoadedVolume>& volumes);

// Displaced volume, buoyancy and weight, waterplane and metacentric heights of each hull where the case puts
// it, in lines; a warning where it would float more than 0.1 m off without lines. Empty: there are no hulls.
std::string hulls_text(const model::Case& c, const std::vector<LoadedVolume>& volumes);

}  // namespace hawser::run
