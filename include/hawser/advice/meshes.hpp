// Messages about triangle meshes: summaries, faults and repairs. The caller adds the path of the file.
#pragma once

#include <string>

#include "hawser/geometry/mesh_duplicates.hpp"
#include "hawser/geometry/mesh_repair.hpp"
#include "hawser/geometry/mesh_weld.hpp"
#include "hawser/geometry/triangle_mesh.hpp"

namespace hawser::advice {

// One or two sentences for `hawser check`.
std::string mesh_summary(const MeshReport& report);
// A clause.
std::string repaired(const RepairResult& done);
// report: before the repair.
std::string mesh_not_clean(const MeshReport& report, const RepairResult& done);
std::string mesh_encloses_nothing(const MeshReport& report, const RepairResult& done);
std::string mesh_cannot_be_closed(const RepairResult& done);
std::string holes_not_filled(const RepairResult& done);
std::string mesh_not_closed(const MeshReport& report);
std::string cracks_closed(const CrackResult& done);
// Empty: no duplicates.
std::string duplicates_excluded(const DuplicateResult& done);
std::string flat_pieces_excluded(int pieces);
std::string only_flat_pieces();
std::string triangles_without_area(int removed);
// Sentences for `hawser check` and notes about the surface used by contact and pictures.
std::string flat_facets();
std::string curved_facets(long curved, double bulge, long sharp_edges);  // m
std::string exact_shape(size_t triangles);
std::string displayed_coarser(size_t displayed, size_t vertices);
std::string internal_facets(long facets);
std::string slow_inside_test(size_t triangles);
std::string vertex_too_far(double distance, double scale);  // m

}  // namespace hawser::advice
