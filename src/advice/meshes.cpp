// Messages about triangle meshes.
#include "hawser/advice/meshes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>
#include <vector>

#include "hawser/base/count_of.hpp"

namespace hawser::advice {
namespace {

// Faults of a mesh, as nouns.
std::string faults_of(const MeshReport& report) {
  std::vector<std::string> faults;
  if (report.open_edges > 0) faults.push_back(count_of(report.open_edges, "open edge", "open edges"));
  if (report.non_manifold_edges > 0)
    faults.push_back(count_of(report.non_manifold_edges, "edge") + " of more than two triangles");
  if (report.flipped_edges > 0)
    faults.push_back(count_of(report.flipped_edges, "edge") + " between triangles of opposite orientation");
  if (report.degenerate > 0) faults.push_back(count_of(report.degenerate, "triangle") + " of no area");
  if (faults.empty()) faults.emplace_back("normals that point into the solid");
  return fmt::format("{}", fmt::join(faults, ", "));
}

}  // namespace

std::string mesh_summary(const MeshReport& r) {
  std::ostringstream s;
  s.precision(6);
  s << count_of(r.triangles, "triangle") << ", " << count_of(r.vertices, "vertex", "vertices") << " in "
    << count_of(r.components, "piece");
  if (r.triangles > 0) {
    const Vec3 e = r.box.extent();
    s << ", " << e.x() << " x " << e.y() << " x " << e.z() << " m, edges " << r.shortest_edge << " to "
      << r.longest_edge << " m, area " << r.area << " m²";
  }
  if (r.valid()) s << ", closed and outward, volume " << r.volume << " m³";
  s << ".";
  if (r.welded > 0 || r.removed > 0)
    s << " Merged " << count_of(r.welded, "vertex", "vertices") << ", which removed "
      << count_of(r.removed, "triangle") << ".";
  std::vector<std::string> faults;
  if (r.triangles == 0) faults.push_back("it is empty");
  if (r.open_edges > 0)
    faults.push_back(count_of(r.open_edges, "edge has", "edges have") + " a triangle on one side only");
  if (r.non_manifold_edges > 0)
    faults.push_back(count_of(r.non_manifold_edges, "edge joins", "edges join") + " more than two triangles");
  if (r.flipped_edges > 0)
    faults.push_back(count_of(r.flipped_edges, "edge lies", "edges lie") +
                     " between triangles of opposite orientation");
  if (r.closed && r.consistently_oriented && !r.outward) faults.push_back("normals point into the solid");
  if (r.degenerate > 0)
    faults.push_back(count_of(r.degenerate, "triangle has", "triangles have") + " no area");
  for (size_t i = 0; i < faults.size(); ++i)
    s << (i == 0 ? (r.valid() ? " Note: " : " Not clean: ") : "; ") << faults[i];
  if (!faults.empty()) s << ".";
  return s.str();
}

std::string repaired(const RepairResult& done) {
  std::string text = done.turned == 0
                         ? std::string("no triangle turned over")
                         : count_of(done.turned, "triangle") +
                               " turned over (inside and outside found by counting the crossings of rays)";
  if (done.one_sided > 0)
    text += "; " + count_of(done.one_sided, "patch is", "patches are") +
            " one-sided like a Möbius band and not changed";
  return text;
}

std::string mesh_not_clean(const MeshReport& report, const RepairResult& done) {
  return fmt::format("the mesh is not clean: {}; {}", faults_of(report), repaired(done));
}

std::string mesh_encloses_nothing(const MeshReport& report, const RepairResult& done) {
  return fmt::format(
      "the mesh encloses nothing: it has {} among {} triangles, and only {:.0f} % of its area has an inside; "
      "a sheet needs a thickness, or use a `shape`",
      faults_of(report), report.triangles, 100 * done.enclosing);
}

std::string mesh_cannot_be_closed(const RepairResult& done) {
  return "the triangles cannot be turned outward: " + repaired(done);
}

std::string holes_not_filled(const RepairResult& done) {
  return fmt::format(
      "holes are not filled: the inside is where the winding number is above 1/2, which is true "
      "behind {:.4g} % of the surface",
      100 * done.enclosing);
}

std::string mesh_not_closed(const MeshReport& report) {
  return fmt::format(
      "the mesh is not closed: {} open edges and {} edges of more than two triangles in {} triangles; the "
      "volume has `closed: required`",
      report.open_edges, report.non_manifold_edges, report.triangles);
}

std::string cracks_closed(const CrackResult& done) {
  return fmt::format(
      "{} of open edges that lay up to {:.2g} m apart {} merged{}; {}", count_of(done.welded, "corner"),
      done.widest, done.welded == 1 ? "was" : "were",
      done.removed > 0 ? fmt::format(", which removed {}", count_of(done.removed, "triangle")) : "",
      done.open_edges == 0 ? "all edges are now closed"
                           : count_of(done.open_edges, "edge is", "edges are") + " still open");
}

std::string duplicates_excluded(const DuplicateResult& done) {
  std::vector<std::string> parts;
  if (done.copies > 0)
    parts.push_back(count_of(done.copies, "triangle that is", "triangles that are") +
                    " listed more than once, excluded");
  if (done.back_to_back > 0)
    parts.push_back(
        fmt::format("{} triangles that lie back to back and enclose no volume, excluded", done.back_to_back));
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::string flat_pieces_excluded(int pieces) {
  return count_of(pieces, "piece") + " without thickness excluded";
}

std::string only_flat_pieces() {
  return "the mesh encloses nothing: its triangles lie back to back; a sheet needs a thickness, or use a "
         "`shape`";
}

std::string triangles_without_area(int removed) {
  return fmt::format("{} triangles without area were removed", removed);
}

std::string flat_facets() { return "Facets are flat."; }

std::string curved_facets(long curved, double bulge, long sharp_edges) {
  if (curved == 0) return "No facet is part of a curved surface.";
  return fmt::format("{} facets are curved, by up to {:.3g} m; {} edges are sharp.", curved, bulge,
                     sharp_edges);
}

std::string exact_shape(size_t triangles) {
  return fmt::format("exact shape; {} triangles for pictures only", triangles);
}

std::string displayed_coarser(size_t displayed, size_t vertices) {
  return fmt::format(
      "The file for ParaView has at most {} of its {} vertices, as it moves; contact uses all.", displayed,
      vertices);
}

std::string internal_facets(long facets) {
  return fmt::format("{} triangles have the inside on both sides and are excluded from contact", facets);
}

std::string slow_inside_test(size_t triangles) {
  return fmt::format("the inside test visits all {} triangles at every query; `sign: automatic` is faster",
                     triangles);
}

std::string vertex_too_far(double distance, double scale) {
  return fmt::format(
      "has a vertex {:.4g} m from the origin; is it in other units than metres (scale is {:g})?", distance,
      scale);
}

}  // namespace hawser::advice
