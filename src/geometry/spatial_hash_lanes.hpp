// The vector unit's lanes, for the spatial hash: eight boxes of a block, up to fifteen triangles of a run.
//
// What a search finds next is hard to foresee, so lists are filled without branches: all lanes are written
// and only those wanted are counted.
#pragma once

#ifdef __SSE4_1__
#include <immintrin.h>
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "hawser/math/types.hpp"

namespace hawser::detail {

template <class T, int n>
using Vector [[gnu::vector_size(sizeof(T) * n)]] = T;
constexpr int kBoxes = 8, kRun = 16;
using Lanes = Vector<float, kRun>;
using Ints = Vector<std::int32_t, kRun>;
using BoxLanes = Vector<float, kBoxes>;
using BoxInts = Vector<std::int32_t, kBoxes>;
using BoxWords = Vector<std::uint64_t, kBoxes>;

// The three coordinates and a lane that is idle.
using Axes = Vector<double, 4>;
using AxesFloats = Vector<float, 4>;
using AxesInts = Vector<std::int32_t, 4>;
using AxesWords = Vector<std::uint64_t, 4>;
inline Axes axes(const Vec3& v) { return Axes{v[0], v[1], v[2], 0}; }

// Lanes that are all ones, as bits.
#ifdef __AVX512VL__
inline unsigned bits(BoxInts which) {
  return _mm256_cmplt_epi32_mask(reinterpret_cast<__m256i>(which), _mm256_setzero_si256());
}
inline unsigned bits(Ints which) {
  return _mm512_cmplt_epi32_mask(reinterpret_cast<__m512i>(which), _mm512_setzero_si512());
}
inline unsigned not_zero(BoxWords v) {
  const auto w = reinterpret_cast<__m512i>(v);
  return _mm512_test_epi64_mask(w, w);
}
#else
inline unsigned bits(std::uint64_t bytes) {
  return static_cast<unsigned>((bytes & 0x8040201008040201u) * 0x0101010101010101u >> 56);
}
inline unsigned bits(BoxInts which) {
  const auto bytes = __builtin_convertvector(which, Vector<std::int8_t, kBoxes>);
  std::uint64_t u;
  std::memcpy(&u, &bytes, 8);
  return bits(u);
}
inline unsigned bits(Ints which) {
  const auto bytes = __builtin_convertvector(which, Vector<std::int8_t, kRun>);
  std::uint64_t u[2];
  std::memcpy(u, &bytes, 16);
  return bits(u[0]) | bits(u[1]) << 8;
}
inline unsigned not_zero(BoxWords v) { return bits(__builtin_convertvector(v != 0, BoxInts)); }
#endif

template <class T>
T lesser(T a, T b) {
  return a < b ? a : b;
}
template <class T>
T greater(T a, T b) {
  return a > b ? a : b;
}

// Boxes in the order of their squared distances: the upper halves of these as floats, to 1/128 too small.
constexpr std::uint16_t kNoBox = 0xffff;  // there is none, or it has been looked at
using Order = Vector<std::uint16_t, kBoxes>;
struct Least {
  unsigned value, lane;
};
inline Least least(Order o) {
#ifdef __SSE4_1__
  const auto m = static_cast<unsigned>(_mm_cvtsi128_si32(_mm_minpos_epu16(reinterpret_cast<__m128i>(o))));
  return {m & 0xffff, m >> 16};
#else
  Least l{o[0], 0};
  for (unsigned k = 1; k < kBoxes; ++k)
    if (o[k] < l.value) l = {o[k], k};
  return l;
#endif
}

// To 2^-14 of it at worst.
#ifdef __AVX512VL__
inline Lanes inverse(Lanes v) { return _mm512_rcp14_ps(v); }
#else
inline Lanes inverse(Lanes v) { return 1 / v; }
#endif

// Writes the lanes told by `which` side by side; as many as there are lanes are overwritten.
#ifdef __AVX512VL__
[[gnu::always_inline]] inline void keep(unsigned which, BoxWords v, std::uint64_t* at) {
  _mm512_storeu_si512(
      at, _mm512_maskz_compress_epi64(static_cast<__mmask8>(which), reinterpret_cast<__m512i>(v)));
}
[[gnu::always_inline]] inline void keep(unsigned which, BoxLanes v, float* at) {
  _mm256_storeu_ps(at, _mm256_maskz_compress_ps(static_cast<__mmask8>(which), v));
}
#else
template <class V, class T>
void keep(unsigned which, V v, T* at) {
  for (unsigned k = 0; k < sizeof(V) / sizeof(T); ++k) {
    *at = static_cast<T>(v[k]);
    at += which >> k & 1;
  }
}
#endif

// Eight times the same.
template <class T>
[[gnu::always_inline]] inline void fill8(T value, T* at) {
  const Vector<T, 8> v = Vector<T, 8>{} + value;
  std::memcpy(at, &v, sizeof v);
}

inline unsigned count_bits(unsigned which) { return static_cast<unsigned>(__builtin_popcount(which)); }

}  // namespace hawser::detail
