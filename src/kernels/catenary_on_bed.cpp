// Newton's method for the horizontal and vertical end tension of a catenary that lies partly on the seabed,
// and position and tension along its grounded part.
#include "hawser/kernels/catenary_on_bed.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

// Friction q per length reduces the tension from T at the end of the part, so that over the length l before
// the end, of which l' = min(l, T/q) is under tension, the stretched length is
//   (1 + free strain) l + (T l' - q l'²/2)/EA.
double CatenaryOnBed::LaidPart::tension(double s) const { return std::max(0.0, T_end - drag * (end - s)); }

double CatenaryOnBed::LaidPart::stretched(double s) const {
  const double l = end - s;
  const double pulled = drag * l > T_end ? T_end / drag : l;
  return (1 + free_strain) * l + pulled * (T_end - 0.5 * drag * pulled) / EA;
}

Vec3 CatenaryOnBed::position(double s) const {
  for (const LaidPart& p : pieces_)
    if (s <= p.end) return anchor_ + (p.x_end - p.stretched(s)) * direction_;
  return hanging_->position(s - grounded_);
}

Vec3 CatenaryOnBed::tension(double s) const {
  for (const LaidPart& p : pieces_)
    if (s <= p.end) return p.tension(s) * direction_;
  return hanging_->tension(s - grounded_);
}

namespace {

// Point in the vertical plane through the ends.
struct Plane {
  double x = 0, z = 0;
};

// Position of end B under the pull (H, V), and its derivatives.
struct EndB {
  Plane at;
  double xx = 0, xz = 0, zz = 0;  // d at / d (H, V), symmetric
  size_t lowest = 0;              // section that hangs lowest, in part or in full
  double hanging = 0;             // m, hanging length of that section
  double V = 0;                   // N, vertical tension at its lower end
};

// When the line is lowered to the bed, the touchdown point moves and the grounded length grows by what the
// hanging length loses. Except for stretch these effects cancel and are absent from the derivatives.
EndB end_b_pulled_by(const std::vector<CatenarySection>& sections, double friction, double slope, double H,
                     double V) {
  EndB r;
  const double lies = H * slope;  // vertical tension of the line along the bed
  const double along = std::hypot(1, slope);
  size_t i = sections.size();
  bool down = false;
  double top = V;
  while (i-- > 0 && !down) {
    const CatenarySection& s = sections[i];
    const double w = -s.load.z();
    if (i + 1 < sections.size()) {
      const double above = top;
      top += s.end_load.z();
      if (top < lies) {  // a clump weight on the bed
        r.lowest = i;
        r.hanging = 0;
        r.V = above;
        break;
      }
    }
    const double bottom = top - w * s.length;
    down = bottom < lies;
    const double length = down ? std::max(0.0, top - lies) / w : s.length;
    const Vec3 start(H, 0, down ? lies : bottom);
    Mat3 d;
    const Vec3 chord = catenary_chord(start, s.load, length, s.EA, &d, s.free_strain);
    r.at.x += chord.x();
    r.at.z += chord.z();
    r.xx += d(0, 0);
    r.xz += d(0, 2);
    r.zz += d(2, 2);
    r.lowest = i;
    r.hanging = length;
    r.V = start.z();
    top = bottom;
  }
  // The grounded part.
  double T = H * along;
  for (size_t k = r.lowest + 1; k-- > 0;) {
    const CatenarySection& s = sections[k];
    const double l = k == r.lowest ? s.length - r.hanging : s.length;
    const double drag = friction * std::max(-s.load.z(), 0.0);
    if (l <= 0) continue;
    const double pulled = drag * l > T ? T / drag : l;
    const double laid = (1 + s.free_strain) * l + pulled * (T - 0.5 * drag * pulled) / s.EA;
    r.at.x += laid / along;
    r.at.z += laid * slope / along;
    r.xx += pulled / s.EA;
    r.xz += slope * pulled / s.EA;
    r.zz += slope * slope * pulled / s.EA;
    T = std::max(0.0, T - drag * l);
  }
  return r;
}

// Pull at end B, N, and the position of end B.
struct Pull {
  double H = 0, V = 0;
  EndB end;
};

// Estimate from the parabola of a line of this length [m] and weight [N], or from its stretch.
Pull first_guess(const std::vector<CatenarySection>& sections, double length, double weight,
                 const Plane& to) {
  double lambda = 0.2;
  if (std::hypot(to.x, to.z) < length)
    lambda = std::sqrt(3 * ((length * length - to.z * to.z) / (to.x * to.x) - 1));
  lambda = std::max(lambda, 0.2);
  const double w = weight / length;
  double H = w * to.x / (2 * lambda);
  double V = 0.5 * w * (to.z / std::tanh(lambda) + length);
  // The excess of the ends' distance over the length stretches the line.
  if (std::hypot(to.x, to.z) > length) {
    double compliance = 0;
    for (const CatenarySection& s : sections) compliance += s.length / s.EA;
    const double T = (std::hypot(to.x, to.z) - length) / compliance;
    H += T * to.x / std::hypot(to.x, to.z);
    V += T * to.z / std::hypot(to.x, to.z);
  }
  return {H, V, {}};
}

// Pull that brings end B to a position, by Newton's method; `scale` [m] is the reference of the distance.
std::optional<Pull> pull_to(const std::vector<CatenarySection>& sections, double friction, double slope,
                            const Plane& to, double scale, const Pull& first) {
  double H = first.H;
  double V = first.V;
  EndB r = end_b_pulled_by(sections, friction, slope, H, V);
  double error = std::hypot(r.at.x - to.x, r.at.z - to.z);
  for (int i = 0; i < 200 && error > 1e-13 * scale; ++i) {
    const double ex = r.at.x - to.x;
    const double ez = r.at.z - to.z;
    const double det = r.xx * r.zz - r.xz * r.xz;
    if (!(det > 0)) return {};
    double dH = -(r.zz * ex - r.xz * ez) / det;
    double dV = -(r.xx * ez - r.xz * ex) / det;
    // Neither component changes its sign; within this limit, descent of the convex complementary energy.
    double largest_step = 1;
    if (dH < 0) largest_step = std::min(largest_step, 0.9 * H / -dH);
    if (dV < 0) largest_step = std::min(largest_step, 0.9 * V / -dV);
    const double rate = ex * dH + ez * dV;
    double low = 0;
    double high = 0;
    double a = largest_step;
    for (int search = 0; search < 60; ++search) {
      r = end_b_pulled_by(sections, friction, slope, H + a * dH, V + a * dV);
      const double now = (r.at.x - to.x) * dH + (r.at.z - to.z) * dV;
      if (now > -0.5 * rate)
        high = a;
      else if (now < 0.5 * rate && high > 0)
        low = a;
      else
        break;
      a = 0.5 * (low + high);
    }
    H += a * dH;
    V += a * dV;
    const double next = std::hypot(r.at.x - to.x, r.at.z - to.z);
    if (next >= error && error < 1e-10 * scale) break;
    error = next;
  }
  if (!(error < 1e-8 * scale)) return {};
  return Pull{H, V, r};
}

}  // namespace

std::optional<CatenaryOnBed> catenary_on_bed(const Vec3& anchor, const Vec3& end_b,
                                             const std::vector<CatenarySection>& sections, double friction,
                                             double slope) {
  const Vec3 span = end_b - anchor;
  const Plane to{span.head<2>().norm(), span.z()};
  double length = 0, weight = 0;
  for (const CatenarySection& s : sections) {
    if (s.load.head<2>().norm() > 0 || s.end_load.head<2>().norm() > 0 || !(s.EA > 0) || !(s.length > 0))
      return {};
    length += (1 + s.free_strain) * s.length;
    weight -= s.load.z() * s.length;
  }
  const double height = to.z - slope * to.x;
  const double along = std::hypot(1, slope);
  if (sections.empty() || !(weight > 0) || !(height > 0) || !(to.x > 0) || length >= along * to.x + height)
    return {};

  Pull first = first_guess(sections, length, weight, to);
  first.V += std::max(0.0, slope * first.H);
  const auto pull = pull_to(sections, friction, slope, to, length + to.x + std::abs(to.z), first);
  if (!pull) return {};
  const EndB& r = pull->end;
  CatenaryOnBed out;
  out.anchor_ = anchor;
  const Vec3 level = Vec3(span.x(), span.y(), 0) / to.x;
  out.direction_ = (level + slope * Vec3::UnitZ()) / along;
  double start = 0;
  for (size_t k = 0; k <= r.lowest; ++k) {
    const CatenarySection& s = sections[k];
    const double l = k == r.lowest ? s.length - r.hanging : s.length;
    const double drag = friction * std::max(-s.load.z(), 0.0);
    if (l > 0) {
      if (s.load.z() > 0 && r.V <= slope * pull->H) return {};  // it would float
      out.pieces_.push_back({start, start + l, 0, 0, drag, s.EA, s.free_strain});
    }
    start += l;
  }
  out.grounded_ = out.pieces_.empty() ? 0 : out.pieces_.back().end;
  double T = pull->H * along;
  for (auto p = out.pieces_.rbegin(); p != out.pieces_.rend(); ++p) {
    p->T_end = T;
    T = p->tension(p->start);
  }
  double x = 0;
  for (auto& p : out.pieces_) {
    p.x_end = 0;
    x += p.stretched(p.start);
    p.x_end = x;
  }
  std::vector<CatenarySection> hanging(sections.begin() + static_cast<std::ptrdiff_t>(r.lowest),
                                       sections.end());
  hanging.front().length = r.hanging;
  if (!(r.hanging > 0)) {
    hanging.erase(hanging.begin());
    if (hanging.empty()) return {};
  }
  out.hanging_.emplace(anchor + x * out.direction_, pull->H * level + r.V * Vec3::UnitZ(),
                       std::move(hanging));
  return out;
}

}  // namespace hawser
