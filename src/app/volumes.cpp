#include "hawser/app/volumes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "hawser/base/error.hpp"
#include "hawser/base/host.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/primitives.hpp"
#include "hawser/geometry/tested_surface.hpp"
#include "hawser/io/mesh_reader.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/body_pairs.hpp"
#include "hawser/model/check.hpp"

namespace hawser::app {
namespace {

std::optional<SignBy> sign_by(model::SignTest sign) {
  switch (sign) {
    case model::SignTest::winding:
      return SignBy::winding;
    case model::SignTest::tetrahedra:
      return SignBy::tetrahedra;
    case model::SignTest::ray:
      return SignBy::ray;
    case model::SignTest::solid_angle:
      return SignBy::solid_angle;
    case model::SignTest::automatic:
    case model::SignTest::pseudonormal:
      break;
  }
  return std::nullopt;
}

// A surface and a view of its triangles.
void set_surface(LoadedVolume& l, const model::Volume& v, std::shared_ptr<const MeshSurface> surface) {
  struct Kept {
    std::shared_ptr<const MeshSurface> surface;
    MeshView view;
  };
  const auto kept = std::make_shared<const Kept>(Kept{surface, surface->mesh()});
  l.facets = {kept, &kept->view};
  l.surface = surface;
  const bool partial = std::find(l.active.begin(), l.active.end(), false) != l.active.end();
  if (const auto by = sign_by(v.sign)) l.surface = std::make_shared<TestedSurface>(surface, *by, partial);
}

struct LoadedMeshVolume {
  LoadedVolume volume;  // without a surface
  std::shared_ptr<const MeshSurface> surface;
};

LoadedMeshVolume load_mesh(const model::Volume& v) {
  io::LoadedMesh loaded = io::read_mesh(v.mesh, v.scale, v.closed);
  LoadedVolume l;
  l.name = v.name;
  l.active = io::active_triangles(loaded.mesh, v);
  l.report = summary(loaded.report);
  l.notes = loaded.notes;
  const auto surface = std::make_shared<MeshSurface>(
      std::move(loaded.mesh), l.active, MeshSurfaceOptions{v.smooth, v.crease_angle, loaded.open});
  if (surface->internal_facets() > 0)
    l.notes.push_back(
        fmt::format("{}: {} triangles have the inside on both sides and are left out of contact", v.mesh,
                    surface->internal_facets()));
  if (!v.smooth) {
    l.report += " Facets are flat.";
  } else if (surface->curved() == 0) {
    l.report += " No facet is part of a curved surface.";
  } else {
    l.report += fmt::format(" {} facets are curved, by up to {:.3g} m; {} edges are sharp.",
                            surface->curved(), surface->bulge(), surface->sharp_edges());
  }
  if (const auto by = sign_by(v.sign); by && *by != SignBy::winding)
    l.notes.push_back(
        fmt::format("inside is told by a test of all {} triangles each time; `sign: automatic` is quicker",
                    surface->mesh().triangles.size()));
  return {std::move(l), surface};
}

// What the leading rank has, on all ranks of the host.
void tell(MPI_Comm comm, std::string& text) {
  auto n = static_cast<std::uint64_t>(text.size());
  MPI_Bcast(&n, 1, MPI_UINT64_T, 0, comm);
  text.resize(n);
  MPI_Bcast(text.data(), static_cast<int>(n), MPI_CHAR, 0, comm);
}
void tell(MPI_Comm comm, LoadedVolume& l) {
  tell(comm, l.name), tell(comm, l.report);
  auto notes = static_cast<std::uint64_t>(l.notes.size());
  MPI_Bcast(&notes, 1, MPI_UINT64_T, 0, comm);
  l.notes.resize(notes);
  for (std::string& n : l.notes) tell(comm, n);
  std::string active(l.active.begin(), l.active.end());
  tell(comm, active);
  l.active.assign(active.begin(), active.end());
}

// The wrong of any rank is the wrong of all: the lowest one's is told.
void agree(MPI_Comm comm, std::string wrong) {
  int rank = 0, first = INT_MAX;
  MPI_Comm_rank(comm, &rank);
  const int mine = wrong.empty() ? INT_MAX : rank;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, comm);
  if (first == INT_MAX) return;
  auto n = static_cast<std::uint64_t>(wrong.size());
  MPI_Bcast(&n, 1, MPI_UINT64_T, first, comm);
  wrong.resize(n);
  MPI_Bcast(wrong.data(), static_cast<int>(n), MPI_CHAR, first, comm);
  throw InputError(wrong);
}

LoadedVolume share_mesh(MPI_Comm comm, const Host& host, const model::Case& c, const model::Volume& v) {
  LoadedMeshVolume made;
  const auto make = [&](bool here) {
    std::string wrong;
    try {
      if (here) made = load_mesh(v);
    } catch (const std::invalid_argument& e) {
      wrong = c.path + ": volumes." + v.name + ".mesh: " + e.what();
    } catch (const std::exception& e) {
      wrong = e.what();
    }
    agree(comm, wrong);
  };
  make(host.leads());
  bool lacks = false;
  if (host.size() > 1) {
    const auto block = host.share(host.leads() ? made.surface->packed_size() : 0,
                                  [&](std::byte* to) { made.surface->write(to); });
    tell(host.comm(), made.volume);
    if (block) made.surface = std::make_shared<MeshSurface>(block);
    lacks = !block && !host.leads();
  }
  make(lacks);
  set_surface(made.volume, v, std::move(made.surface));
  return std::move(made.volume);
}

// What lines may reach, in the frame of a body at t = 0 before it moves: so much of a plane is drawn.
// A line reaches its length from one held end, half its length from the middle between two.
Box reach(const model::Case& c, const std::string& body_name) {
  const int b = c.body_index(body_name);
  const model::Body space, &body = b < 0 ? space : c.bodies[static_cast<std::size_t>(b)];
  const Quat turn = exp_so3(body.rotation).conjugate();
  const auto local = [&](const Vec3& x) { return Vec3(turn * (x - body.position)); };
  Box box;
  for (const model::Line& line : c.lines) {
    const double length = model::length_of(line);
    Box own;
    for (const Vec3& p : line.points) own.add(local(p));
    int held = 0;
    for (const model::End* e : {&line.end_a, &line.end_b})
      if (e->kind != model::EndKind::free) own.add(local(model::end_position(c, *e))), ++held;
    if (line.points.empty() && held > 0) {
      const Vec3 middle = own.centre();
      own.add(Box{middle, middle}.grown(held == 1 ? length : 0.5 * length));
    }
    box.add(own);
  }
  return box;
}

LoadedVolume load_shape(const model::Case& c, const model::Volume& v) {
  LoadedVolume l;
  l.surface = make_surface(*v.shape);
  struct Kept {
    TriangleMesh mesh;
    MeshView view;
  };
  const auto kept = std::make_shared<Kept>();
  kept->mesh = facets(*v.shape, reach(c, v.body));
  kept->view = kept->mesh;
  l.facets = {kept, &kept->view};
  l.active.assign(l.facets->triangles.size(), true);
  l.report = fmt::format("exact shape; {} triangles for pictures only", l.facets->triangles.size());
  return l;
}

}  // namespace

std::vector<LoadedVolume> load_volumes(const model::Case& c, MPI_Comm comm, const io::ReadingNews& news) {
  const Host host(comm);
  std::vector<LoadedVolume> out;
  for (const auto& v : c.volumes) {
    if (!v.shape && news.busy)
      news.busy(fmt::format("making the mesh {} ready", std::filesystem::path(v.mesh).filename().string()),
                io::reading_time(v.mesh));
    try {
      out.push_back(v.shape ? load_shape(c, v) : share_mesh(comm, host, c, v));
    } catch (const std::invalid_argument& e) {
      throw InputError(c.path + ": volumes." + v.name + ".shape: " + e.what());
    }
    out.back().name = v.name;
  }
  return out;
}

std::vector<std::shared_ptr<const Surface>> surfaces(const std::vector<LoadedVolume>& volumes) {
  std::vector<std::shared_ptr<const Surface>> out;
  for (const auto& v : volumes) out.push_back(v.surface);
  return out;
}

std::vector<BodySkeleton> skeletons(const model::Case& c, const std::vector<LoadedVolume>& volumes) {
  std::vector<BodySkeleton> out(volumes.size());
  for (const model::BodyPair& p : model::body_pairs(c))
    if (out[p.a].points.empty() && out[p.a].edges.empty())
      out[p.a] = body_skeleton(c.volumes[p.a], *volumes[p.a].facets, volumes[p.a].active);
  for (const model::BodyPair& p : model::body_pairs(c))
    for (const size_t v : {p.a, p.b}) {
      const auto& shape = c.volumes[v].shape;
      if (!p.hides || !out[v].faces.empty() || (shape && std::holds_alternative<PlaneShape>(*shape)))
        continue;
      watch_faces(*volumes[v].facets, volumes[v].active, out[v]);
    }
  return out;
}

std::vector<io::VolumeMesh> volume_meshes(const model::Case& c, const std::vector<LoadedVolume>& volumes) {
  std::vector<io::VolumeMesh> out;
  for (size_t i = 0; i < volumes.size(); ++i) {
    const MeshView& m = *volumes[i].facets;
    out.push_back({volumes[i].name,
                   c.body_index(c.volumes[i].body),
                   m.vertices,
                   m.triangles,
                   {volumes[i].active.begin(), volumes[i].active.end()},
                   volumes[i].facets});
  }
  return out;
}

}  // namespace hawser::app
