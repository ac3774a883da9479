// Code checks of steel pipes at every step as node fields: local buckling by DNV-ST-F101; bending and tension
// with pressure by API RP 1111 (docs/theory/pipe-codes.md).
#pragma once

#include <mpi.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/io/results.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/support_rollers.hpp"

namespace hawser::record {

// Per line, arc lengths [m] between the supports that carry it, and between its touchdown points; first above
// second: empty.
struct PipePlaces {
  std::vector<std::array<double, 2>> supports, seabed;
};

class PipeStrength : public Recording {
 public:
  // The subject must outlive the object.
  explicit PipeStrength(const Subject& subject);

  // Adds fields for line types with a graded pipe; the DNV field needs functional loads and therefore
  // statics.
  void add_fields(std::vector<Field>& fields) override;
  void declare(Declarations& to) override;
  // At a node between two types the larger value; NaN without a pipe or without known functional loads.
  void fill(const Snapshot& s, Values& values) override;
  // Takes the loads of this state as the functional loads.
  void start(const Snapshot& s) override;

  // Warnings outside the range of the formulas.
  std::vector<Warning> warnings(const std::vector<io::SummaryRow>& summary) override;

  void save(io::Checkpoint& to) override;
  void restore(const io::Checkpoint& from) override;

 private:
  // Pipe on one side of a node, with the position for its pressure.
  struct Side {
    int type = -1;  // index in the case; -1: no pipe
    double arc = 0;
    int line = -1;
  };
  double condition(const Side& side, const PipePlaces& places) const;
  PipeLoads loads(const Values& values, size_t node) const;
  PipePlaces places(const Snapshot& s) const;

  const model::Case& case_;
  const Mesh& mesh_;
  const MPI_Comm comm_;
  std::optional<SupportRollers> rollers_;   // none: no supports
  std::vector<PipeCodes> codes_;            // of graded line types
  std::vector<int> of_type_;                // index in codes_ by line type; -1: none
  std::vector<std::array<Side, 2>> sides_;  // by owned node
  std::vector<PipeLoads> static_loads_;     // by owned node; empty: unknown
  bool by_place_ = false;                   // conditions depend on the support of the pipe
  int tension_ = -1, moment_2_ = -1, moment_3_ = -1, curvature_ = -1;  // indices of fields
  int buckling_ = -1, bending_ = -1, pull_ = -1;
  double pulled_ = 0;  // largest design tension so far over the yield tension
};

}  // namespace hawser::record
