// Start positions of the nodes of all lines (catenaries, straight or given shapes, with rotations along the
// line), and the ties of their ends.
#pragma once

#include <mpi.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/tied_nodes.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser {

struct StartShape {
  State state;                 // of this rank's local nodes, at t = 0, at rest
  std::vector<TiedNode> tied;  // of this rank's local nodes
  // By line, of those with local nodes and of those with feeders: node axes at ends A and B, in the frame of
  // the body there (or space).
  std::vector<std::array<Quat, 2>> ends;
  // Positions [m] where this rank's local nodes were laid on the bed (laid_places), and whether they are
  // known for any line of the case. If not, statics has no friction on the bed.
  std::vector<Vec3> laid;
  bool any_laid = false;
  std::vector<std::string> notes;  // on clamped ends that point against their line
};

// Positions of the nodes come from the start of each line in the case (Start). Rotations follow the tangent
// with least twist from end A, where axis 2 is horizontal. A clamped end has its given direction, or else the
// tangent of the start shape. If no end of a line of beams is clamped, its twist is held at one supported
// end, because nothing else holds it. Where lines cross near the bed, or volumes lie on it, the upper line is
// raised (start_crossings.hpp). surfaces: of the volumes of the case; empty: volumes are ignored. A rank
// makes the shapes of lines with local nodes, and of those that act on them at the start (start_share.hpp).
// Throws InputError as line_start() and start_crossings.hpp do, on all ranks. Collective.
StartShape start_shape(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh, const Bodies& bodies,
                       const std::vector<std::shared_ptr<const Surface>>& surfaces = {});

}  // namespace hawser
