// Water pressure on the wetted part of a triangulated surface, with exact tangent and potential.
#include "hawser/kernels/hull_pressure.hpp"

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

// J of the part of a triangle at its corner i that the line s = 0 cuts off: the triangle of this corner and
// the points at the fractions a and b of the edges to the corners j and k. Over a triangle with the corners
// p_k and the fraction A of the area, the integral of lambda lambda' divided by the full area is A/12 (sum_k
// p_k sum_k p_k' + sum_k p_k p_k').
Mat3 corner_moments(const Vec3& s, int i) {
  const int j = (i + 1) % 3;
  const int k = (i + 2) % 3;
  const double a = s[i] / (s[i] - s[j]);
  const double b = s[i] / (s[i] - s[k]);
  Mat3 p = Mat3::Zero();  // corners in columns
  p(i, 0) = 1;
  p(i, 1) = 1 - a;
  p(j, 1) = a;
  p(i, 2) = 1 - b;
  p(k, 2) = b;
  const Vec3 sum = p.rowwise().sum();
  return a * b / 12 * (sum * sum.transpose() + p * p.transpose());
}

// J of a partly wet triangle.
Mat3 partly_wet_moments(const Vec3& s) {
  const bool one = (s.array() > 0).count() == 1;
  int i = 0;  // corner that differs from the other two
  while ((s[i] > 0) != one) ++i;
  const Mat3 corner = corner_moments(s, i);
  if (one) return corner;
  return (Mat3::Ones() + Mat3::Identity()) / 12 - corner;
}

// J times rows by corner; for a fully wet triangle (sum + each)/12.
template <class Rows>
Rows mean_by_corner(const Mat3* J, const Rows& rows) {
  if (J) return *J * rows;
  return (rows.colwise().sum().replicate(3, 1) + rows) / 12;
}

// Pressure heads at the corners; n: upward vertical in body axes.
std::vector<double> corner_heads(const HullSurface& hull, double level, std::span<const double> heads,
                                 const RigidBodyState& s, const Vec3& n) {
  std::vector<double> out(hull.corners.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = level - s.x.z() - n.dot(hull.corners[i]) + (heads.empty() ? 0 : heads[i]);
  return out;
}

// Calls visit(corners y in columns, area vector, heads, J) for the wet triangles; J: null if fully wet.
template <class Visit>
void for_each_wet(const HullSurface& hull, const std::vector<double>& heads, const Visit& visit) {
  for (std::size_t t = 0; t < hull.triangles.size(); ++t) {
    const std::array<int, 3>& c = hull.triangles[t];
    const Vec3 s(heads[c[0]], heads[c[1]], heads[c[2]]);
    if (!(s.maxCoeff() > 0)) continue;
    Mat3 y;
    y << hull.corners[c[0]], hull.corners[c[1]], hull.corners[c[2]];
    if (s.minCoeff() > 0) {
      visit(y, hull.areas[t], s, nullptr);
    } else {
      const Mat3 J = partly_wet_moments(s);
      visit(y, hull.areas[t], s, &J);
    }
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
  for_each_wet(hull, all, [&](const Mat3& y, const Vec3& area, const Vec3& head, const Mat3* J) {
    const Vec3 mean = mean_by_corner(J, head);
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
    by_pose += by_mean * mean_by_corner(J, by);
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
  for_each_wet(hull, heads, [&](const Mat3& y, const Vec3& area, const Vec3&, const Mat3* J) {
    const Vec3 mean_lambda = mean_by_corner(J, Vec3(Vec3::Ones()));  // over the wet part, per area
    const Vec3 from_level(0, 0, level - s.x.z());
    // z is relative to the level, so that the waterplane has no flux.
    const Vec3 flux = (R * y - from_level.replicate<1, 3>()) * mean_lambda;
    out += flux.cwiseProduct(R * area);
  });
  return out;
}

}  // namespace hawser
