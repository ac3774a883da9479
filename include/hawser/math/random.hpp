// Random numbers that are the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hawser {

// splitmix64 (Steele, Lea and Flood 2014): uniform in (0, 1).
struct Random {
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;
  std::uint64_t state;
  std::uint64_t bits() {
    std::uint64_t z = (state += kStep);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double next() { return (static_cast<double>(bits() >> 11) + 0.5) / 9007199254740992.0; }
};

// The state advances by a constant, so that similar seeds would give the same sequence with a shift.
// Therefore the initial state is itself a random number.
inline Random random_of(std::uint64_t seed) { return {Random{seed}.bits()}; }

// Seed of an independent sequence of the same seed; the 0th is that of the seed itself. The initial states
// of the sequences are successive random numbers.
inline std::uint64_t sequence_seed(std::uint64_t seed, std::size_t index) {
  return seed + index * Random::kStep;
}

}  // namespace hawser
