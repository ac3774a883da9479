// Chord and compliance of one elastic catenary section in closed form, and Newton's method for the end
// tension of a line of several sections.
#include "hawser/kernels/catenary.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hawser {

// T(s) = tension - load s, r' = n T/|T| + T/EA, n = 1 + free strain. With e = load/w and T = tau e + p, tau
// from c to c1 = c - w L, h = |p|:
//   r(L) = n (A p + (|T0| - |T1|)/w e) + (mean tension) L/EA
//   A = ∫ds/|T| = (asinh(c/h) - asinh(c1/h))/w
// Written without the cancellations for w -> 0 or h -> 0.
Vec3 catenary_chord(const Vec3& tension, const Vec3& load, double length, double EA, Mat3* derivative,
                    double free_strain) {
  const double natural = 1 + free_strain;
  const Vec3 end = tension - length * load;
  const Vec3 elongation = (length / (2 * EA)) * (tension + end);
  if (derivative) *derivative = (length / EA) * Mat3::Identity();
  const double t0 = tension.norm();
  const double t1 = end.norm();
  if (!(t0 + t1 > 0)) return elongation;

  const double w = load.norm();
  const Vec3 e = w > 0 ? Vec3(load / w) : Vec3(tension / t0);
  const double c = w > 0 ? tension.dot(e) : 0;
  const double c1 = c - w * length;
  const Vec3 p = w > 0 ? Vec3(tension - c * e) : tension;
  // A fold without transverse force has infinite compliance; this bounds it.
  const double h = std::max(p.norm(), 1e-14 * (t0 + t1));

  const double along = length * (c + c1) / (t0 + t1);  // ∫tau/|T| ds
  double A, q;                                         // q = ∫ h²/|T|³ ds
  if (c * c1 >= 0) {
    const double sum = std::abs(c + c1);
    const double low = std::min(std::abs(c), std::abs(c1));
    const double g = (1 + sum / (t0 + t1)) / (low + std::hypot(low, h));
    const double x = w * length * g;
    A = length * g * (x > 1e-12 ? std::log1p(x) / x : 1 - x / 2);
    const double mixed = std::abs(c) * t1 + std::abs(c1) * t0;
    q = mixed > 0 ? h * h * length * sum / (t0 * t1 * mixed) : length / std::max(t0, h);
  } else {
    A = (std::asinh(c / h) - std::asinh(c1 / h)) / w;
    q = (c / t0 - c1 / t1) / w;
  }
  if (derivative) {
    // ∫(I - t tᵀ)/|T| ds in the plane of e and p.
    const Vec3 n = p / h;
    const double b = t0 > 0 && t1 > 0 ? h * along / (t0 * t1) : 0;  // ∫ h tau/|T|³ ds
    *derivative +=
        natural * (A * (Mat3::Identity() - e * e.transpose()) + q * (e * e.transpose() - n * n.transpose()) -
                   b * (e * n.transpose() + n * e.transpose()));
  }
  return natural * (A * p + along * e) + elongation;
}

CatenaryShape::CatenaryShape(const Vec3& end_a, const Vec3& tension_a, std::vector<CatenarySection> sections)
    : sections_(std::move(sections)), start_{0.0}, position_{end_a}, tension_{tension_a} {
  for (const CatenarySection& s : sections_) {
    position_.push_back(position_.back() +
                        catenary_chord(tension_.back(), s.load, s.length, s.EA, nullptr, s.free_strain));
    last_tension_ = tension_.back() - s.length * s.load;
    tension_.push_back(last_tension_ - s.end_load);
    start_.push_back(start_.back() + s.length);
  }
}

size_t CatenaryShape::section(double s) const {
  const auto above = std::lower_bound(start_.begin() + 1, start_.end() - 1, s);
  return static_cast<size_t>(above - start_.begin()) - 1;
}

Vec3 CatenaryShape::position(double s) const {
  const size_t i = section(s);
  const CatenarySection& at = sections_[i];
  return position_[i] + catenary_chord(tension_[i], at.load, s - start_[i], at.EA, nullptr, at.free_strain);
}

Vec3 CatenaryShape::tension(double s) const {
  const size_t i = section(s);
  return tension_[i] - (s - start_[i]) * sections_[i].load;
}

namespace {

struct Totals {
  double length = 0, compliance = 0;  // unstretched length including free strain; sum of L/EA
  bool loaded = false;
  Vec3 load = Vec3::Zero();  // weight of the line and its point loads, without the last end load
};

Totals totals(const std::vector<CatenarySection>& sections) {
  Totals t;
  for (const CatenarySection& s : sections) {
    if (!(s.length > 0)) throw std::invalid_argument("a section of a catenary needs a positive length");
    if (!(s.EA > 0)) throw std::invalid_argument("a section of a catenary needs a positive EA");
    t.length += (1 + s.free_strain) * s.length;
    t.compliance += s.length / s.EA;
    t.load += s.length * s.load;
    t.loaded = t.loaded || !s.load.isZero(0);
    if (&s != &sections.back()) t.load += s.end_load;
  }
  if (sections.empty()) throw std::invalid_argument("a catenary needs at least one section");
  return t;
}

Vec3 chord_of_all(const Vec3& tension_a, const std::vector<CatenarySection>& sections, Mat3* derivative) {
  Vec3 chord = Vec3::Zero();
  Vec3 tension = tension_a;
  if (derivative) derivative->setZero();
  Mat3 part;
  for (const CatenarySection& s : sections) {
    chord += catenary_chord(tension, s.load, s.length, s.EA, derivative ? &part : nullptr, s.free_strain);
    if (derivative) *derivative += part;
    tension -= s.length * s.load + s.end_load;
  }
  return chord;
}

// Jonkman (2007), after Peyrot & Goulois: the parabola's lambda for a line with the mean load.
Vec3 first_tension(const Vec3& span, const Totals& t) {
  const double W = t.load.norm();
  const double distance = span.norm();
  Vec3 tension = Vec3::Zero();
  if (W > 0) {
    const Vec3 up = -t.load / W;
    const double z = span.dot(up);
    const Vec3 across = span - z * up;
    const double x = across.norm();
    double lambda = 0.2;
    if (distance < t.length)
      lambda = x > 0 ? std::sqrt(3 * ((t.length * t.length - z * z) / (x * x) - 1)) : 1e6;
    lambda = std::clamp(lambda, 0.2, 1e6);
    const double w = W / t.length;
    tension = w / (2 * lambda) * across;
    if (x == 0) tension += 1e-3 * W * up.unitOrthogonal();
    tension += (w / 2 * (z / std::tanh(lambda) + t.length) - W) * up;
  }
  if (distance > t.length) tension += (distance - t.length) / (t.compliance * distance) * span;
  return tension;
}

}  // namespace

CatenaryShape catenary(const Vec3& end_a, const Vec3& end_b, const std::vector<CatenarySection>& sections) {
  const Totals t = totals(sections);
  const Vec3 span = end_b - end_a;
  if (!t.loaded && !(span.norm() > t.length))
    throw std::invalid_argument("a slack line without load has no catenary shape");

  Vec3 x = first_tension(span, t);
  Mat3 compliance;
  Vec3 error = chord_of_all(x, sections, &compliance) - span;
  const double scale = t.length + span.norm();
  double best = error.norm();
  Vec3 best_x = x;
  for (int iteration = 0; iteration < 200 && best > 1e-15 * scale; ++iteration) {
    const Vec3 step = -compliance.ldlt().solve(error);
    const double slope = error.dot(step);
    if (!(slope < 0)) break;
    // The energy along the step is convex: stop when the size of its slope has halved, or after the whole
    // step if the slope has not changed its sign.
    double low = 0, high = 0, a = 1, slope_a = 0;
    for (int search = 0; search < 100; ++search) {
      error = chord_of_all(x + a * step, sections, &compliance) - span;
      slope_a = error.dot(step);
      if (slope_a > -0.5 * slope)
        high = a;  // too far
      else if (slope_a < 0.5 * slope && high > 0)
        low = a;
      else
        break;
      a = 0.5 * (low + high);
    }
    x += a * step;
    if (error.norm() < best) {
      best = error.norm();
      best_x = x;
    } else if (best < 1e-11 * scale) {
      break;  // at round-off
    }
  }
  if (!(best < 1e-8 * scale)) throw std::runtime_error("the catenary start shape did not converge");
  return {end_a, best_x, sections};
}

CatenaryShape catenary_free_b(const Vec3& end_a, const std::vector<CatenarySection>& sections) {
  return {end_a, totals(sections).load + sections.back().end_load, sections};
}

CatenaryShape catenary_free_a(const Vec3& end_b, const std::vector<CatenarySection>& sections) {
  totals(sections);
  return {end_b - chord_of_all(Vec3::Zero(), sections, nullptr), Vec3::Zero(), sections};
}

}  // namespace hawser
