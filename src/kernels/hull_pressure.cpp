// Pressure of the water on the wetted part of a surface of triangles, with its exact tangent and potential.
#include "hawser/kernels/hull_pressure.hpp"

#include <algorithm>

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

// J of the corner i of a triangle that the line s = 0 cuts off: the triangle of the corner and the points at
// the shares a and b of the edges to the corners j and k. Over a triangle of the corners p_k, of the share A
// of the area, the mean of lambda lambda' is A/12 (sum_k p_k sum_k p_k' + sum_k p_k p_k').
Mat3 corner_moments(const Vec3& s, int i) {
  const int j = (i + 1) % 3;
  const int k = (i + 2) % 3;
  const double a = s[i] / (s[i] - s[j]);
  const double b = s[i] / (s[i] - s[k]);
  Mat3 p = Mat3::Zero();  // corners by columns
  p(i, 0) = 1;
  p(i, 1) = 1 - a;
  p(j, 1) = a;
  p(i, 2) = 1 - b;
  p(k, 2) = b;
  const Vec3 sum = p.rowwise().sum();
  return a * b / 12 * (sum * sum.transpose() + p * p.transpose());
}

Mat3 wet_moments(const Vec3& s) {
  const Mat3 whole = (Mat3::Ones() + Mat3::Identity()) / 12;
  const int wet = static_cast<int>((s.array() > 0).count());
  if (wet == 3) return whole;
  for (int i = 0; i < 3; ++i) {
    if (wet == 1 && s[i] > 0) return corner_moments(s, i);
    if (wet == 2 && !(s[i] > 0)) return whole - corner_moments(s, i);
  }
  return Mat3::Zero();
}

// Heads of the corners, of which the upward vertical in body axes is n.
std::vector<double> corner_heads(const HullSurface& hull, double level, std::span<const double> heads,
                                 const RigidBodyState& s, const Vec3& n) {
  std::vector<double> out(hull.corners.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = level - s.x.z() - n.dot(hull.corners[i]) + (heads.empty() ? 0 : heads[i]);
  return out;
}

// Calls visit(corners y by columns, area vector, heads, J) for the triangles that the water wets.
template <class Visit>
void for_each_wet(const HullSurface& hull, const std::vector<double>& heads, const Visit& visit) {
  for (const std::array<int, 3>& t : hull.triangles) {
    const Vec3 s(heads[t[0]], heads[t[1]], heads[t[2]]);
    if (!(s.maxCoeff() > 0)) continue;
    Mat3 y;
    y << hull.corners[t[0]], hull.corners[t[1]], hull.corners[t[2]];
    const Vec3 area = 0.5 * (y.col(1) - y.col(0)).cross(y.col(2) - y.col(0));
    visit(y, area, s, wet_moments(s));
  }
}

}  // namespace

// With n = R'e_z, dn = n x theta and so ds_i = -(dz + (y_i x n).theta), in body axes:
//   f = rho g sum N 1'J s,         df = rho g sum N 1'J ds, turned by R:  d(R F) = R dF - R F^ theta
//   t = rho g sum_i (J s)_i y_i x N,   dt = rho g sum_i (J ds)_i y_i x N
HullPressure hull_pressure(const HullSurface& hull, double weight_density, double level,
                           std::span<const double> heads, const RigidBodyState& s, bool tangent) {
  const Mat3 R = s.q.toRotationMatrix();
  const Vec3 n = R.row(2).transpose();
  Vec3 force = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
  double potential = 0;
  using Wrench = Eigen::Matrix<double, 6, 3>;
  using Slope = Eigen::Matrix<double, 3, 4>;
  Eigen::Matrix<double, 6, 4> by_pose = Eigen::Matrix<double, 6, 4>::Zero();  // by z and theta, body axes
  const std::vector<double> all = corner_heads(hull, level, heads, s, n);
  for_each_wet(hull, all, [&](const Mat3& y, const Vec3& area, const Vec3& head, const Mat3& J) {
    const Vec3 mean = J * head;
    force += mean.sum() * area;
    moment += (y * mean).cross(area);
    potential -= 0.5 * n.dot(area) * head.dot(mean);
    if (!tangent) return;
    Wrench by_mean;
    Slope by;
    for (int i = 0; i < 3; ++i) {
      by_mean.col(i) << area, y.col(i).cross(area);
      by.row(i) << -1, -y.col(i).cross(n).transpose();
    }
    by_pose += by_mean * (J * by);
  });
  HullPressure out;
  out.f << weight_density * (R * force), weight_density * moment;
  out.potential = weight_density * potential;
  if (!tangent) return out;
  out.K.block<3, 1>(0, 2) = R * by_pose.block<3, 1>(0, 0);
  out.K.block<3, 3>(0, 3) = R * (by_pose.block<3, 3>(0, 1) - hat(force));
  out.K.block<3, 1>(3, 2) = by_pose.block<3, 1>(3, 0);
  out.K.block<3, 3>(3, 3) = by_pose.block<3, 3>(3, 1);
  out.K *= weight_density;
  return out;
}

Vec3 displaced_volumes(const HullSurface& hull, double level, const RigidBodyState& s) {
  const Mat3 R = s.q.toRotationMatrix();
  const std::vector<double> heads = corner_heads(hull, level, {}, s, R.row(2).transpose());
  Vec3 out = Vec3::Zero();
  for_each_wet(hull, heads, [&](const Mat3& y, const Vec3& area, const Vec3& head, const Mat3& J) {
    const Vec3 share = J * Vec3::Ones();  // means of lambda over the wet part
    const Vec3 from_level(0, 0, level - s.x.z());
    // z counts from the level, so that the waterplane has no flux.
    const Vec3 flux = (R * y - from_level.replicate<1, 3>()) * share;
    out += flux.cwiseProduct(R * area);
    (void)head;
  });
  return out;
}

}  // namespace hawser
