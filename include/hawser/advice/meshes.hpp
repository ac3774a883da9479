// Sentences about triangle meshes: what they are, what is wrong with them, what was repaired. None has the
// path of the file, which the caller puts before it.
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
// found: before the repair.
std::string mesh_not_clean(const MeshReport& found, const RepairResult& done);
std::string mesh_encloses_nothing(const MeshReport& found, const RepairResult& done);
std::string mesh_cannot_be_closed(const RepairResult& done);
std::string holes_not_filled(const RepairResult& done);
std::string mesh_not_closed(const MeshReport& report);
std::string cracks_closed(const CrackResult& done);
// Empty: none was dropped.
std::string duplicates_excluded(const DuplicateResult& done);
std::string flat_pieces_excluded(int pieces);
std::string only_flat_pieces();
std::string triangles_without_area(int removed);
// What contact and pictures have of a surface: sentences for `hawser check`, and notes.
std::string flat_facets();
std::string curved_facets(long curved, double bulge, long sharp_edges);  // m
std::string exact_shape(size_t triangles);
std::string drawn_coarser(size_t drawn, size_t vertices);
std::string internal_facets(long facets);
std::string slow_inside_test(size_t triangles);
std::string vertex_too_far(double distance, double scale);  // m

}  // namespace hawser::advice
