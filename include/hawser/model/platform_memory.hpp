// The memory of the waves that bodies have made by their own motion, from the radiation damping of their
// files.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hawser/kernels/radiation_memory.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/hydrodynamic_data.hpp"

namespace hawser::model {

struct PlatformMemory {
  std::vector<int> rows;                     // of the files' matrices, six for each body
  std::vector<std::pair<int, int>> entries;  // of a matrix of these rows, row <= column, that are not zero
  RadiationMemory memory;                    // of these entries; without entries: of length 0
};
// Of bodies that are one of radiating_groups().
PlatformMemory platform_memory(const Case& c, const std::vector<int>& bodies);

// Such as "surge", of several bodies "float surge".
std::string freedom_name(const Case& c, const std::vector<int>& bodies, int row);

// How far added mass by the damping (Ogilvie 1964) is from that of the files at most, for the freedom where
// this is largest of what its added mass varies by.
struct OgilvieCheck {
  double difference = 0;  // share of the largest |A - A(inf)|
  int freedom = 0;        // of `rows`
  double omega = 0;       // rad/s
};
OgilvieCheck ogilvie_check(const HydrodynamicData& data, const PlatformMemory& of);

}  // namespace hawser::model
