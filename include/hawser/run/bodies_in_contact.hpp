// Notes on bodies in contact: those that statics moves along surfaces whose friction it excludes, and those
// that overlap at the start of the motion.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/system.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser::run {

// Messages about bodies that rest on a volume with friction and have moved along it from their initial
// position (advice::moved_without_friction); for statics without friction between bodies. The same on all
// ranks. Collective.
std::vector<std::string> bodies_moved_by_statics(const model::Case& c, const System& system,
                                                 const Bodies& bodies, const Kinematics& equilibrium);
// Messages about volumes that the energy of their contact drives apart (BodyContact::driven_apart). The same
// on all ranks. Collective.
std::vector<std::string> bodies_driven_apart(const model::Case& c, const System& system,
                                             const Kinematics& start);

}  // namespace hawser::run
