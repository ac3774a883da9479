// The vector unit's lanes, for pairs of boxes: eight boxes that lie one behind the other. Whether two boxes
// overlap is hard to foresee, so pairs are written without branches.
#pragma once

#ifdef __AVX512VL__
#include <immintrin.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace hawser::detail {

constexpr std::size_t kPairLanes = 8;

// Of eight keys in ascending order.
struct KeyRange {
  std::size_t below, within;  // how many are less than the low one, and how many of the others up to the high
};

// A box and its number, to be tested against others.
#ifdef __AVX512VL__
inline KeyRange key_range(const std::uint64_t* keys, std::uint64_t low, std::uint64_t high) {
  const __m512i k = _mm512_loadu_si512(keys);
  const unsigned less = _mm512_cmplt_epu64_mask(k, _mm512_set1_epi64(static_cast<long long>(low)));
  const unsigned to = _mm512_cmple_epu64_mask(k, _mm512_set1_epi64(static_cast<long long>(high)));
  const auto below = static_cast<std::size_t>(__builtin_popcount(less));
  return {below, static_cast<std::size_t>(__builtin_popcount(to)) - below};
}

class BoxProbe {
 public:
  BoxProbe(const std::array<float, 3>& lo, const std::array<float, 3>& hi, std::uint32_t number)
      : number_(_mm256_set1_epi32(static_cast<int>(number))) {
    for (std::size_t k = 0; k < 3; ++k) lo_[k] = _mm256_set1_ps(lo[k]), hi_[k] = _mm256_set1_ps(hi[k]);
  }
  // Pairs with the first `count` of eight boxes. Writes eight and returns how many of them are pairs.
  [[gnu::always_inline]] std::size_t test(const std::array<const float*, 6>& face,
                                          const std::uint32_t* numbers, std::size_t from, std::size_t count,
                                          std::uint64_t* to) const {
    __mmask8 which = static_cast<__mmask8>((1u << count) - 1);
    for (std::size_t k = 0; k < 3; ++k) {
      which = _mm256_mask_cmp_ps_mask(which, _mm256_loadu_ps(face[k] + from), hi_[k], _CMP_LE_OQ);
      which = _mm256_mask_cmp_ps_mask(which, lo_[k], _mm256_loadu_ps(face[k + 3] + from), _CMP_LE_OQ);
    }
    const __m256i n = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers + from));
    const __m512i pairs =
        _mm512_or_si512(_mm512_slli_epi64(_mm512_cvtepu32_epi64(_mm256_min_epu32(n, number_)), 32),
                        _mm512_cvtepu32_epi64(_mm256_max_epu32(n, number_)));
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi64(which, pairs));
    return static_cast<std::size_t>(__builtin_popcount(which));
  }

 private:
  __m256 lo_[3], hi_[3];
  __m256i number_;
};
#else
inline KeyRange key_range(const std::uint64_t* keys, std::uint64_t low, std::uint64_t high) {
  KeyRange r{0, 0};
  for (std::size_t k = 0; k < kPairLanes; ++k) {
    r.below += keys[k] < low;
    r.within += (keys[k] >= low) & (keys[k] <= high);
  }
  return r;
}

class BoxProbe {
 public:
  BoxProbe(const std::array<float, 3>& lo, const std::array<float, 3>& hi, std::uint32_t number)
      : lo_(lo), hi_(hi), number_(number) {}
  std::size_t test(const std::array<const float*, 6>& face, const std::uint32_t* numbers, std::size_t from,
                   std::size_t count, std::uint64_t* to) const {
    std::size_t n = 0;
    for (std::size_t i = from; i < from + count; ++i) {
      bool overlap = true;
      for (std::size_t k = 0; k < 3; ++k) overlap &= (face[k][i] <= hi_[k]) & (lo_[k] <= face[k + 3][i]);
      to[n] = std::uint64_t{std::min(numbers[i], number_)} << 32 | std::max(numbers[i], number_);
      n += overlap;
    }
    return n;
  }

 private:
  std::array<float, 3> lo_, hi_;
  std::uint32_t number_;
};
#endif

}  // namespace hawser::detail
