#include "hawser/kernels/body_contact.hpp"

#include "hawser/math/so3.hpp"

namespace hawser {

BodyContactPoint body_contact(const BodyFrame& A, const Vec3& y, double radius, const BodyFrame& B,
                              const SurfacePoint& s, const NormalLaw& law, double weight, bool tangent,
                              BodyContact& sum) {
  const Vec3& nB = s.normal;
  const Vec3 z = B.to_body(A.to_space(y)), n = B.R * nB, nA = A.R.transpose() * n;
  Vec12 G;  // dg/dq
  G.segment<3>(0) = n, G.segment<3>(3) = y.cross(nA);
  G.segment<3>(6) = -n, G.segment<3>(9) = nB.cross(z);
  Vec12 rates;
  rates.segment<3>(0) = A.v, rates.segment<3>(3) = A.w;
  rates.segment<3>(6) = B.v, rates.segment<3>(9) = B.w;
  BodyContactPoint out;
  out.gap = s.distance - radius;
  out.rate = G.dot(rates);
  out.normal = n;
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
