// Hydrostatics of hulls by their volumes: whether they float, their stiffness, and what `hawser check` prints
// of them.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/run/volumes.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser::run {

// Puts the restoring stiffness of hulls into the case. InputError where a hull is not closed, or is lighter
// in water than its body.
void set_hydrostatics(model::Case& c, const std::vector<LoadedVolume>& volumes);

// Displaced volume, buoyancy and weight, waterplane and metacentric heights of each hull where the case puts
// it, in lines (advice::hull_at_start). Empty: there are no hulls.
std::string hulls_text(const model::Case& c, const std::vector<LoadedVolume>& volumes);

// Of the bodies of this rank with hulls or hydrodynamic coefficients that do not rest where the case puts
// them (advice::rests_elsewhere).
std::vector<std::string> platforms_off_start(const model::Case& c, const Bodies& bodies,
                                             const Kinematics& rest);

}  // namespace hawser::run
