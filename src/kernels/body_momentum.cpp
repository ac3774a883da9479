// Momenta of a rigid body over a step: forces, exact matrices, and state for the next step.
#include "hawser/kernels/body_momentum.hpp"

#include "hawser/kernels/coupled_mass.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

Vec6 rates_in_body(const RigidBodyState& s) {
  Vec6 rates;
  rates << s.q.conjugate() * s.v, s.w;
  return rates;
}

// Force and moment about a point at the distance d.
Wrench about(const Wrench& of, const Vec3& d) {
  Wrench out = of;
  out.tail<3>() -= d.cross(of.head<3>());
  return out;
}

}  // namespace

Mat6 momentum_matrix(const RigidBodyData& body) { return rigid_mass(body.mass, body.inertia) + body.coupled; }

RigidBodyData without_momentum(const RigidBodyData& body) {
  RigidBodyData out = body;
  out.mass = 0;
  out.inertia.setZero();
  out.coupled.setZero();
  return out;
}

Wrench body_momentum(const Mat6& N, const RigidBodyState& s) {
  const Vec6 momentum = N * rates_in_body(s);
  Wrench out;
  out << s.q * momentum.head<3>(), s.q * momentum.tail<3>();
  return out;
}

Wrench momentum_rate(const RigidBodyData& body, const RigidBodyState& s) {
  RigidBodyData inertia;
  inertia.mass = body.mass;
  inertia.inertia = body.inertia;
  inertia.coupled = body.coupled;
  const Vec6 f = rigid_body(inertia, s, {}).f();
  Wrench out;
  out << f.head<3>(), s.q * f.tail<3>();
  return out;
}

// With k the weight of the mean divided by h, d the displacement of the centre of mass, and the history part
// (F, M) about its start:
//   f = k (P - P0) + F,   t = R^T [k (L - L0 + d x P0) + M - d x F] = k R^T L + R^T y
//   y = -k L0 + M + d x g,   g = k P0 - F
// because the change of angular momentum about the start is L + d x P - L0, and the moment about the end is
// smaller by d x f.
void add_momentum(const Mat6& N, const MeanWeights& scheme, double h, const RigidBodyState& start,
                  const MomentumForces& from, const RigidBodyState& s, RigidBodyResidual& to) {
  const double k = scheme.weight() / h;
  const Wrench before = body_momentum(N, start);
  const Wrench history = scheme.history(from.q, from.f);
  const Mat3 R = s.q.toRotationMatrix();
  const Mat3 Rt = R.transpose();
  const Vec6 rates = rates_in_body(s);
  const Vec6 momentum = N * rates;
  const Vec3 p = momentum.head<3>();
  const Vec3 g = k * before.head<3>() - history.head<3>();
  const Vec3 y = Rt * (history.tail<3>() - k * before.tail<3>() + Vec3(s.x - start.x).cross(g));
  to.inertia.head<3>() += k * (R * p) - g;
  to.inertia.tail<3>() += k * momentum.tail<3>() + y;

  // dU = U^ phi + R^T dv, d(R p) = R (dp - p^ phi), d(R^T y) = y^ phi - R^T g^ dx, in body axes.
  const Mat3 U = hat(Vec3(rates.head<3>()));
  const Mat3 A = N.topLeftCorner<3, 3>();
  const Mat3 B = N.topRightCorner<3, 3>();
  const Mat3 D = N.bottomRightCorner<3, 3>();
  to.K.topRightCorner<3, 3>() += k * R * (A * U - hat(p));
  to.K.bottomLeftCorner<3, 3>() -= Rt * hat(g);
  to.K.bottomRightCorner<3, 3>() += k * B.transpose() * U + hat(y);
  to.C.topLeftCorner<3, 3>() += k * R * A * Rt;
  to.C.topRightCorner<3, 3>() += k * R * B;
  to.C.bottomLeftCorner<3, 3>() += k * B.transpose() * Rt;
  to.C.bottomRightCorner<3, 3>() += k * D;
}

void advance_momentum(const Mat6& N, const MeanWeights& scheme, double h, const RigidBodyState& start,
                      const RigidBodyState& s, MomentumForces& forces) {
  const Vec3 d = s.x - start.x;
  const Wrench end = about(body_momentum(N, s), -d);
  scheme.advance(Wrench((end - body_momentum(N, start)) / h), forces.q, forces.f);
  forces.q = about(forces.q, d);
  forces.f = about(forces.f, d);
}

}  // namespace hawser
