// Normal force of one contact point between two rigid bodies: gap, its gradient by both bodies' unknowns,
// stiffness and damping matrices, and the change along an edge.
#include "hawser/kernels/body_contact.hpp"

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

Vec12 motion(const BodyFrame& A, const BodyFrame& B) {
  Vec12 rates;
  rates.segment<3>(0) = A.v, rates.segment<3>(3) = A.w;
  rates.segment<3>(6) = B.v, rates.segment<3>(9) = B.w;
  return rates;
}

}  // namespace

Vec12 body_gap_gradient(const BodyFrame& A, const Vec3& y, const BodyFrame& B, const SurfacePoint& s) {
  const Vec3 z = B.to_body(A.to_space(y)), n = B.R * s.normal;
  Vec12 G;
  G.segment<3>(0) = n, G.segment<3>(3) = y.cross(A.R.transpose() * n);
  G.segment<3>(6) = -n, G.segment<3>(9) = s.normal.cross(z);
  return G;
}

BodyContactAlong body_contact_along(const BodyFrame& A, const Vec3& y, const Vec3& dy, double radius,
                                    const BodyFrame& B, const SurfacePoint& s, const NormalLaw& law) {
  const Vec12 G = body_gap_gradient(A, y, B, s), rates = motion(A, B);
  const NormalForce f = normal_force(law, s.distance - radius, G.dot(rates));
  BodyContactAlong out;
  if (f.force == 0 && f.by_gap == 0) return out;
  const Vec3 z = B.to_body(A.to_space(y)), along = A.R * dy, dz = B.R.transpose() * along;
  const Vec3 dnB = s.curvature * dz, dn = B.R * dnB;
  Vec12 dG;
  dG.segment<3>(0) = dn;
  dG.segment<3>(3) = dy.cross(A.R.transpose() * (B.R * s.normal)) + y.cross(A.R.transpose() * dn);
  dG.segment<3>(6) = -dn;
  dG.segment<3>(9) = dnB.cross(z) + s.normal.cross(dz);
  out.f = -f.force * G;
  out.slope = -(f.by_gap * s.normal.dot(dz) + f.by_rate * dG.dot(rates)) * G - f.force * dG;
  return out;
}

BodyContactPoint body_contact(const BodyFrame& A, const Vec3& y, double radius, const BodyFrame& B,
                              const SurfacePoint& s, const NormalLaw& law, double weight, bool tangent,
                              BodyContact& sum) {
  const Vec3& nB = s.normal;
  const Vec3 z = B.to_body(A.to_space(y)), n = B.R * nB, nA = A.R.transpose() * n;
  const Vec12 G = body_gap_gradient(A, y, B, s), rates = motion(A, B);
  BodyContactPoint out;
  out.gap = s.distance - radius;
  out.rate = G.dot(rates);
  out.normal = n;
  out.gradient = G;
  out.law = normal_force(law, out.gap, out.rate);
  if (out.law.force == 0 && out.law.by_gap == 0) return out;
  // Energy grows where the gap closes: residual = -force * dg/dq.
  const double F = weight * out.law.force;
  sum.f -= F * G;
  if (!tangent) return out;

  // dz = dz_q dq, and from it the turning normal.
  Eigen::Matrix<double, 3, 12> dz, dnB, dn, dnA;
  dz.middleCols<3>(0) = B.R.transpose();
  dz.middleCols<3>(3) = -B.R.transpose() * A.R * hat(y);
  dz.middleCols<3>(6) = -B.R.transpose();
  dz.middleCols<3>(9) = hat(z);
  dnB = s.curvature * dz;
  dn = B.R * dnB;
  dn.rightCols<3>() -= B.R * hat(nB);
  dnA = A.R.transpose() * dn;
  dnA.middleCols<3>(3) += hat(nA);
  Mat12 dG;
  dG.topRows<3>() = dn;
  dG.middleRows<3>(3) = hat(y) * dnA;
  dG.middleRows<3>(6) = -dn;
  dG.bottomRows<3>() = hat(nB) * dz - hat(z) * dnB;

  const Vec12 dF = weight * (out.law.by_gap * G + out.law.by_rate * (dG.transpose() * rates));
  sum.K -= G * dF.transpose() + F * dG;
  sum.C -= weight * out.law.by_rate * G * G.transpose();
  return out;
}

}  // namespace hawser
