// Keys of the cells of the spatial hash.
#pragma once

#include <cstdint>

namespace hawser::detail {

constexpr int kMaxLevels = 20;  // 3 x 20 bits of key and a leading one fit 64

// Spread the lowest 21 bits of x, or of each lane, to every third bit.
template <class T>
inline T spread(T x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

inline std::uint64_t morton(std::uint64_t i, std::uint64_t j, std::uint64_t k) {
  return spread(i) | spread(j) << 1 | spread(k) << 2;
}

// Place of a key in a table: four neighbours side by side.
inline std::uint64_t scramble(std::uint64_t key) {
  std::uint64_t k = key >> 2;
  k ^= k >> 31;
  k *= 0x7fb5d329728ea185ull;
  k ^= k >> 27;
  return k << 2 | (key & 3);
}

}  // namespace hawser::detail
