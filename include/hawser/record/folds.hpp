// Where the largest tension of a line is that of an element that has folded and snaps taut.
#pragma once

#include <mpi.h>

#include <span>
#include <string>
#include <vector>

#include "hawser/advice/peaks.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {

// A slack cable takes no compression: its elements become shorter than the line in them, which then bends
// more sharply than elements of this length show. Of a free end that whips the bend, and with it the speed
// and the tension with which it straightens, depends on the mesh.
class Folds {
 public:
  // feeders: null where no line is fed. Fed lines do not count: what is inside is folded up.
  Folds(const model::Case& c, const LocalMesh& mesh, const Feeders* feeders);
  // By owned node: effective tension on the side of end A and of end B, N. After every step.
  void update(const Kinematics& at, std::span<const double> before, std::span<const double> after);
  // After the last step: puts together what the ranks have. Collective.
  void gather(MPI_Comm comm);
  // That the largest tension [N] of a line is of such an element, in words; empty: it is not. After gather().
  std::string warning(int line, const std::string& name, double largest_tension) const;

 private:
  struct Fold {
    double share = 1;  // its shortest chord over its length, while it counts as folded
    double until = 0;  // s, when the waves of its straightening have gone; infinite: not yet straight
    double echo = 0;   // s, of a wave along the line and back
  };
  using Worst = advice::FoldedPeak;
  const LocalMesh& mesh_;
  std::vector<Fold> folds_;   // by element of this rank
  std::vector<Worst> worst_;  // by line
};

}  // namespace hawser::record
