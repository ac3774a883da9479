// What straight elements that lie across edges of volumes do to the tension of a line
// (docs/theory/element-length.md, "Edges"), evaluated after every step and reported at once.
#pragma once

#include <mpi.h>

#include <span>
#include <string>
#include <vector>

#include "hawser/advice/long_elements.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/pressed_stretch.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/snaps.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser::record {

class EdgeErrors : public Recording {
 public:
  EdgeErrors(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh);

  // Of a state, by owned node; vectors in three components each.
  struct Values {
    std::span<const double> force, friction;  // N, of volumes, friction among it
    std::span<const double> before, after;    // N, effective tension on the side of end A and of end B
  };
  // Ranks that share a line exchange one summary for each stretch of it that a rank owns. Collective.
  void update(const Kinematics& at, const Values& values);
  // A sentence where the worst error so far [N] is more than is allowed of the given tension [N]; empty: it
  // is not.
  std::string warning(int line, double largest_tension) const;

  std::span<const Snaps::OverVolume> over_volumes() const { return over_; }  // by line

  void declare(Declarations& to) override;
  void step(const Snapshot& s) override;
  std::vector<std::string> remarks() override;
  std::vector<Finding> findings(const std::vector<io::SummaryRow>& summary, const Audit& audit) override;

 private:
  struct Neighbours {
    int before = -1, after = -1;  // local nodes, where the elements on both sides are cables
    double length = 0;            // m, of the longer of these elements
  };
  struct Piece {  // consecutive nodes of a line that one rank owns
    int line = 0, rank = 0;
    int first = 0, last = 0;  // of the mesh
  };
  struct Sharer {  // another rank that owns nodes of the same lines
    int rank = 0;
    std::vector<size_t> send, receive;  // pieces
  };
  std::vector<PressedTurn> turns(const Kinematics& at, const Values& values) const;
  const model::LineType& type_at(int node) const;  // of a node between two elements: of the one behind it
  void exchange(std::vector<PressedStretch>& of_pieces) const;
  void report(int line, const PressedStretch& whole, double time);
  void gather();

  MPI_Comm comm_;
  const model::Case& case_;
  const LocalMesh& mesh_;
  std::vector<Piece> pieces_;           // of the lines of which this rank owns nodes, in the order of nodes
  std::vector<Sharer> sharers_;         // by rank
  std::vector<Neighbours> neighbours_;  // by owned node
  struct Worst {
    advice::LongElements at;
    double turn_of_element = 0;  // rad, at both ends of an element together
  };
  // By line: known where this rank owns nodes of it, and everywhere after gather().
  std::vector<Worst> worst_;
  std::vector<double> tension_;   // N, by line: the largest so far where volumes press
  std::vector<double> reported_;  // by line, N: the error that has been reported
  std::vector<Snaps::OverVolume> over_;
  std::vector<std::string> new_warnings_;
  int force_ = -1, friction_ = -1, before_ = -1, after_ = -1;  // among the fields
};

}  // namespace hawser::record
