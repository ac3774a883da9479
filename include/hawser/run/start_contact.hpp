// Lines that start inside or beside volumes: stretches inside, stretches excluded from contact, and warnings.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/terms/start_inside.hpp"

namespace hawser::run {

struct StartContact {
  std::vector<ExcludedEnds> excluded_ends;  // given by the case, or inside next to a held end
  std::vector<Inside> inside;               // other stretches inside; statics must move them out
  std::vector<double> outside_with;         // m, by `inside`: InsideVolume::outside_with
  std::vector<std::string> notes;           // default exclusions, one sentence each
  std::vector<std::string> warnings;        // about stretches inside and lines on the wrong side of a volume
};

// Volumes that lines may touch, without automatic stiffness. surfaces: one per volume of the case.
std::vector<ContactVolume> volumes_of_lines(const model::Case& c,
                                            const std::vector<std::shared_ptr<const Surface>>& surfaces);

// The lines of a case in a state, on this rank.
struct PlacedLines {
  MPI_Comm comm;
  const model::Case& c;
  const LocalMesh& mesh;
  const Bodies& bodies;
  const Feeders* feeders;  // null: there are none
  Kinematics state;
};

// For the start shape. The same on all ranks. Collective.
StartContact start_contact(const PlacedLines& start, const std::vector<ContactVolume>& volumes);

// Description of the part of a line inside a volume that lines are about to touch; empty: none.
// excluded_ends: stretches without contact with it, as volume 0. The same on all ranks. Collective.
std::string inside_text(const PlacedLines& lines, const ContactVolume& volume,
                        const std::vector<ExcludedEnds>& excluded_ends);

// Sentence on stretches that were inside at the start and still are; empty: none. The same on all ranks.
// Collective.
std::string still_inside(const PlacedLines& lines, const std::vector<ContactVolume>& volumes,
                         const StartContact& start);

}  // namespace hawser::run
