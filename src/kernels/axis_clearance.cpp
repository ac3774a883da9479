// Nearest points of two element axes by branch and bound with Newton's method; distance to a surface.
#include "hawser/kernels/axis_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hawser/geometry/segment_distance.hpp"

namespace hawser {
namespace {

constexpr int kMaxIterations = 30, kMaxHalvings = 8, kMaxLevels = 20;

// Part of an axis: start and fraction of it.
struct AxisPart {
  BezierAxis axis;
  double from = 0, fraction = 1;
  double sagitta = 0;
};

AxisPart full_axis(const BezierAxis& a) { return {a, 0, 1, a.sagitta()}; }

std::array<AxisPart, 2> halved(const AxisPart& p) {
  const auto h = p.axis.halves();
  const double half = 0.5 * p.fraction;
  return {AxisPart{h[0], p.from, half, h[0].sagitta()}, AxisPart{h[1], p.from + half, half, h[1].sagitta()}};
}

// Newton's method for the nearest points in the unit square, downhill only.
AxisApproach polish(const BezierAxis& a, const BezierAxis& b, AxisApproach at) {
  Vec3 r = a.point(at.xi) - b.point(at.eta);
  double size = r.squaredNorm();
  for (int i = 0; i < kMaxIterations; ++i) {
    const Vec3 a1 = a.slope(at.xi);
    const Vec3 b1 = b.slope(at.eta);
    double g = r.dot(a1);
    double h = -r.dot(b1);
    double gg = a1.squaredNorm() + r.dot(a.bend(at.xi));
    double hh = b1.squaredNorm() - r.dot(b.bend(at.eta));
    double gh = -a1.dot(b1);
    // At a side of the square that the step would leave, it follows the side.
    const bool no_xi = (at.xi <= 0 && g > 0) || (at.xi >= 1 && g < 0);
    const bool no_eta = (at.eta <= 0 && h > 0) || (at.eta >= 1 && h < 0);
    if (no_xi) {
      g = 0;
      gg = 1;
      gh = 0;
    }
    if (no_eta) {
      h = 0;
      hh = 1;
      gh = 0;
    }
    const double scale = std::max(a1.squaredNorm(), b1.squaredNorm());
    if (!(gg > 1e-12 * scale) || !(hh > 1e-12 * scale) || !(gg * hh - gh * gh > 1e-12 * gg * hh)) {
      // Not convex here, or parallel: Gauss-Newton, slightly stiffened.
      gg = no_xi ? 1 : a1.squaredNorm() + 1e-9 * scale;
      hh = no_eta ? 1 : b1.squaredNorm() + 1e-9 * scale;
      gh = no_xi || no_eta ? 0 : -a1.dot(b1);
    }
    const double det = gg * hh - gh * gh;
    if (!(det > 0)) break;
    const double dx = -(hh * g - gh * h) / det;
    const double dy = -(gg * h - gh * g) / det;
    bool accepted = false;
    double moved = 0, factor = 1;
    for (int k = 0; k < kMaxHalvings && !accepted; ++k, factor *= 0.5) {
      const double xi = std::clamp(at.xi + factor * dx, 0.0, 1.0);
      const double eta = std::clamp(at.eta + factor * dy, 0.0, 1.0);
      const Vec3 next = a.point(xi) - b.point(eta);
      if (!(next.squaredNorm() < size)) continue;
      moved = std::max(std::abs(xi - at.xi), std::abs(eta - at.eta));
      at.xi = xi;
      at.eta = eta;
      r = next;
      size = next.squaredNorm();
      accepted = true;
    }
    if (!accepted || moved < 1e-15) break;
  }
  at.distance = std::sqrt(size);
  return at;
}

}  // namespace

std::optional<AxisApproach> nearest_of(const BezierAxis& a, const BezierAxis& b, double within,
                                       double resolution) {
  AxisApproach best;
  best.distance = within;
  bool found = false;
  struct Work {
    AxisPart a, b;
    double lower_bound;  // lower bound of the distance
    SegmentPair chords;
    int level;
  };
  const auto make = [](const AxisPart& p, const AxisPart& q, int level) {
    Work w{p, q, 0, closest_points_of_segments(p.axis.b[0], p.axis.b[3], q.axis.b[0], q.axis.b[3]), level};
    w.lower_bound = w.chords.distance - p.sagitta - q.sagitta;
    return w;
  };
  std::vector<Work> stack{make(full_axis(a), full_axis(b), 0)};
  while (!stack.empty()) {
    const Work w = stack.back();
    stack.pop_back();
    if (!(w.lower_bound < best.distance)) continue;
    if (w.a.sagitta + w.b.sagitta <= resolution || w.level >= kMaxLevels) {
      AxisApproach start;
      start.xi = w.a.from + w.chords.s * w.a.fraction;
      start.eta = w.b.from + w.chords.t * w.b.fraction;
      const AxisApproach polished = polish(a, b, start);
      if (polished.distance < best.distance) {
        best = polished;
        found = true;
      }
      continue;
    }
    const bool first = w.a.sagitta >= w.b.sagitta;
    const std::array<AxisPart, 2> h = halved(first ? w.a : w.b);
    const auto part = [&](int i) {
      return first ? make(h[i], w.b, w.level + 1) : make(w.a, h[i], w.level + 1);
    };
    std::array<Work, 2> next{part(0), part(1)};
    // The nearer half is examined first.
    if (next[0].lower_bound < next[1].lower_bound) std::swap(next[0], next[1]);
    for (const Work& n : next)
      if (n.lower_bound < best.distance) stack.push_back(n);
  }
  if (!found) return std::nullopt;
  return best;
}

std::optional<AxisToSurface> nearest_to(DistanceField field, const BezierAxis& axis, double within,
                                        int levels) {
  struct AxisSample {
    double xi = 0, distance = 0, slope = 0;
    bool known = false;
  };
  const int pieces = 1 << levels;
  const double piece = axis.slope_bound() / pieces;
  AxisToSurface best;
  best.distance = within;
  bool found = false;
  const auto sample = [&](double xi) {
    AxisSample p;
    p.xi = xi;
    Vec3 normal;
    // A farther point shows that the neighbouring pieces have nothing nearer than the best.
    if (const auto d = field(axis.point(xi), best.distance + piece, normal)) {
      p.distance = *d;
      p.slope = normal.dot(axis.slope(xi));
      p.known = true;
      if (p.distance < best.distance) {
        best.distance = p.distance;
        best.xi = xi;
        found = true;
      }
    }
    return p;
  };
  AxisSample last = sample(0);
  for (int k = 1; k <= pieces; ++k) {
    const AxisSample next = sample(static_cast<double>(k) / pieces);
    AxisSample lo = last;
    AxisSample hi = next;
    last = next;
    if (!lo.known || !hi.known || !(lo.slope < 0) || !(hi.slope > 0)) continue;
    if (0.5 * (lo.distance + hi.distance - piece) >= best.distance) continue;
    // Root of the slope, alternating between bisection and false position.
    for (int i = 0; i < 60 && hi.xi - lo.xi > 1e-14; ++i) {
      double xi = 0.5 * (lo.xi + hi.xi);
      if (i % 2 == 0) xi = lo.xi - lo.slope * (hi.xi - lo.xi) / (hi.slope - lo.slope);
      if (!(xi > lo.xi && xi < hi.xi)) break;
      const AxisSample middle = sample(xi);
      if (!middle.known) break;
      (middle.slope < 0 ? lo : hi) = middle;
      if (std::abs(middle.slope) * (hi.xi - lo.xi) < 1e-15 * (1 + std::abs(middle.distance))) break;
    }
  }
  if (!found) return std::nullopt;
  return best;
}

}  // namespace hawser
