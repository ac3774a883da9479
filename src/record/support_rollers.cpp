// Intersection of a line with the plane of a box by bisection along an element, and roller forces summed over
// the ranks.
#include "hawser/record/support_rollers.hpp"

#include <algorithm>
#include <limits>

#include "hawser/base/mpi.hpp"
#include "hawser/terms/element_axis.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser::record {
namespace {

constexpr int kHalvings = 40;

// Parameter, 0 to 1, at which an element crosses the plane through `at` normal to `along`.
double on_plane(const AxisShape& shape, const Vec3& at, const Vec3& along) {
  double low = 0, high = 1;
  const bool increasing = (shape.point(1) - at).dot(along) > 0;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (low + high);
    (((shape.point(middle) - at).dot(along) > 0) == increasing ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

std::vector<SupportCrossing> support_crossings(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
                                               const Kinematics& state, const std::vector<RigidPose>& poses) {
  const double far = std::numeric_limits<double>::max();
  struct Nearest {
    double distance;  // m, from the middle of the box
    SupportCrossing at;
  };
  std::vector<Nearest> nearest;
  for (size_t k = 0; k < c.supports.size(); ++k) {
    const model::SupportBox& b = c.supports[k];
    const int body = c.body_index(b.body);
    const int line = c.line_index(b.line);
    const RigidPose pose = body < 0 ? RigidPose{} : poses[body];
    const Vec3 place = pose.to_space(b.at);
    const Vec3 along = pose.rotation * b.along;
    Nearest best{far, {}};
    for (const LocalElement& e : mesh.elements) {
      const Element& g = mesh.element(e);
      if (!e.counted || g.line != line) continue;
      const Vec3& x1 = state.x[e.first];
      const Vec3& x2 = state.x[e.second];
      if (((x1 - place).dot(along) > 0) == ((x2 - place).dot(along) > 0)) continue;
      const AxisShape shape(element_axis(state, g, e.first, e.second));
      const double xi = on_plane(shape, place, along);
      const Vec3 x = shape.point(xi) - place;
      if (!(x.norm() < best.distance)) continue;
      best = {x.norm(),
              {true, x.dot(pose.rotation * b.left()), x.dot(pose.rotation * b.up),
               mesh.mesh->node(g.first).arc + xi * g.length}};
    }
    nearest.push_back(best);
  }
  largest_of_ranks(comm, nearest, [](const Nearest& n) { return -n.distance; });
  std::vector<SupportCrossing> out;
  for (const Nearest& n : nearest) out.push_back(n.at);
  return out;
}

SupportRollers::SupportRollers(const Subject& subject)
    : subject_(subject), contact_(subject.term<LineVolumeContact>()) {
  const model::Case& c = subject_.model;
  for (const model::SupportBox& b : c.supports) {
    int v = 0;
    while (contact_->volume_name(v) != c.volumes[b.first].name) ++v;
    first_.push_back(v);
  }
}

std::vector<Vec3> SupportRollers::forces(const Kinematics& state) const {
  return contact_->forces_by_volume(state);
}

std::vector<SupportCrossing> SupportRollers::crossings(const Snapshot& s) const {
  std::vector<RigidPose> frames;
  for (const io::BodyPose& p : s.poses()) {
    RigidPose& frame = frames.emplace_back();
    frame.position = p.position;
    frame.rotation = p.rotation;
  }
  return support_crossings(subject_.comm(), subject_.model, subject_.local(), s.at, frames);
}

std::vector<std::array<double, 2>> SupportRollers::carrying(const Snapshot& s) const {
  const model::Case& c = subject_.model;
  const std::vector<SupportCrossing> crosses = crossings(s);
  std::vector<Vec3> on_line = forces(s.at);
  MPI_Allreduce(MPI_IN_PLACE, on_line.data(), 3 * static_cast<int>(on_line.size()), MPI_DOUBLE, MPI_SUM,
                subject_.comm());
  std::vector<std::array<double, 2>> out(c.lines.size(), {HUGE_VAL, -HUGE_VAL});
  for (size_t k = 0; k < c.supports.size(); ++k) {
    const model::SupportBox& b = c.supports[k];
    const auto first = on_line.begin() + static_cast<std::ptrdiff_t>(first_[k]);
    if (!crosses[k].known ||
        std::all_of(first, first + std::ssize(b.rollers), [](const Vec3& f) { return f == Vec3::Zero(); }))
      continue;
    auto& [from, to] = out[c.line_index(b.line)];
    from = std::min(from, crosses[k].arc);
    to = std::max(to, crosses[k].arc);
  }
  return out;
}

}  // namespace hawser::record
