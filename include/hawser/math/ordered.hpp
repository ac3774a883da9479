// Two values in their order.
#pragma once

#include <utility>

namespace hawser {

// The smaller one first. By value: what std::minmax gives refers to its arguments, which may be gone.
template <class T>
std::pair<T, T> ordered(T a, T b) {
  return b < a ? std::pair<T, T>(b, a) : std::pair<T, T>(a, b);
}

}  // namespace hawser
