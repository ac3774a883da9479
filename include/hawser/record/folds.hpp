// Detection of lines whose largest tension occurs in an element that folds and snaps taut.
#pragma once

#include <mpi.h>

#include <span>
#include <string>
#include <vector>

#include "hawser/advice/peaks.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/mesh/per_line.hpp"
#include "hawser/model/case.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {

// A slack cable has no compression: its elements become shorter than the line in them, which bends more
// sharply than elements of this length can represent. At a whipping free end the bend, its speed and the
// tension on straightening depend on the mesh.
class Folds {
 public:
  // feeders: null if no line is fed. Fed lines are excluded because the stock is folded up.
  Folds(const model::Case& c, const LocalMesh& mesh, const Feeders* feeders);
  // By owned node: effective tension towards end A and towards end B, N. After every step.
  void update(const Kinematics& state, std::span<const double> before, std::span<const double> after);
  // Combines the ranks after the last step. Collective.
  void gather(MPI_Comm comm);
  // Sentence if the largest tension [N] of a line is that of such an element; else empty. After gather(), for
  // a line of this rank.
  std::string warning(int line, const std::string& name, double largest_tension) const;

 private:
  struct Fold {
    double ratio = 1;  // smallest chord over length while folded
    // s, end of the waves from its straightening; infinite: folded and not yet straight; 0: not folded.
    double waves_end = 0;
    // s, travel time of a wave along the line and back; 0: a beam or a fed line, not observed.
    double round_trip_time = 0;
  };
  using Worst = advice::FoldedPeak;
  const LocalMesh& mesh_;
  std::vector<Fold> folds_;  // by element of this rank
  PerLine<Worst> worst_;
};

}  // namespace hawser::record
