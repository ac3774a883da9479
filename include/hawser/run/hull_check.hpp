// Hydrostatics of hulls from their volumes: flotation, stiffness, and the output of `hawser check`.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/run/volumes.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/system.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser::run {

// Sets the restoring stiffness of hulls in the case, and notes volumes of floating bodies below the seabed.
// Throws InputError if a hull is open or its largest buoyancy is below its body's weight.
void set_hydrostatics(model::Case& c, const std::vector<LoadedVolume>& volumes);

// Displaced volume, buoyancy, weight, waterplane and metacentric heights of each hull at its position in the
// case (advice::hull_at_start), one paragraph each. Empty: no hulls.
std::string hulls_text(const model::Case& c, const std::vector<LoadedVolume>& volumes);

// Messages about bodies of any rank with hulls or hydrodynamic coefficients whose rest position differs from
// that of the case (advice::equilibrium_differs). Collective.
std::vector<std::string> platforms_off_start(MPI_Comm comm, const model::Case& c, const Bodies& bodies,
                                             const Kinematics& equilibrium);

// Messages about such bodies of any rank that rest with the underside up (advice::turned_over), or so far
// from upright that linear coefficients do not hold (advice::tilted). Collective.
std::vector<std::string> platforms_tilted(MPI_Comm comm, const model::Case& c, const Bodies& bodies,
                                          const Kinematics& equilibrium);

// Vertical force on each of these bodies at rest besides its weight and the water (advice::held_at_rest). On
// one rank.
std::vector<std::string> platforms_held(const model::Case& c, const System& system,
                                        const Kinematics& equilibrium);

}  // namespace hawser::run
