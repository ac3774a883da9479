// Axis of a tube: legs and arcs, and whether the tube touches itself.
#include "hawser/geometry/tube_path.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/geometry/box_pairs.hpp"
#include "hawser/geometry/segment_distance.hpp"

namespace hawser {
namespace {

constexpr double kStraight = 1e-8;    // rad, corners that turn by less have no arc: root of the rounding
constexpr double kRounding = 1e-9;    // of a leg, by which its bends may exceed it
constexpr double kChord = M_PI / 32;  // rad, of arcs when a tube is tested against itself

void need(bool condition, const char* sentence) {
  if (!condition) throw std::invalid_argument(sentence);
}

struct Chord {
  Vec3 a, b;
  double from, to;  // m, along the axis
  double sagitta;   // m
};

std::vector<Chord> chords(const std::vector<TubePiece>& pieces) {
  std::vector<Chord> out;
  double at = 0;
  for (const TubePiece& p : pieces) {
    const int n = std::max(1, static_cast<int>(std::ceil(p.turn() / kChord)));
    const double sagitta = p.radius * (1 - std::cos(0.5 * p.turn() / n));
    for (int i = 0; i < n; ++i) {
      const double a = p.length * i / n;
      const double b = p.length * (i + 1) / n;
      out.push_back({p.point(a), p.point(b), at + a, at + b, sagitta});
    }
    at += p.length;
  }
  return out;
}

}  // namespace

std::vector<TubeBend> tube_bends(const TubeShape& s) {
  std::vector<TubeBend> bends;
  for (std::size_t i = 1; i + 1 < s.path.size(); ++i) {
    const Vec3 u = (s.path[i] - s.path[i - 1]).stableNormalized();
    const Vec3 v = (s.path[i + 1] - s.path[i]).stableNormalized();
    TubeBend b;
    b.turn = std::atan2(u.cross(v).norm(), u.dot(v));
    b.radius = s.bend_radius[s.bend_radius.size() == 1 ? 0 : i - 1];
    b.tangent = b.radius * std::tan(0.5 * b.turn);
    bends.push_back(b);
  }
  return bends;
}

Vec3 TubePiece::point(double s) const {
  if (!arc()) return from + s * direction;
  const double angle = s / radius;
  return centre() + radius * (std::sin(angle) * direction - std::cos(angle) * inward);
}

Vec3 TubePiece::tangent(double s) const {
  if (!arc()) return direction;
  const double angle = s / radius;
  return std::cos(angle) * direction + std::sin(angle) * inward;
}

std::vector<TubePiece> tube_pieces(const TubeShape& s) {
  need(s.path.size() >= 2, "the path of a tube needs two points");
  const std::size_t corners = s.path.size() - 2;
  need(corners == 0 || s.bend_radius.size() == 1 || s.bend_radius.size() == corners,
       "a tube needs one bend radius, or one for each corner of its path");
  for (std::size_t i = 0; i + 1 < s.path.size(); ++i)
    need(s.path[i] != s.path[i + 1], "two successive points of a tube's path coincide");
  const std::vector<TubeBend> bends = tube_bends(s);
  std::vector<TubePiece> pieces;
  for (std::size_t i = 0; i + 1 < s.path.size(); ++i) {
    const Vec3 chord = s.path[i + 1] - s.path[i];
    const double whole = chord.norm();
    const double before = i > 0 ? bends[i - 1].tangent : 0;
    const double after = i < corners ? bends[i].tangent : 0;
    const double length = whole - before - after;
    need(length >= -kRounding * whole, "a leg of a tube's path is shorter than its bends need");
    const Vec3 direction = chord / whole;
    if (length > kRounding * whole || corners == 0)
      pieces.push_back({s.path[i] + before * direction, direction, length});
    if (i == corners || bends[i].turn < kStraight) continue;
    const Vec3 next = (s.path[i + 2] - s.path[i + 1]).normalized();
    const Vec3 inward = (next - next.dot(direction) * direction).normalized();
    pieces.push_back({s.path[i + 1] - after * direction, direction, bends[i].radius * bends[i].turn,
                      bends[i].radius, inward});
  }
  return pieces;
}

// The axis has a curvature below 1/r, r the outer radius. Places less than pi r apart along it are farther
// from each other than the ends of an arc of radius r (Schur 1921), and need no test; at pi r that is 2 r.
std::optional<TubeTouch> tube_touches_itself(const TubeShape& s) {
  const double r = s.outer_radius();
  const std::vector<Chord> all = chords(tube_pieces(s));
  std::vector<Box> boxes;
  for (const Chord& c : all) {
    Box box{c.a, c.a};
    box.add(c.b);
    boxes.push_back(box.grown(r));
  }
  for (const auto& [i, j] : overlapping_pairs(boxes)) {
    const Chord& a = all[i];
    const Chord& b = all[j];
    if (b.from - a.to < M_PI * r) continue;
    const SegmentPair p = closest_points_of_segments(a.a, a.b, b.a, b.b);
    if (p.distance + a.sagitta + b.sagitta < 2 * r)
      return TubeTouch{a.from + p.s * (a.to - a.from), b.from + p.t * (b.to - b.from), p.distance};
  }
  return std::nullopt;
}

}  // namespace hawser
