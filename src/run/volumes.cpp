// Surfaces of volumes: exact shapes, or meshes that one rank of a host reads and checks for all; and their
// data for body contact and pictures.
#include "hawser/run/volumes.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "hawser/advice/meshes.hpp"
#include "hawser/advice/run.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/host.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/geometry/primitives.hpp"
#include "hawser/geometry/tested_surface.hpp"
#include "hawser/io/mesh_check.hpp"
#include "hawser/io/shared_on_host.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/body_pairs.hpp"
#include "hawser/model/check.hpp"

namespace hawser::run {
namespace {

// Sets a surface and a view of its triangles.
void set_surface(LoadedVolume& l, const model::Volume& v, std::shared_ptr<const MeshSurface> surface) {
  struct Kept {
    std::shared_ptr<const MeshSurface> surface;
    MeshView view;
  };
  const auto kept = std::make_shared<const Kept>(Kept{surface, surface->mesh()});
  l.facets = {kept, &kept->view};
  l.surface = surface;
  const bool partial = std::find(l.active.begin(), l.active.end(), false) != l.active.end();
  if (v.sign != SignTest::automatic && v.sign != SignTest::pseudonormal)
    l.surface = std::make_shared<TestedSurface>(surface, v.sign, partial);
}

bool same_file(const model::Volume& a, const model::Volume& b) {
  return !a.shape && !b.shape && a.mesh == b.mesh && a.scale == b.scale && a.closed == b.closed;
}

// True if two volumes use one mesh in the same way and can share its data.
bool same_use(const model::Volume& a, const model::Volume& b) {
  const auto same_box = [](const std::optional<model::Box>& x, const std::optional<model::Box>& y) {
    return x.has_value() == y.has_value() && (!x || (x->lower == y->lower && x->upper == y->upper));
  };
  return same_file(a, b) && a.sign == b.sign && a.smooth == b.smooth && a.crease_angle == b.crease_angle &&
         a.basis == b.basis && a.active_part == b.active_part && same_box(a.active_box, b.active_box) &&
         a.body.empty() == b.body.empty();
}
// First volume with the same use of the mesh as volume i.
size_t first_use(const model::Case& c, size_t i) {
  size_t k = 0;
  while (k < i && !same_use(c.volumes[k], c.volumes[i])) ++k;
  return k;
}

// Moving meshes are written at every output because XDMF cannot express motion. This many vertices suffice
// for a picture and take 120 kB per output.
constexpr int kDrawnVertices = 10000;
bool displayed_coarser(const model::Case& c, size_t volume, size_t vertices) {
  return c.output.xdmf && c.body_index(c.volumes[volume].body) >= 0 && vertices > kDrawnVertices;
}

// Reads, checks and builds the meshes of a case, each file once.
class Meshes {
 public:
  Meshes(const model::Case& c, const io::ReadProgress& read_progress)
      : c_(c), read_progress_(read_progress), blunt_(c.volumes.size()) {}

  // Fills in `l` except its surface, which it returns.
  std::shared_ptr<const MeshSurface> make(size_t i, LoadedVolume& l) {
    const model::Volume& v = c_.volumes[i];
    io::LoadedMesh loaded = read(i);
    const io::FitMesh fit = io::check_mesh(c_, v, loaded);
    blunt_[i] = fit.blunt;
    l.active = fit.active;
    l.report = advice::mesh_summary(loaded.report);
    l.notes = std::move(loaded.notes);
    announce(advice::preparing_mesh(std::filesystem::path(v.mesh).filename().string()), v);
    std::shared_ptr<const MeshSurface> surface;
    try {
      surface = std::make_shared<const MeshSurface>(
          std::move(loaded.mesh), l.active, MeshSurfaceOptions{v.smooth, v.crease_angle, loaded.open});
    } catch (const std::invalid_argument& e) {
      c_.refuse("volumes." + v.name + ".mesh", e.what());
    }
    if (surface->internal_facets() > 0)
      l.notes.push_back(v.mesh + ": " + advice::internal_facets(surface->internal_facets()));
    l.report += ' ';
    l.report += v.smooth ? advice::curved_facets(surface->curved(), surface->bulge(), surface->sharp_edges())
                         : advice::flat_facets();
    if (displayed_coarser(c_, i, surface->mesh().vertices.size())) {
      l.report += ' ';
      l.report += advice::displayed_coarser(kDrawnVertices, surface->mesh().vertices.size());
    }
    if (v.sign == SignTest::tetrahedra || v.sign == SignTest::ray || v.sign == SignTest::solid_angle)
      l.notes.push_back(advice::slow_inside_test(surface->mesh().triangles.size()));
    return surface;
  }
  // Replaces make() for a volume that shares the mesh of volume k.
  void copy_bluntness(size_t i, size_t k) { blunt_[i] = blunt_[k]; }
  // To be called after the last volume.
  void check_leaders() const { io::check_leaders(c_, blunt_); }

 private:
  void announce(const std::string& text, const model::Volume& v) const {
    if (read_progress_.busy) read_progress_.busy(text, io::reading_time(v.mesh));
  }
  // A file that a later volume uses as well is kept.
  io::LoadedMesh read(size_t i) {
    const model::Volume& v = c_.volumes[i];
    const auto kept = std::find_if(kept_.begin(), kept_.end(),
                                   [&](const auto& k) { return same_file(c_.volumes[k.first], v); });
    if (kept != kept_.end()) return kept->second;
    announce(io::reading_text(v.mesh), v);
    io::LoadedMesh loaded;
    try {
      loaded = io::read_mesh(v.mesh, v.scale, v.closed);
    } catch (const InputError& e) {
      c_.refuse("volumes." + v.name + ".mesh", e.what());
    }
    for (size_t k = i + 1; k < c_.volumes.size(); ++k)
      if (same_file(c_.volumes[k], v)) {
        kept_.emplace_back(i, loaded);
        break;
      }
    return loaded;
  }

  const model::Case& c_;
  const io::ReadProgress& read_progress_;
  std::vector<bool> blunt_;
  std::vector<std::pair<size_t, io::LoadedMesh>> kept_;  // by the volume it was read for
};

// Broadcasts a text from the leading rank of the host.
void broadcast(MPI_Comm comm, std::string& text) {
  auto n = static_cast<std::uint64_t>(text.size());
  MPI_Bcast(&n, 1, MPI_UINT64_T, 0, comm);
  text.resize(n);
  MPI_Bcast(text.data(), static_cast<int>(n), MPI_CHAR, 0, comm);
}
void broadcast(MPI_Comm comm, LoadedVolume& l) {
  broadcast(comm, l.report);
  auto notes = static_cast<std::uint64_t>(l.notes.size());
  MPI_Bcast(&notes, 1, MPI_UINT64_T, 0, comm);
  l.notes.resize(notes);
  for (std::string& n : l.notes) broadcast(comm, n);
  std::string active(l.active.begin(), l.active.end());
  broadcast(comm, active);
  l.active.assign(active.begin(), active.end());
}

// Range of lines in the frame of a body at t = 0, for the drawn part of a plane: the length of a line around
// one held end, half of it around the middle of two.
Box reach(const model::Case& c, const std::string& body_name) {
  const int b = c.body_index(body_name);
  const model::Body space;
  const model::Body& body = b < 0 ? space : c.bodies[b];
  const Quat turn = exp_so3(body.rotation).conjugate();
  const auto local = [&](const Vec3& x) { return Vec3(turn * (x - body.position)); };
  Box box;
  for (const model::Line& line : c.lines) {
    const double length = model::length_of(line);
    Box line_box;
    for (const Vec3& p : line.points) line_box.add(local(p));
    int held = 0;
    for (const model::End* e : {&line.end_a, &line.end_b})
      if (e->kind != model::EndKind::free) {
        line_box.add(local(model::end_position(c, *e)));
        ++held;
      }
    if (line.points.empty() && held > 0) {
      const Vec3 middle = line_box.centre();
      line_box.add(Box{middle, middle}.grown(held == 1 ? length : 0.5 * length));
    }
    box.add(line_box);
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
  l.report = advice::exact_shape(l.facets->triangles.size());
  return l;
}

}  // namespace

std::vector<LoadedVolume> load_volumes(const model::Case& c, MPI_Comm comm,
                                       const io::ReadProgress& read_progress) {
  const Host host(comm);
  Meshes meshes(c, read_progress);
  std::vector<LoadedVolume> out;
  for (size_t i = 0; i < c.volumes.size(); ++i) {
    const model::Volume& v = c.volumes[i];
    LoadedVolume& l = out.emplace_back();
    if (v.shape) {
      try {
        l = load_shape(c, v);
      } catch (const std::invalid_argument& e) {
        c.refuse("volumes." + v.name + ".shape", e.what());
      }
    } else if (const size_t k = first_use(c, i); k < i) {
      l = out[k];
      meshes.copy_bluntness(i, k);
    } else {
      auto surface = io::shared_on_host(comm, host, [&] { return meshes.make(i, l); });
      broadcast(host.comm(), l);
      set_surface(l, v, std::move(surface));
    }
    l.name = v.name;
  }
  io::rethrow_on_all_ranks(comm, [&] {
    if (host.leads()) meshes.check_leaders();
  });
  return out;
}

std::vector<std::shared_ptr<const Surface>> surfaces(const std::vector<LoadedVolume>& volumes) {
  std::vector<std::shared_ptr<const Surface>> out;
  for (const auto& v : volumes) out.push_back(v.surface);
  return out;
}

std::vector<std::shared_ptr<const MeshView>> volume_facets(const std::vector<LoadedVolume>& volumes) {
  std::vector<std::shared_ptr<const MeshView>> out;
  for (const auto& v : volumes) out.push_back(v.facets);
  return out;
}

namespace {

// Sides of the bounding box in increasing order, m.
Vec3 sides(const Surface& surface) {
  Vec3 out = surface.bounds().extent();
  std::sort(out.data(), out.data() + 3);
  return out;
}

// Sides of the pieces of faces, m, by volume, by the second side of the smallest volume that it can touch. 0:
// no faces.
std::vector<double> face_pieces(const std::vector<model::BodyPair>& pairs, const model::Case& c,
                                const std::vector<LoadedVolume>& volumes) {
  std::vector<double> out(volumes.size(), 0);
  for (const model::BodyPair& p : pairs) {
    if (c.volumes[p.a].is_plane()) continue;
    const double size = sides(*volumes[p.a].surface).z();
    const double other = c.volumes[p.b].is_plane() ? size : sides(*volumes[p.b].surface).y();
    const double piece = face_piece(size, other);
    out[p.a] = out[p.a] > 0 ? std::min(out[p.a], piece) : piece;
  }
  return out;
}

}  // namespace

std::vector<BodySkeleton> skeletons(const model::Case& c, const std::vector<LoadedVolume>& volumes) {
  std::vector<BodySkeleton> out(volumes.size());
  const std::vector<model::BodyPair> pairs = model::body_pairs(c);
  const std::vector<double> pieces = face_pieces(pairs, c, volumes);
  for (const model::BodyPair& p : pairs)
    if (out[p.a].features.empty())
      out[p.a] = body_skeleton(c.volumes[p.a], *volumes[p.a].facets, volumes[p.a].active, pieces[p.a]);
  for (const model::BodyPair& p : pairs)
    for (const size_t v : {p.a, p.b}) {
      if (!p.needs_overlap_check || !out[v].faces.empty() || c.volumes[v].is_plane()) continue;
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
    io::VolumeMesh& v = out.back();
    if (!displayed_coarser(c, i, v.vertices.size())) continue;
    v.coarse = coarse_mesh(v.vertices, v.triangles, kDrawnVertices);
    if (!v.active.empty())
      for (const int t : v.coarse.from) v.coarse_active.push_back(v.active[t]);
  }
  return out;
}

}  // namespace hawser::run
