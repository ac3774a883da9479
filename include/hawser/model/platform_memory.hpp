// The memory of the waves that bodies have made by their own motion, from the radiation damping of their
// files.
#pragma once

#include <utility>
#include <vector>

#include "hawser/kernels/radiation_memory.hpp"
#include "hawser/model/case.hpp"

namespace hawser::model {

struct PlatformMemory {
  std::vector<int> rows;                     // of the files' matrices, six for each body
  std::vector<std::pair<int, int>> entries;  // of a matrix of these rows, row <= column, that are not zero
  RadiationMemory memory;                    // of these entries; without entries: of length 0
};
// Of bodies that are one of radiating_groups().
PlatformMemory platform_memory(const Case& c, const std::vector<int>& bodies);

}  // namespace hawser::model
