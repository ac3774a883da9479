// The class TiedNodes: increments and rates of nodes held in space or by a moving body, and positions,
// rotations and rates of nodes tied to a rigid frame.
#include "hawser/system/tied_nodes.hpp"

#include "hawser/kernels/frame_point.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

// Poses of bodies at one time. Consecutive nodes are often tied to the same body, which is then evaluated
// once.
class Poses {
 public:
  Poses(const BodyMotion& motion, double t) : motion_(motion), t_(t) {}

  // Body -1: fixed in space.
  const RigidPose& of(int body) {
    static const RigidPose kInSpace{};
    if (body < 0) return kInSpace;
    if (body != body_) pose_ = motion_(body, t_);
    body_ = body;
    return pose_;
  }

 private:
  const BodyMotion& motion_;
  double t_;
  int body_ = -1;
  RigidPose pose_;
};

}  // namespace

TiedNodes::TiedNodes(const LocalMesh& mesh, std::vector<TiedNode> nodes, BodyMotion motion)
    : mesh_(&mesh), nodes_(std::move(nodes)), motion_(std::move(motion)) {
  held_.assign(mesh.blocks(), 0);
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const TiedNode& s = nodes_[i];
    if (s.frame >= 0) to_frames_.push_back(static_cast<int>(i));
    const size_t b = mesh.block[s.node];
    held_[b] |= s.position_mask;
    if (mesh.rotates(s.node)) held_[b + 1] |= s.rotation_mask;
  }
}

void TiedNodes::increments(const State& from, double t, double* u) const {
  Poses poses(motion_, t);
  for (const TiedNode& s : nodes_) {
    const size_t n = s.node;
    double* p = u + 3 * mesh_->block[n];
    const RigidPose& b = poses.of(s.body);
    const bool tied = s.frame >= 0;  // move_with_frames() moves it
    const Vec3 move = b.to_space(s.at) - from.x[n];
    for (int c = 0; c < 3; ++c)
      if (s.position_mask >> c & 1) p[c] = s.position_mask == 7 && !tied ? move[c] : 0;
    if (!mesh_->rotates(s.node)) continue;
    const Vec3 turn = s.rotation_mask == 7 && !tied
                          ? log_so3(from.q[n].conjugate() * (b.rotation * s.rotation))
                          : Vec3(0, 0, 0);
    for (int c = 0; c < 3; ++c)
      if (s.rotation_mask >> c & 1) p[3 + c] = turn[c];
  }
}

void TiedNodes::rates(double t, State& out) const {
  Poses poses(motion_, t);
  for (const TiedNode& s : nodes_) {
    const size_t n = s.node;
    const RigidPose& b = poses.of(s.body);
    if (s.frame >= 0) {  // move_with_frames() moves it; a single held component of rotation has no rate
      for (int c = 0; c < 3; ++c)
        if (s.rotation_mask != 7 && s.rotation_mask >> c & 1) out.w[n][c] = out.alpha[n][c] = 0;
      continue;
    }
    const Vec3 x = b.to_space(s.at);
    const Vec3 v = b.velocity_at(x);
    const Vec3 a = b.acceleration_at(x);
    for (int c = 0; c < 3; ++c)
      if (s.position_mask >> c & 1) {
        out.v[n][c] = s.position_mask == 7 ? v[c] : 0;
        out.a[n][c] = s.position_mask == 7 ? a[c] : 0;
      }
    if (!mesh_->rotates(s.node)) continue;
    // Rates of a rotation that follows the body, in the node's material axes.
    const Quat inv = (b.rotation * s.rotation).conjugate();
    const Vec3 w = inv * b.angular_velocity;
    const Vec3 al = inv * b.angular_acceleration;
    for (int c = 0; c < 3; ++c)
      if (s.rotation_mask >> c & 1) {
        out.w[n][c] = s.rotation_mask == 7 ? w[c] : 0;
        out.alpha[n][c] = s.rotation_mask == 7 ? al[c] : 0;
      }
  }
}

void TiedNodes::move_with_frames(State& out) const {
  for (const int i : to_frames_) {
    const TiedNode& s = nodes_[i];
    const size_t n = s.node;
    const size_t f = s.frame;
    const Mat3 D =
        out.directors.empty() ? director_acceleration(out.q[f], out.w[f], out.alpha[f]) : out.directors[f];
    if (s.position_mask == 7) {
      const FramePoint p{s.at, out.q[f].toRotationMatrix(), out.w[f]};
      out.x[n] = out.x[f] + p.arm();
      out.v[n] = out.v[f] + p.velocity();
      out.a[n] = out.a[f] + D * s.at;
    }
    if (s.rotation_mask != 7 || !mesh_->rotates(s.node)) continue;
    const Quat back = s.rotation.conjugate();
    out.q[n] = (out.q[f] * s.rotation).normalized();
    out.w[n] = back * out.w[f];
    out.alpha[n] = back * out.alpha[f];
    if (!out.directors.empty()) out.directors[n] = D * s.rotation.toRotationMatrix();
  }
}

}  // namespace hawser
