// Bisection in space and time of the region that an element axis sweeps in a step, to detect passage through
// a thin body.
#include "hawser/kernels/axis_sweep.hpp"

#include <algorithm>
#include <vector>

namespace hawser {
namespace {

constexpr double kDeep = 0.25, kClear = 0.75;  // fractions of the radius, from axis to surface
constexpr double kPiece = 0.5;                 // length of pieces that are examined, fraction of the radius

// Part of the axis during part of the step.
struct SweptPart {
  std::array<BezierAxis, 2> b;  // at the start and end of that part
  double from = 0, to = 1;      // interval of the axis
};

double length_of(const SweptPart& p) {
  double along = 0;
  for (const BezierAxis& b : p.b)
    along = std::max({along, (b.b[3] - b.b[0]).norm(), (b.b[2] - b.b[1]).norm()});
  return along;
}

std::array<SweptPart, 2> halves_in_time(const SweptPart& p) {
  std::array<SweptPart, 2> out{p, p};
  out[0].b[1] = between(p.b[0], p.b[1]);
  out[1].b[0] = out[0].b[1];
  return out;
}

std::array<SweptPart, 2> halves_along(const SweptPart& p) {
  std::array<SweptPart, 2> out{p, p};
  for (size_t i = 0; i < 2; ++i) {
    const auto half = p.b[i].halves();
    out[0].b[i] = half[0];
    out[1].b[i] = half[1];
  }
  out[0].to = 0.5 * (p.from + p.to);
  out[1].from = out[0].to;
  return out;
}

}  // namespace

bool passes_through(DistanceField field, const BezierAxis& from, const BezierAxis& to, double radius,
                    bool pressed) {
  if (!(from.farthest_distance(to) > radius)) return false;
  std::vector<SweptPart> pieces{{{from, to}}};
  while (!pieces.empty()) {
    const SweptPart piece = pieces.back();
    pieces.pop_back();
    const Vec3 y = between(piece.b[0], piece.b[1]).point(0.5);
    double size = 0;
    for (const BezierAxis& b : piece.b)
      for (const Vec3& p : b.b) size = std::max(size, (p - y).norm());
    Vec3 normal;
    const auto distance = field(y, size, normal);
    if (!distance) continue;
    const double length = length_of(piece);
    const bool near = *distance <= radius;
    if (near) {
      const double xi = 0.5 * (piece.from + piece.to);
      const Vec3 y0 = from.point(xi);
      const Vec3 y1 = to.point(xi);
      Vec3 n0, n1;
      const auto d0 = field(y0, 2 * radius + (y - y0).norm(), n0);
      const auto d1 = field(y1, 2 * radius + (y - y1).norm(), n1);
      const bool outside = d0 && *d0 > kDeep * radius;
      const bool other_side =
          d0 && d1 && ((outside && *d1 >= kClear * radius) || ((outside || pressed) && n0.dot(n1) < 0));
      if (other_side && *distance <= kDeep * radius) return true;
      if (!other_side && length <= kPiece * radius) continue;
    }
    // Near the surface the ends of the path come first: where the axis is not on another side at the end of
    // the step, its path is not examined.
    const bool along =
        (near && length > kPiece * radius) || length >= piece.b[0].farthest_distance(piece.b[1]);
    for (const SweptPart& half : along ? halves_along(piece) : halves_in_time(piece)) pieces.push_back(half);
  }
  return false;
}

}  // namespace hawser
