// Checks of a volume's mesh: size in metres, suitability for its inside test, active part, and sharp edges
// for contact by edges or corners.
#include "hawser/io/mesh_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "hawser/base/error.hpp"
#include "hawser/geometry/point_in_polyhedron.hpp"
#include "hawser/geometry/sharp_edges.hpp"
#include "hawser/io/case_reader_parts.hpp"
#include "hawser/model/body_pairs.hpp"

namespace hawser::io {

namespace {

// Names in the schema, in the order of model::SignTest.
constexpr const char* kSigns[] = {"automatic",   "pseudonormal", "winding",
                                  "tetrahedron", "ray",          "solid_angle"};

// Reason why a mesh is unsuitable for the inside test of its volume; empty: it is suitable.
std::string unfit(const LoadedMesh& loaded, model::SignTest sign) {
  const MeshReport& r = loaded.report;
  if (sign == model::SignTest::automatic || sign == model::SignTest::winding) return "";
  if (loaded.open || !r.valid())
    return fmt::format(
        "needs a closed mesh whose triangles face outward, but this one has {} open edges, {} of more than "
        "two triangles and {} between triangles of opposite orientation; 'automatic' and 'winding' do "
        "without",
        r.open_edges, r.non_manifold_edges, r.flipped_edges);
  if (sign != model::SignTest::tetrahedra) return "";
  if (r.components > 1)
    return fmt::format(
        "is for one convex body, but the mesh has {} pieces; give each a volume of its own, or use 'ray' or "
        "'solid_angle'",
        r.components);
  // Tolerance for flat faces in single precision.
  if (!is_convex(loaded.mesh, 1e-5 * r.box.extent().maxCoeff()))
    return "is for convex bodies, and this mesh is not convex; use 'ray' or 'solid_angle', or cut it into "
           "convex parts";
  return "";
}

}  // namespace

double reading_time(const std::string& path) {
  constexpr double kSpeed = 2e7;  // bytes per second, STL and OBJ files on one core of docs/performance.md
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? 0 : static_cast<double>(size) / kSpeed;
}

std::string reading_text(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  const double mb = error ? 0 : 1e-6 * static_cast<double>(size);
  return fmt::format("reading the mesh {} ({:.{}f} MB)", std::filesystem::path(path).filename().string(), mb,
                     mb < 10 ? 1 : 0);
}

FitMesh check_mesh(const model::Case& c, const model::Volume& v, const LoadedMesh& loaded) {
  // Limits: no body at sea is as large as a mesh in mm read as m.
  constexpr SizeLimits kSizes{5000, 0.02, 1e5};
  const std::string key = "volumes." + v.name;
  const double size = loaded.report.box.extent().maxCoeff();
  if (const std::string odd = other_units(size, kSizes, c); !odd.empty())
    c.refuse(key + ".scale", "the mesh, with scale {:g}, {}", v.scale, odd);
  if (const std::string why = unfit(loaded, v.sign); !why.empty())
    c.refuse(key + ".sign", std::string("'") + kSigns[static_cast<int>(v.sign)] + "' " + why);
  FitMesh fit;
  try {
    fit.active = active_triangles(loaded.mesh, v);
  } catch (const InputError& e) {
    c.refuse(key + ".active", e.what());
  }
  const bool sharp =
      v.basis == model::StiffnessBasis::per_point || v.basis == model::StiffnessBasis::per_length;
  fit.blunt = sharp && sharp_edges(loaded.mesh, fit.active).empty();
  return fit;
}

void check_leaders(const model::Case& c, const std::vector<bool>& blunt) {
  const std::vector<model::BodyPair> pairs = model::body_pairs(c);
  for (const model::BodyPair& p : pairs) {
    const bool other = std::any_of(pairs.begin(), pairs.end(), [&](const model::BodyPair& q) {
      return q.a == p.b && q.b == p.a && !blunt[q.a];
    });
    if (!blunt[p.a] || other) continue;
    const model::Volume& a = c.volumes[p.a];
    const model::Volume& b = c.volumes[p.b];
    const bool points = a.basis == model::StiffnessBasis::per_point;
    c.refuse("volumes." + a.name + ".normal_stiffness",
             "'{}' is to meet '{}' with its {}, but {} of more than 10 deg: nothing would touch; give a "
             "stiffness per_area",
             a.name, b.name, points ? "corners (per_point)" : "edges (per_length)",
             blunt[p.b] ? "neither mesh has an edge" : "its mesh has none");
  }
}

}  // namespace hawser::io
