// The class Bodies: poses from prescribed motion, from the state of a body's own node or from the line it
// rides on, and their exchange between ranks. Ends of lines on bodies are in system/tied_nodes.hpp.
#include "hawser/terms/bodies.hpp"

#include "hawser/base/mpi.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/terms/rigid_bodies.hpp"

namespace hawser {
namespace {

constexpr size_t kPose = 13;  // doubles of a pose and its rates

}  // namespace

Bodies::Bodies(const std::vector<model::Body>& bodies) {
  motions_.reserve(bodies.size());
  for (const model::Body& b : bodies) motions_.push_back(model::rigid_motion(b));
}

void Bodies::in_state(const model::Case& c, const LocalMesh& mesh) {
  mesh_ = &mesh;
  if (!mesh.mesh->has_frames()) return;
  frames_.assign(c.bodies.size(), {});
  for (size_t b = 0; b < c.bodies.size(); ++b) {
    Frame& f = frames_[b];
    f.node = mesh.mesh->frame_node(static_cast<int>(b));
    f.exchanged = pose(static_cast<int>(b), 0.0);
    if (c.bodies[b].mass) f.centre = c.bodies[b].mass->centre;
    if (!c.bodies[b].ride || c.bodies[b].ride->placed_in_space) continue;
    f.turn = exp_so3(c.bodies[b].rotation);
    f.centre = -(f.turn.conjugate() * c.bodies[b].position);
  }
}

void Bodies::fix_placed_in_space(MPI_Comm comm, const model::Case& c, const Kinematics& start) {
  std::vector<size_t> placed;
  for (size_t b = 0; b < frames_.size(); ++b)
    if (c.bodies[b].ride && c.bodies[b].ride->placed_in_space) placed.push_back(b);
  if (placed.empty()) return;
  // Only the rank that owns the node contributes; other ranks may need the result later.
  std::vector<double> places(7 * placed.size(), 0);
  for (size_t i = 0; i < placed.size(); ++i) {
    const int body = static_cast<int>(placed[i]);
    const int node = local_node(body);
    if (!mesh_->owns(node)) continue;
    const RigidBodyState s = floating_state(start, node);
    const RigidPose p = pose(body, 0.0);
    const Vec3 centre = p.rotation.conjugate() * (s.x - p.position);
    const Quat turn = s.q.conjugate() * p.rotation;
    std::copy(centre.begin(), centre.end(), &places[7 * i]);
    std::copy_n(turn.coeffs().data(), 4, &places[7 * i + 3]);
  }
  all_reduce(comm, MPI_SUM, places);
  for (size_t i = 0; i < placed.size(); ++i) {
    Frame& f = frames_[placed[i]];
    f.centre = Vec3(&places[7 * i]);
    f.turn.coeffs() = Eigen::Map<const Eigen::Vector4d>(&places[7 * i + 3]);
  }
}

RigidPose Bodies::pose(int body, const Kinematics& state) const {
  if (!floats(body)) return pose(body, state.time);
  const Frame& f = frames_[body];
  const int node = local_node(body);
  if (node < 0) return f.exchanged;
  RigidBodyState s = floating_state(state, node);
  s.q = s.q * f.turn;
  s.w = f.turn.conjugate() * s.w;
  s.alpha = f.turn.conjugate() * s.alpha;
  return floating_pose(s, f.centre);
}

void Bodies::exchange_poses(MPI_Comm comm, const Kinematics& state) const {
  std::vector<double> packed;
  for (size_t b = 0; b < frames_.size(); ++b) {
    if (frames_[b].node < 0) continue;
    const int node = local_node(static_cast<int>(b));
    packed.resize(packed.size() + kPose, 0);
    if (!mesh_->owns(node)) continue;
    const RigidPose p = pose(static_cast<int>(b), state);
    double* d = packed.data() + packed.size() - kPose;
    for (int c = 0; c < 3; ++c) {
      d[c] = p.position[c];
      d[3 + c] = p.velocity[c];
      d[6 + c] = p.angular_velocity[c];
    }
    for (int c = 0; c < 4; ++c) d[9 + c] = p.rotation.coeffs()[c];
  }
  if (packed.empty()) return;
  all_reduce(comm, MPI_SUM, packed);
  const double* d = packed.data();
  for (const Frame& f : frames_) {
    if (f.node < 0) continue;
    f.exchanged.position = Vec3(d);
    f.exchanged.velocity = Vec3(d + 3);
    f.exchanged.angular_velocity = Vec3(d + 6);
    f.exchanged.rotation.coeffs() = Eigen::Map<const Eigen::Vector4d>(d + 9);
    d += kPose;
  }
}

}  // namespace hawser
