// Utilisation of line types as node fields: effective tension over breaking load, and minimum bend radius
// times curvature.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/recording.hpp"

namespace hawser::record {

class Utilisation : public Recording {
 public:
  Utilisation(const model::Case& c, const LocalMesh& local);

  // Adds `utilisation` and `bend_utilisation` after the fields they use, if a line type has the limit; the
  // latter only with beams.
  void add_fields(std::vector<Field>& fields) override;
  // At a node between two types: the larger tension utilisation of both sides, and the curvature with the
  // larger minimum radius.
  void fill(const Snapshot& s, Values& values) override;
  // True unless the field is a utilisation without a limit at this owned node.
  bool known(int field, std::size_t node) const;

 private:
  std::vector<std::array<double, 2>> breaking_;  // 1/N, of the elements before and after a node; 0: unknown
  std::vector<double> radius_;                   // m; 0: unknown
  bool tension_ = false, bending_ = false;       // fields exist
  int before_ = -1, after_ = -1, curvature_ = -1, of_tension_ = -1, of_bending_ = -1;  // indices of fields
};

}  // namespace hawser::record
