// Where a search of the spatial hash begins.
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstring>

#include "spatial_hash_search.hpp"

namespace hawser {

using detail::Axes;
using detail::axes;
using detail::AxesFloats;
using detail::AxesInts;
using detail::AxesWords;

bool SpatialHash::begin(Ball& q, const Vec3& p, double max_distance) const {
  q.slot = kNone;
  if (corners_.empty() || !(max_distance >= 0)) return false;
  q.p = p;
  q.from_centre = axes(p) - axes(centre_);
  const auto largest = [](const Axes& v) {
    return std::max(std::abs(v[0]), std::max(std::abs(v[1]), std::abs(v[2])));
  };
  const Axes none = q.from_centre - q.from_centre;
  if (!(none[0] + none[1] + none[2] == 0)) return false;  // not finite
  q.x = __builtin_convertvector(q.from_centre, AxesFloats);
  q.rounding = 3e-7 * (largest(q.from_centre) + half_);
  q.rounding_double = 1e-15 * (largest(axes(p)) + away_);
  q.best = max_distance * max_distance;
  q.set_reach(max_distance);
  return true;
}

SpatialHash::Start SpatialHash::start(const Ball& q) const {
  Start s;
  const double radius = q.reach * (1 + 1e-9) + q.rounding;
  // The exponent of the ratio is the level; the finest in the table is no finer than the coarsest triangles.
  const double ratio = Start::kRoom * radius / side_;
  const int level = static_cast<int>(std::bit_cast<std::uint64_t>(ratio) >> 52) - 1022;
  s.level = std::max(level, least_);
  if ((s.root = s.level >= top_)) return s;
  const double side = side_ * (1 << s.level), to_cells = 1 / side;
  const double margin = margin_[static_cast<std::size_t>(s.level)];
  const double last = static_cast<double>((1 << (top_ - s.level)) - 1), reach = (radius + margin) * to_cells;
  const Axes zero = {}, x = (axes(q.p) - axes(origin_)) * to_cells;
  const auto outside = (x + reach < zero) | (x - reach > zero + (last + 1));
  s.none = (outside[0] | outside[1] | outside[2]) != 0;
  // Centres on the far face of the box were put in the last cell.
  const Axes within = x > zero ? (x < zero + last ? x : zero + last) : zero;
  const AxesInts cell = __builtin_convertvector(within, AxesInts);
  const Axes own = __builtin_convertvector(cell, Axes);
  const auto lower = x - reach < own, upper = ~lower & (x + reach >= own + 1);
  const auto second = (lower & (own > zero)) | (upper & (own < zero + last));
  s.ways = static_cast<unsigned>((second[0] & 1) | (second[1] & 2) | (second[2] & 4));
  const Axes to_face = x - (lower ? own : own + 1);
  Axes away = (to_face > zero ? to_face : -to_face) * side - margin;
  away = away > zero ? away : zero;
  const AxesFloats squared = __builtin_convertvector((1 - 1e-6) * away * away, AxesFloats);
  std::memcpy(s.squared, &squared, sizeof squared);
  // Keys one cell on and one back: bits between those of an axis carry over and borrow.
  const AxesWords axis = AxesWords{} + detail::spread(~0ul),
                  code = detail::spread(__builtin_convertvector(cell, AxesWords));
  const AxesWords back = (code - 1) & axis, on = ((code | ~axis) + 1) & axis;
  const AxesWords shift = {0, 1, 2, 0};
  const AxesWords change = ((lower ? back : on) ^ code) << shift & reinterpret_cast<AxesWords>(second),
                  at = code << shift;
  std::memcpy(s.change, &change, sizeof change);
  s.own = at[0] | at[1] | at[2];
  return s;
}

}  // namespace hawser
