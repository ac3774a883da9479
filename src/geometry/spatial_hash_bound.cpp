// Bounds of distances in single precision, many at a time.
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstring>

#include "spatial_hash_lanes.hpp"
#include "spatial_hash_search.hpp"

namespace hawser {

using detail::bits;
using detail::BoxInts;
using detail::BoxLanes;
using detail::greater;
using detail::Ints;
using detail::kRun;
using detail::Lanes;
using detail::lesser;
using detail::Vector;

namespace {

struct Lanes3 {
  Lanes x, y, z;
  Lanes3 operator-(const Lanes3& o) const { return {x - o.x, y - o.y, z - o.z}; }
  Lanes dot(const Lanes3& o) const { return x * o.x + y * o.y + z * o.z; }
  Lanes3 cross(const Lanes3& o) const { return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x}; }
};

// One corner of each triangle of a run, in steps: three times ten bits.
Lanes3 load(const std::uint32_t* at) {
  Vector<std::uint32_t, kRun> s;
  std::memcpy(&s, at, sizeof s);
  const auto lanes = [](Vector<std::uint32_t, kRun> u) {
    return __builtin_convertvector(reinterpret_cast<Ints>(u), Lanes);
  };
  return {lanes(s & 1023u), lanes(s >> 10 & 1023u), lanes(s >> 20)};
}

Lanes load(const std::uint8_t* at) {
#ifdef __AVX512VL__
  return _mm512_cvtepi32_ps(_mm512_cvtepu8_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at))));
#else
  Vector<std::uint8_t, kRun> s;
  std::memcpy(&s, at, sizeof s);
  // By way of shorts: straight to ints gcc 12 takes the lanes one by one.
  const auto shorts = __builtin_convertvector(s, Vector<std::uint16_t, kRun>);
  return __builtin_convertvector(__builtin_convertvector(shorts, Ints), Lanes);
#endif
}

// Squared distance from 0 to the segments from a along e, of squared length e2.
Lanes squared_distance_to_segment(const Lanes3& a, const Lanes3& e, Lanes e2) {
  const Lanes zero = {}, one = zero + 1;
  const Lanes t = lesser(greater(-a.dot(e) * detail::inverse(greater(e2, zero + FLT_MIN)), zero), one);
  const Lanes3 r = {a.x + t * e.x, a.y + t * e.y, a.z + t * e.z};
  return r.dot(r);
}

// A triangle whose height over its longest side is less than this much of it is taken for its edges.
constexpr float kFlat = 0.1f;

// Errors of bounds in single precision over the size of what is computed with. The normal of a triangle
// that is not flat is right to 3 u / kFlat (u = 6e-8), its inside to that over the sine of half its sharpest
// angle, kFlat / 2: 4e-5. Reciprocals are right to 2^-14 = 6.1e-5 at worst: a foot on an edge is off by no
// more of its length, a distance from a plane by half as much of it.
constexpr float kBoundError = 1.25e-4f;

}  // namespace

// Bounds of the distances of a run, from corners rounded to a grid: how many could be the nearest, which,
// and how far they are at least. Lengths are in units of about the size of the block, so that no
// product gets out of the range of float.
unsigned SpatialHash::bound(Ball& q, Entry run, std::uint32_t block, float* at_least,
                            std::uint32_t* slots) const {
  const Children& frame = children_[block];
  const std::uint32_t from = run.first(), n = run.count();
  const auto power = [](int biased) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(biased) << 23);
  };
  const int largest = std::max({frame.exponent[0], frame.exponent[1], frame.exponent[2]});
  const double unit = power(largest), to_unit = power(254 - largest);
  float step[3], x[3], size = 0, off = 0;
  for (int a = 0; a < 3; ++a) {
    step[a] = power(std::max(frame.exponent[a] - largest + 127 - 2, 1));
    x[a] = static_cast<float>((q.from_centre[a] - static_cast<double>(frame.origin[a])) * to_unit);
    size += std::abs(x[a]) + 1024 * step[a];
    off += step[a] * step[a];
  }
  const float error =
      0.501f * std::sqrt(off) + kBoundError * size + static_cast<float>(q.rounding_double * to_unit);
  const float reach = static_cast<float>(std::min(q.reach * to_unit, 1e18)) * (1 + 1e-6f);

  const std::uint32_t* v = &rounded_[3 * std::size_t{from}];
  const Lanes3 a0 = load(v), b0 = load(v + n), c0 = load(v + 2 * n);
  const auto scaled = [&](const Lanes3& l) { return Lanes3{step[0] * l.x, step[1] * l.y, step[2] * l.z}; };
  const auto seen = [&](const Lanes3& l) {
    return Lanes3{step[0] * l.x - x[0], step[1] * l.y - x[1], step[2] * l.z - x[2]};
  };
  const Lanes3 ab = scaled(b0 - a0), bc = scaled(c0 - b0), ca = scaled(a0 - c0);  // exact
  const Lanes3 a = seen(a0), b = seen(b0), c = seen(c0);
  const Lanes zero = {};
  const Lanes ab2 = ab.dot(ab), bc2 = bc.dot(bc), ca2 = ca.dot(ca);
  const Lanes edges =
      lesser(squared_distance_to_segment(a, ab, ab2),
             lesser(squared_distance_to_segment(b, bc, bc2), squared_distance_to_segment(c, ca, ca2)));
  const Lanes3 normal = ca.cross(ab);
  const Lanes normal2 = normal.dot(normal), longest2 = greater(ab2, greater(bc2, ca2));
  const Lanes height = a.dot(normal),
              plane = height * height * detail::inverse(greater(normal2, zero + FLT_MIN));
  // Triple products of a corner, its edge and the normal: (n x b).bc = (n x a).bc + n.n.
  const Lanes3 w = normal.cross(a);
  const Lanes inside = lesser(ab.dot(w), lesser(bc.dot(w) + normal2, ca.dot(w)));
  const Ints flat = normal2 <= kFlat * kFlat * longest2 * longest2;
  const Lanes squared = (inside >= zero) & ~flat ? plane : edges;
  // Of a triangle that is flat no point is farther from its edges than half its least height.
  const float far = reach + error;
  unsigned near = bits((squared <= far * far) | flat) & ((1u << n) - 1);
  if (q.slot - from < n) near &= ~(1u << (q.slot - from));  // known already
  if (near == 0) return 0;
  float distance[kRun], within[kRun], most = FLT_MAX;
  const unsigned flats = bits(flat);
  for (unsigned left = near; left; left &= left - 1) {
    const int i = __builtin_ctz(left);
    distance[i] = std::sqrt(squared[i]);
    within[i] = 0;
    if (flats >> i & 1) within[i] = 0.5f * std::sqrt(normal2[i] / std::max(longest2[i], FLT_MIN));
    most = std::min(most, distance[i] + error);
  }
  q.bring_in(most * unit);
  unsigned found = 0;
  for (; near; near &= near - 1) {
    const int i = __builtin_ctz(near);
    const float least = static_cast<float>(unit) * (distance[i] - within[i] - error);
    if (least > q.reach) continue;
    const std::uint32_t s = from + static_cast<std::uint32_t>(i);
    detail::prefetch(&corners_[s]);
    at_least[found] = least;
    slots[found++] = s;
  }
  return found;
}

[[gnu::always_inline]] inline BoxLanes SpatialHash::Ball::squared_distances(const Children& c) const {
  // The lower faces beside the upper ones; a point is outside one of them at most.
  Lanes squared = {};
  constexpr Lanes kOutward = {1, 1, 1, 1, 1, 1, 1, 1, -1, -1, -1, -1, -1, -1, -1, -1};
  for (int a = 0; a < 3; ++a) {
    const float step = std::bit_cast<float>(static_cast<std::uint32_t>(c.exponent[a]) << 23);
    const Lanes out = greater(kOutward * (step * load(c.box[a]) - (x[a] - c.origin[a])), Lanes{});
    squared += out * out;
  }
  BoxLanes both[2];
  std::memcpy(both, &squared, sizeof both);
  return both[0] + both[1];
}

// Which boxes of a block are within reach, as bits, and their squared distances.
unsigned SpatialHash::expand(const Ball& q, std::uint32_t block, float* d) const {
  const Children& c = children_[block];
  const BoxLanes squared = q.squared_distances(c);
  std::memcpy(d, &squared, sizeof squared);
  return bits(squared <= q.limit) & ((1u << c.count) - 1);
}

detail::Order SpatialHash::Ball::order(const Children& c) const {
  const BoxLanes squared = squared_distances(c);
  constexpr BoxInts kLane = {0, 1, 2, 3, 4, 5, 6, 7};
  const BoxInts out = (squared > limit) | (kLane >= static_cast<int>(c.count));
  return __builtin_convertvector(reinterpret_cast<BoxInts>(squared) >> 16 | out, detail::Order);
}

}  // namespace hawser
