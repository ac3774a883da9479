// Steel pipes by codes at every step, as node fields: local buckling by DNV-ST-F101, bending and tension with
// pressure by API RP 1111 (docs/theory/pipe-codes.md).
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
#include "hawser/record/touchdown.hpp"

namespace hawser::record {

// Of each line, m of arc length: between the supports that carry it, and between its touchdown points; first
// above second: nothing.
struct PipePlaces {
  std::vector<std::array<double, 2>> supports, seabed;
};

class PipeStrength : public Recording {
 public:
  // The subject outlives it.
  explicit PipeStrength(const Subject& subject);

  // Where a line type has a pipe with a grade; the field of DNV, which needs functional loads, where the case
  // has statics.
  void add_fields(std::vector<Field>& fields) override;
  void declare(Declarations& to) override;
  // Of a node between two types the larger; NaN where there is no pipe, and where no functional loads are
  // known.
  void fill(const Snapshot& s, Values& values) override;
  // The loads of this state are the functional ones from now on.
  void start(const Snapshot& s) override;

  // What the formulas are not for.
  std::vector<Finding> findings(const std::vector<io::SummaryRow>& summary, const Audit& audit) override;

  void save(io::Checkpoint& to) override;
  void restore(const io::Checkpoint& from) override;

 private:
  // The pipe on one side of a node, and the pressure of what it contains.
  struct Side {
    int type = -1;  // of the case; -1: no pipe
    double arc = 0;
    int line = -1;
  };
  double condition(const Side& side, const PipePlaces& places) const;
  PipeLoads loads(const Values& values, size_t node) const;
  PipePlaces places(const Snapshot& s) const;

  const model::Case& case_;
  const Mesh& mesh_;
  const MPI_Comm comm_;
  Touchdowns touchdowns_;
  std::optional<SupportRollers> rollers_;   // none: the case has no supports
  std::vector<PipeCodes> codes_;            // of the line types that have a grade
  std::vector<int> of_type_;                // which of them a type has; -1: none
  std::vector<std::array<Side, 2>> sides_;  // by owned node
  std::vector<PipeLoads> rest_;             // likewise; empty: not known
  bool by_place_ = false;                   // conditions depend on what carries a pipe
  int tension_ = -1, moment_2_ = -1, moment_3_ = -1, curvature_ = -1;  // among the fields
  int buckling_ = -1, bending_ = -1, pull_ = -1;
  double pulled_ = 0;  // the largest design tension so far, of that at yield
};

}  // namespace hawser::record
