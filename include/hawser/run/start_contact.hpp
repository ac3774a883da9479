// How lines start beside the volumes they may touch: what lies inside one, what of it is excluded from
// contact, and the warnings for the user.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/terms/start_inside.hpp"

namespace hawser::run {

struct StartContact {
  std::vector<ExcludedEnds> excluded_ends;  // by the case, and by default what is inside next to a held end
  std::vector<Inside> inside;      // the rest that is inside: a run can begin only if statics brings it out
  std::vector<std::string> notes;  // what is excluded by default, one sentence each
  std::vector<std::string> warnings;  // what lies inside, and what is on the wrong side of a volume
};

// The volumes that lines may touch, without stiffness. surfaces: one for each volume of the case.
std::vector<ContactVolume> volumes_of_lines(const model::Case& c,
                                            const std::vector<std::shared_ptr<const Surface>>& surfaces);

// Of the start shape `at`; feeders: null where there are none. The same on all ranks. Collective.
StartContact start_contact(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh, const Kinematics& at,
                           const Bodies& bodies, const Feeders* feeders,
                           const std::vector<ContactVolume>& volumes);

// Of a volume that lines are about to touch, what of a line is inside it at `at`, in words; empty: nothing.
// excluded_ends: stretches that have no contact with it, of volume 0. The same on all ranks. Collective.
std::string inside_text(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh, const Kinematics& at,
                        const Bodies& bodies, const Feeders* feeders, const ContactVolume& volume,
                        const std::vector<ExcludedEnds>& excluded_ends);

// Of what was inside at the start what still is at `at`, in one sentence; empty: nothing. The same on all
// ranks. Collective.
std::string still_inside(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh, const Kinematics& at,
                         const Bodies& bodies, const Feeders* feeders,
                         const std::vector<ContactVolume>& volumes, const StartContact& start);

}  // namespace hawser::run
