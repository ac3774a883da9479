// Volumes of a case: surfaces for contact, triangles for pictures.
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
  std::shared_ptr<const MeshView> facets;  // the mesh; for shapes only for pictures
  std::vector<bool> active;                // one per facet
  std::string report;                      // description of the mesh, or that the shape is exact
  std::vector<std::string> notes;          // repairs and choices, one sentence each
};

// In the order of the case. Throws InputError on all ranks for open meshes, wrong scale, or meshes unsuitable
// for their volume. Collective over comm: on each host one rank reads and checks each mesh, and all its ranks
// use the result in shared memory. Ranks must release the volumes in the same order, before MPI_Finalize.
std::vector<LoadedVolume> load_volumes(const model::Case& c, MPI_Comm comm = MPI_COMM_SELF,
                                       const io::ReadProgress& read_progress = {});

std::vector<std::shared_ptr<const Surface>> surfaces(const std::vector<LoadedVolume>& volumes);
std::vector<std::shared_ptr<const MeshView>> volume_facets(const std::vector<LoadedVolume>& volumes);
// Contact points, edges and faces of the slave volumes in contact between bodies.
std::vector<BodySkeleton> skeletons(const model::Case& c, const std::vector<LoadedVolume>& volumes);
std::vector<io::VolumeMesh> volume_meshes(const model::Case& c, const std::vector<LoadedVolume>& volumes);

}  // namespace hawser::run
