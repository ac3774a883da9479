// Axis-aligned boxes [m]. An empty box has lo = +inf, hi = -inf; infinite boxes are allowed.
#pragma once

#include <cmath>
#include <limits>

#include "hawser/math/types.hpp"

namespace hawser {

struct Box {
  Vec3 lo = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 hi = Vec3::Constant(-std::numeric_limits<double>::infinity());

  static Box everything() {
    const Vec3 inf = Vec3::Constant(std::numeric_limits<double>::infinity());
    return {-inf, inf};
  }
  bool empty() const { return (lo.array() > hi.array()).any(); }
  void add(const Vec3& p) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  void add(const Box& b) {
    lo = lo.cwiseMin(b.lo);
    hi = hi.cwiseMax(b.hi);
  }
  Vec3 centre() const { return 0.5 * (lo + hi); }
  Vec3 extent() const { return hi - lo; }
  double diagonal() const { return empty() ? 0 : extent().norm(); }
  bool contains(const Vec3& p) const {
    return (p.array() >= lo.array()).all() && (p.array() <= hi.array()).all();
  }
  bool overlaps(const Box& b) const {
    return (lo.array() <= b.hi.array()).all() && (b.lo.array() <= hi.array()).all();
  }
  // The box grown by r on every side.
  Box grown(double r) const { return {lo - Vec3::Constant(r), hi + Vec3::Constant(r)}; }
};

// Squared distance from p to the box [m²], 0 inside.
inline double squared_distance(const Box& b, const Vec3& p) {
  return (b.lo - p).cwiseMax(p - b.hi).cwiseMax(0.0).squaredNorm();
}

inline double distance(const Box& b, const Vec3& p) { return std::sqrt(squared_distance(b, p)); }

// Distance between two boxes [m], 0 when they overlap.
inline double distance(const Box& a, const Box& b) {
  return (a.lo - b.hi).cwiseMax(b.lo - a.hi).cwiseMax(0.0).norm();
}

}  // namespace hawser
