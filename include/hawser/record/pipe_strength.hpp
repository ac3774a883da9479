// Steel pipes by codes at every step, as node fields: local buckling by DNV-ST-F101, bending and tension with
// pressure by API RP 1111 (docs/theory/pipe-codes.md).
#pragma once

#include <mpi.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/io/results.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"

namespace hawser::record {

// Of each line, m of arc length: between the supports that carry it, and between its touchdown points; first
// above second: nothing.
struct PipePlaces {
  std::vector<std::array<double, 2>> supports, seabed;
};

class PipeStrength {
 public:
  PipeStrength(const model::Case& c, const LocalMesh& mesh);

  // Adds fields behind those they are made from, where a line type has a pipe with a grade; that of DNV,
  // which needs functional loads, where the case has statics.
  void add_fields(std::vector<Field>& fields);
  // Whether they are made from a field.
  bool wants(std::string_view field) const;
  bool wants_places() const { return places_; }

  // The loads of these values, by field and owned node, are the functional ones from now on: a state at rest.
  void rest(const std::vector<std::vector<double>>& values);
  // values: with positions first. Of a node between two types the larger; NaN where there is no pipe, and
  // where no functional loads are known.
  void fill(std::vector<std::vector<double>>& values, const PipePlaces& places);

  // What the formulas are not for, at the end of a run; on all ranks. Collective.
  std::vector<std::string> warnings(MPI_Comm comm) const;

  void save(io::Checkpoint& to) const;
  void restore(const io::Checkpoint& from);

 private:
  // The pipe on one side of a node, and the pressure of what it contains.
  struct Side {
    int type = -1;  // of the case; -1: no pipe
    double arc = 0;
    int line = -1;
  };
  double condition(const Side& side, const PipePlaces& places) const;
  PipeLoads loads(const std::vector<std::vector<double>>& values, size_t node) const;

  const model::Case& case_;
  std::vector<PipeCodes> codes_;            // of the line types that have a grade
  std::vector<int> of_type_;                // which of them a type has; -1: none
  std::vector<std::array<Side, 2>> sides_;  // by owned node
  std::vector<PipeLoads> rest_;             // likewise; empty: not known
  bool places_ = false;
  int tension_ = -1, moment_2_ = -1, moment_3_ = -1, curvature_ = -1;  // among the fields
  int buckling_ = -1, bending_ = -1, pull_ = -1;
  double pulled_ = 0;  // the largest design tension so far, of that at yield
};

}  // namespace hawser::record
