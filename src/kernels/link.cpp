// Tension of a spring and a damper, linear or from tables, with or without slack, and its force and exact
// tangent between two points.
#include "hawser/kernels/link.hpp"

#include <algorithm>

namespace hawser {
namespace {

struct Spring {
  double force = 0, slope = 0, energy = 0;
};

Spring spring(const LinkLaw& law, double elongation) {
  if (!law.spring)
    return {law.stiffness * elongation, law.stiffness, 0.5 * law.stiffness * elongation * elongation};
  const MonotoneCubic::Value v = law.spring->at(elongation);
  // The integral starts at the first row; below it a link goes slack where the linear continuation is zero.
  double zero = law.spring->at(0).integral;
  if (law.tension_only) {
    const double first = law.spring->rows().front().first;
    const MonotoneCubic::Value first_row = law.spring->at(first);
    zero = -0.5 * first_row.y * first_row.y / first_row.slope;
  }
  return {v.y, v.slope, v.integral - zero};
}

}  // namespace

// T = S(e) + D(s), e = l - l0; if it can go slack T = max(0, S(e) + D(s)) (docs/theory/links.md).
LinkTension link_tension(const LinkLaw& law, double length, double speed) {
  const Spring s = spring(law, length - law.rest_length);
  double damper = law.damping * speed;
  double slope = law.damping;
  if (law.damper) {
    const ResponseCurve::Value v = law.damper->at(speed);
    damper = v.force;
    slope = v.slope;
  }
  LinkTension t{s.force + damper, s.slope, slope, s.energy, damper * speed};
  if (!law.tension_only) return t;
  if (t.tension <= 0) t.tension = t.by_length = t.by_speed = 0;
  if (s.force <= 0) t.energy = 0;
  t.dissipated = (t.tension - std::max(s.force, 0.0)) * speed;
  return t;
}

//   d(T n)/dd = S' n n' + T/l (I - n n') + D'/l n (w - s n)',   d(T n)/dw = D' n n'
LinkForce link_force(const LinkLaw& law, const Vec3& d, const Vec3& w, bool convex) {
  constexpr double kNothing = 1e-12;  // m
  LinkForce f;
  f.length = d.norm();
  const bool meet = f.length < kNothing;
  const Vec3 n = meet ? Vec3(Vec3::Zero()) : Vec3(d / f.length);
  f.speed = n.dot(w);
  f.along = link_tension(law, f.length, f.speed);
  const LinkTension& t = f.along;
  if (meet) {
    f.by_place = t.by_length * Mat3::Identity();
    return f;
  }
  f.pull = t.tension * n;
  const Mat3 along = n * n.transpose();
  const double across = convex ? std::max(t.tension, 0.0) : t.tension;
  f.by_place = t.by_length * along + across / f.length * (Mat3::Identity() - along);
  if (!convex) f.by_place += t.by_speed / f.length * n * (w - f.speed * n).transpose();
  f.by_rate = t.by_speed * along;
  return f;
}

}  // namespace hawser
