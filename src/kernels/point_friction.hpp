// Trial slip and friction of a point of a line against a volume or the seabed. Memory is slip and
// peak of the normal force in ContactStart: BedContact::start() for the bed, LineVolumeFinder::start() for
// volumes. Both are templates of the scalar, for derivatives by the point and along the line. The law is in
// friction_law.hpp.
#pragma once

#include "hawser/kernels/surface_contact_law.hpp"

namespace hawser {

// The quantities of a ContactTrial in the scalar S, and the normal force `force` [N].
template <class S>
struct PointState {
  S gap, force;
  double lever = 0, step = 0;
  // turn: rad, the rotation since the start of the step, which moves the surface at the arm -lever normal;
  // not set without a lever. velocity: used only if friction depends on it.
  Vector3<S> turn, point, normal, velocity;
};

// Displacement in the tangent plane since the start of the step, or since the point touched in it.
template <class S, class U>
Vector3<S> slip_in_step(const ContactLaw& law, const ContactStartOf<U>& start, const PointState<S>& t) {
  Vector3<S> moved = t.point - start.point.template cast<S>();
  moved -= t.normal * S(t.normal.dot(moved));
  if (t.lever > 0) moved -= t.turn.cross(t.normal) * S(t.lever);
  const double touch = law.normal.smoothing;
  if (start.gap > touch) moved *= S((S(touch) - t.gap) / (S(start.gap) - t.gap));
  return moved;
}

// The trial slip s = s0 + moved, with the slip s0 of the last accepted state turned from its normal to the
// present one (and reduced by an increase of the peak of the normal force), makes the force -k s, limited to
// the friction ellipse: friction() in friction_law.hpp. Sets force, slip and peak; a term keeps slip and peak
// when the step is accepted.
template <class S, class U>
Friction<S> point_friction(const ContactLaw& law, const ContactStartOf<U>& start, const PointState<S>& t) {
  const Vector3<S> moved = slip_in_step(law, start, t);
  const PeakOfForce<S> at = peak_of_force(law.friction, start.peak, t.force);
  const Vector3<S> before = transport_slip(start.slip, start.normal, t.normal) * at.slip_factor;
  const auto act = [&](const auto& mu) -> Friction<S> {
    Friction<S> f;
    if (law.friction.damping > 0 && t.step > 0)
      f = damped_friction(law.friction, mu, t.force, at.peak, before, moved, t.step);
    else
      f = friction(law.friction, mu, t.force, at.peak, Vector3<S>(moved + before), t.normal, start.tangent);
    if (law.friction.stiffens()) f.peak = at.peak;
    return f;
  };
  if (!law.friction.blends()) return act(Coulomb<double>{law.friction.axial, law.friction.lateral});
  const Vector3<S> along = t.velocity - t.normal * S(t.normal.dot(t.velocity));
  return act(coulomb_at<S>(law.friction, along.squaredNorm()));
}

}  // namespace hawser
