// Radiation memory of bodies, computed from the radiation damping in their files.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hawser/kernels/radiation_memory.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/hydrodynamic_data.hpp"

namespace hawser::model {

struct PlatformMemory {
  std::vector<int> rows;                     // indices into the matrices of the files, six per body
  std::vector<std::pair<int, int>> entries;  // nonzero entries of a matrix of these rows, row <= column
  RadiationMemory memory;                    // of these entries; of length 0 without entries
};
// For the bodies of one of radiating_groups().
PlatformMemory platform_memory(const Case& c, const std::vector<int>& bodies);

// Computes the memories of several groups, and that of groups with equal files only once.
class PlatformMemories {
 public:
  std::shared_ptr<const PlatformMemory> of(const Case& c, const std::vector<int>& bodies);

 private:
  // By the data and the rows of the bodies in its matrices.
  std::map<std::pair<const HydrodynamicData*, std::vector<int>>, std::shared_ptr<const PlatformMemory>>
      computed_;
};

// Name such as "surge"; with several bodies "float surge".
std::string freedom_name(const Case& c, const std::vector<int>& bodies, int row);

// Largest difference between added mass from damping (Ogilvie 1964) and that in the files, relative to the
// variation of the latter, for the degree of freedom where it is largest.
struct OgilvieCheck {
  double difference = 0;  // share of the largest |A - A(inf)|
  int freedom = 0;        // index into `rows`
  double omega = 0;       // rad/s
};
OgilvieCheck ogilvie_check(const HydrodynamicData& data, const PlatformMemory& radiation);

}  // namespace hawser::model
