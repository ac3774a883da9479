// Points and directions that are fixed to a node, a body or space: where they are, and the exact force and
// tangent of what acts between two of them (links, end springs). Ends of lines on bodies:
// system/tied_nodes.hpp.
#include "hawser/terms/between_points.hpp"

#include <algorithm>
#include <array>

#include "hawser/math/so3.hpp"

namespace hawser {

AttachedNow attached_now(const Attached& a, const Kinematics& at, const LocalMesh& mesh,
                         const Bodies& bodies) {
  AttachedNow now;
  const int carrier = a.carrier(bodies);
  if (carrier < 0) {
    const RigidPose p = bodies.pose(a.body, at.time);
    now.x = a.direction ? p.rotation * a.at : p.to_space(a.at);
    now.v = a.direction ? p.angular_velocity.cross(now.x) : p.velocity_at(now.x);
    return now;
  }
  const int local = mesh.find(carrier);
  now.R = at.q[local].toRotationMatrix();
  now.arm = a.body < 0 ? a.at : bodies.in_node_axes(a.body, a.at, a.direction);
  now.rate = at.w[local].cross(now.arm);
  now.x = now.R * now.arm;
  now.v = now.R * now.rate;
  if (!now.arm.isZero(0) && mesh.rotates(local)) now.turn = mesh.block[local] + 1;
  if (a.direction) return now;
  now.place = mesh.block[local];
  now.x += at.x[local];
  now.v += at.v[local];
  return now;
}

void add_between(Assembler& assembler, const AttachedNow& a, const AttachedNow& b, const Vec6& f,
                 const Mat6& k, const Mat6& c) {
  constexpr int kMost = 12;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMost, kMost>;
  using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, kMost>;
  std::array<int, 4> blocks{};
  size_t count = 0;
  Columns P = Columns::Zero(6, kMost), V = Columns::Zero(6, kMost);
  Matrix geometric = Matrix::Zero(kMost, kMost);
  for (const auto& [side, row] : {std::pair(&a, 0), std::pair(&b, 3)}) {
    if (side->place >= 0) {
      P.block<3, 3>(row, 3 * static_cast<Eigen::Index>(count)).setIdentity();
      blocks[count++] = side->place;
    }
    if (side->turn < 0) continue;
    const Eigen::Index at = 3 * static_cast<Eigen::Index>(count);
    P.block<3, 3>(row, at) = -side->R * hat(side->arm);
    V.block<3, 3>(row, at) = -side->R * hat(side->rate);
    const Vec3 y = side->arm, g = side->R.transpose() * f.segment<3>(row);
    if (assembler.convex())
      geometric.block<3, 3>(at, at) =
          std::max(-y.dot(g), 0.0) * (Mat3::Identity() - y * y.transpose() / y.squaredNorm());
    else
      geometric.block<3, 3>(at, at) = hat(y) * hat(g);
    blocks[count++] = side->turn;
  }
  if (count == 0) return;
  const Eigen::Index m = 3 * static_cast<Eigen::Index>(count);
  P.conservativeResize(6, m);
  V.conservativeResize(6, m);
  const Eigen::VectorXd force = P.transpose() * f;
  const Matrix K = P.transpose() * (k * P + c * V) + geometric.topLeftCorner(m, m), C = P.transpose() * c * P;
  assembler.add({blocks.data(), count}, force.data(), K.data(), C.data(), nullptr);
}

}  // namespace hawser
