// Reference solution of a mooring leg at rest on a rigid plane bed with Coulomb friction, independent of the
// program: the hanging part is an elastic catenary from its touchdown point, the lying part loses mu w cos(b)
// + w sin(b) of tension per length towards the anchor until the tension is zero, and the tension at the
// touchdown point is the root of the excess length of the line. Sources: Irvine (1981), Cable Structures,
// 1.3, for the elastic catenary; Jonkman (2007), 2.5, for the friction of a level bed.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace hawser::test {

struct LegOnBed {
  double length = 0, weight = 0, EA = 0;  // m; N/m in water; N
  double friction = 0;
  double slope = 0;     // rad, of the bed, > 0: it rises from the anchor to the fairlead
  double padeye = 0;    // m, above the axis of the lying part; an end below this axis is taken to be on it
  double x = 0, z = 0;  // m, fairlead relative to the point of the bed under the anchor, horizontal and up
  double lift = 0, lifted_from = 0;  // N, of a small buoy on the lying part; m from the anchor
};

struct LegLoads {
  double anchor = 0, fairlead = 0, lying = 0;  // N, N, m
};

class LegSolver {
 public:
  explicit LegSolver(const LegOnBed& leg) : leg_(leg), c_(std::cos(leg.slope)), s_(std::sin(leg.slope)) {}

  // Empty if no part of the line lies on the bed.
  std::optional<LegLoads> solve() const {
    double low = 1e-6;
    double high = 2000 * leg_.weight;
    std::optional<LegLoads> found;
    for (int i = 0; i < 80; ++i) {
      const double T = std::sqrt(low * high);
      LegLoads loads;
      const std::optional<double> spare = too_long_by(T, loads);
      if (!spare || *spare > 0) {
        high = T;
      } else {
        low = T;
        found = loads;
      }
    }
    return found;
  }

 private:
  struct Chord {
    double x = 0, z = 0;
  };
  // A catenary of length s from its lower end, where the force (H, V) pulls back.
  Chord catenary(double H, double V, double s) const {
    const double w = leg_.weight;
    const double top = V + w * s;
    return {H / w * (std::asinh(top / H) - std::asinh(V / H)) + H * s / leg_.EA,
            (std::hypot(H, top) - std::hypot(H, V)) / w + (V * s + 0.5 * w * s * s) / leg_.EA};
  }

  // The lying part from the touchdown point on, where the tension is T: tension at its other end, and its
  // stretch.
  void lie(double T, double length, double& at_end, double& stretch) const {
    constexpr int kPieces = 400;
    const double ds = length / kPieces;
    const double drag = leg_.weight * (leg_.friction * c_ + s_);
    stretch = 0;
    at_end = T;
    for (int i = 0; i < kPieces; ++i) {
      const double from = length - (i + 1) * ds;
      const double next = std::max(0.0, at_end - drag * ds);
      stretch += 0.5 * (at_end + next) / leg_.EA * ds;
      at_end = next;
      // The lift of the buoy reduces the normal force on the bed.
      if (leg_.lift > 0 && from <= leg_.lifted_from && leg_.lifted_from < from + ds)
        at_end = std::min(T, at_end + leg_.friction * leg_.lift * c_);
    }
  }

  struct Padeye {
    double length = 0, along = 0, load = 0;  // m of hanging line, m of bed below it, N
  };
  Padeye hang(double T) const {
    const double w = leg_.weight;
    if (!(leg_.padeye > 0)) return {0, 0, T};
    if (T < 1e-6 * w) return {leg_.padeye, 0, w * leg_.padeye};
    const double H = T * c_;
    const double V = -T * s_;
    double low = 0;
    double high = 1e4;
    for (int i = 0; i < 100; ++i) {
      const double l = 0.5 * (low + high);
      const Chord d = catenary(H, V, l);
      (d.z + d.x * s_ / c_ < leg_.padeye ? low : high) = l;
    }
    return {low, catenary(H, V, low).x / c_, std::hypot(H, V + w * low)};
  }

  std::optional<double> too_long_by(double T, LegLoads& loads) const {
    const double H = T * c_;
    const double V = T * s_;
    const auto above = [&](double length) {
      const Chord d = catenary(H, V, length);
      return d.z + (leg_.x - d.x) * s_ / c_ - leg_.z;
    };
    if (above(leg_.length) < 0) return {};
    double low = 0;
    double high = leg_.length;
    for (int i = 0; i < 80; ++i) {
      const double l = 0.5 * (low + high);
      (above(l) < 0 ? low : high) = l;
    }
    const double touchdown = (leg_.x - catenary(H, V, high).x) / c_;
    const double rest = leg_.length - high;
    double at_anchor = T;
    double stretch = 0;
    Padeye p;
    for (int i = 0; i < 8; ++i) {
      p = hang(at_anchor);
      lie(T, std::max(0.0, rest - p.length), at_anchor, stretch);
    }
    p = hang(at_anchor);
    if (rest < p.length) return {};
    loads = {p.load, std::hypot(H, V + leg_.weight * high), rest - p.length};
    return rest - p.length + stretch + p.along - touchdown;
  }

  LegOnBed leg_;
  double c_, s_;
};

}  // namespace hawser::test
