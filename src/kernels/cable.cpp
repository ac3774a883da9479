#include "hawser/kernels/cable.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

struct Local {
  Vec3 t, dv;  // unit chord, v2 - v1
  double l, strain, rate, tension;
  StiffnessTable::Value axial;  // of the strain
  bool damped;                  // the damping acts: taut, and tension not cut off at zero
};

Local local(const CableSection& s, const CableEnds& e) {
  Local o;
  const Vec3 d = e.x2 - e.x1;
  o.l = d.norm();
  o.t = d / o.l;
  o.strain = (o.l - s.length) / s.length;
  o.dv = e.v2 - e.v1;
  o.rate = o.t.dot(o.dv) / s.length;
  o.tension = 0;
  o.damped = false;
  if (o.strain > 0) {
    o.axial = s.axial(o.strain);
    const double full = o.axial.force + s.EA * s.beta * o.rate;
    o.damped = s.beta > 0 && full > 0;
    o.tension = std::max(full, 0.0);
  }
  return o;
}

void spread(const Mat3& k, double* out) {
  Eigen::Map<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> K(out);
  K.topLeftCorner<3, 3>() = k, K.bottomRightCorner<3, 3>() = k;
  K.topRightCorner<3, 3>() = -k, K.bottomLeftCorner<3, 3>() = -k;
}

void pull(const Vec3& t, double* f) {
  for (int i = 0; i < 3; ++i) f[i] = -t[i], f[3 + i] = t[i];
}

}  // namespace

void cable_force(const CableSection& s, const CableEnds& e, double* f) {
  const Local o = local(s, e);
  pull(o.tension * o.t, f);
}

void cable_tangent(const CableSection& s, const CableEnds& e, bool convex, double* f, double* K, double* C) {
  const Local o = local(s, e);
  pull(o.tension * o.t, f);
  const bool taut = o.tension > 0;
  const double ea = s.EA / s.length, g = o.tension / o.l;
  const double stiff = taut ? o.axial.slope / s.length : ea;
  Mat3 k = g * (Mat3::Identity() - o.t * o.t.transpose());
  if (taut || convex) k.noalias() += stiff * o.t * o.t.transpose();
  // rate = t.dv/L turns with the chord: its gradient is (dv - t (t.dv))/(l L)
  if (o.damped) k.noalias() += (ea * s.beta / o.l) * o.t * (o.dv - o.t * o.t.dot(o.dv)).transpose();
  spread(k, K);
  if (s.beta > 0 && C) spread((o.damped ? ea * s.beta : 0.0) * o.t * o.t.transpose(), C);
}

CableStress cable_stress(const CableSection& s, const CableEnds& e) {
  const Local o = local(s, e);
  CableStress out;
  out.tension = o.tension;
  if (o.strain > 0) {
    out.strain_energy = s.length * o.axial.energy;
    out.dissipation = (o.tension - o.axial.force) * o.rate * s.length;
  }
  return out;
}

}  // namespace hawser
