// The volumes of a case: their surfaces for contact, their triangles for pictures.
#pragma once

#include <mpi.h>

#include <memory>
#include <string>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "hawser/geometry/triangle_mesh.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/io/results.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/body_skeleton.hpp"

namespace hawser::run {

struct LoadedVolume {
  std::string name;
  std::shared_ptr<const Surface> surface;  // exact for shapes
  std::shared_ptr<const MeshView> facets;  // the mesh itself; of a shape only for pictures
  std::vector<bool> active;                // one a facet
  std::string report;                      // what the mesh is, or that the shape is exact
  std::vector<std::string> notes;          // what was repaired and chosen, a sentence each
};

// In the order of the case. Throws InputError, on all ranks alike: what is no closed volume, has the wrong
// scale or is not fit for what its volume is to do is refused. Collective over comm: of its ranks on a host
// one reads and checks each mesh, and all use what it made of it, in memory they share. Ranks let go of the
// volumes in the same order, before MPI_Finalize.
std::vector<LoadedVolume> load_volumes(const model::Case& c, MPI_Comm comm = MPI_COMM_SELF,
                                       const io::ReadProgress& read_progress = {});

std::vector<std::shared_ptr<const Surface>> surfaces(const std::vector<LoadedVolume>& volumes);
std::vector<std::shared_ptr<const MeshView>> volume_facets(const std::vector<LoadedVolume>& volumes);
// What stands out of the volumes that touch other bodies with it, and where they are watched.
std::vector<BodySkeleton> skeletons(const model::Case& c, const std::vector<LoadedVolume>& volumes);
std::vector<io::VolumeMesh> volume_meshes(const model::Case& c, const std::vector<LoadedVolume>& volumes);

}  // namespace hawser::run
