// Two values in ascending order.
#pragma once

#include <utility>

namespace hawser {

// Returned by value, because the references of std::minmax may dangle.
template <class T>
std::pair<T, T> ordered(T a, T b) {
  return b < a ? std::pair<T, T>(b, a) : std::pair<T, T>(a, b);
}

}  // namespace hawser
