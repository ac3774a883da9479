// Notes on bodies in contact: those that statics moves along surfaces whose friction it excludes, and those
// that overlap at the start of the motion.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/system.hpp"
#include "hawser/terms/bodies.hpp"
#include "hawser/terms/body_contact.hpp"
#include "hawser/terms/static_rest.hpp"

namespace hawser::run {

// A body that rests on another one (-1: on volumes fixed in space); indices of the case.
struct RestsOnBody {
  int body = 0, other = -1;
  auto operator<=>(const RestsOnBody&) const = default;
};
// Bodies with weight or loads that start in contact and that nothing else supports in statics. support: by
// body of the case, for those of this rank. The same on all ranks. Collective.
std::vector<RestsOnBody> bodies_starting_in_contact(const model::Case& c,
                                                    const std::vector<StaticRest>& support,
                                                    const System& system, const Kinematics& start);
// True if each of these bodies still touches a body on which it started, and has neither turned nor moved
// significantly relative to those that it touches. touching: volumes in contact in the equilibrium; start,
// equilibrium: poses of all bodies.
bool have_stayed(const model::Case& c, const std::vector<RestsOnBody>& resting,
                 const std::vector<TouchingVolumes>& touching, const std::vector<RigidPose>& start,
                 const std::vector<RigidPose>& equilibrium);
// Poses of the bodies of the case in a state, on all ranks. Collective.
std::vector<RigidPose> poses_of(const System& system, const Bodies& bodies, const Kinematics& state);
// Volumes of bodies that touch each other. The same on all ranks. Collective.
std::vector<TouchingVolumes> touching_volumes(const System& system, const Kinematics& state);
// Messages about bodies that rest on a volume with friction and have toppled or rolled in statics, and in
// statics without friction between bodies those that have moved along it from their initial position
// (advice::moved_without_friction), or have left the volume on which they started (`at_start`). The same on
// all ranks. Collective.
std::vector<std::string> bodies_moved_by_statics(const model::Case& c, const System& system,
                                                 const Bodies& bodies, const Kinematics& equilibrium,
                                                 const std::vector<TouchingVolumes>& at_start,
                                                 bool friction_in_statics);
// Messages about volumes that the energy of their contact drives apart (BodyContact::driven_apart). The same
// on all ranks. Collective.
std::vector<std::string> bodies_driven_apart(const model::Case& c, const System& system,
                                             const Kinematics& start);

}  // namespace hawser::run
