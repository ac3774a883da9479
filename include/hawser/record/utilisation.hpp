// How much of what line types bear is used: effective tension over the breaking load, and the minimum bend
// radius times the curvature, as node fields.
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

  // Adds `utilisation` and `bend_utilisation` behind the fields they are made from, each where a line type
  // says what it bears; bending where beams are.
  void add_fields(std::vector<Field>& fields) override;
  // Of a node between two types the larger tension utilisation of both
  // sides; the curvature there with the larger radius.
  void fill(const Snapshot& s, Values& values) override;
  // Whether the field is none of these, or says something at an owned node: what the type there bears is
  // known.
  bool known(int field, std::size_t node) const;

 private:
  std::vector<std::array<double, 2>> breaking_;  // 1/N, of the elements before and after a node; 0: not known
  std::vector<double> radius_;                   // m; 0: not known
  bool tension_ = false, bending_ = false;       // wanted
  int before_ = -1, after_ = -1, curvature_ = -1, of_tension_ = -1, of_bending_ = -1;  // among the fields
};

}  // namespace hawser::record
