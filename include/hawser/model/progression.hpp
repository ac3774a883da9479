// Lengths of consecutive elements in geometric progression.
#pragma once

#include <compare>

namespace hawser::model {

// Consecutive elements of a section: the k-th has the unstretched length ratio^(index + k) length scale, m.
struct Progression {
  int index = 0, elements = 0;
  double ratio = 1, length = 0, scale = 1;
  auto operator<=>(const Progression&) const = default;

  double element_length(int k) const;
};

}  // namespace hawser::model
