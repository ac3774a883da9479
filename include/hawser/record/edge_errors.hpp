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
  // Collective: a few numbers a node that volumes press on, of lines that the partition cuts.
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
  struct Turn {  // of a line at a node that a volume presses on
    int node = 0;
    double angle = 0, taken = 0, tension = 0, length = 0;  // rad, N, N, m; taken: of the tension
  };
  std::vector<Turn> turns(const Kinematics& at, const Values& values) const;
  const model::LineType& type_at(int node) const;  // of a node between two elements: of the one behind it
  std::vector<Turn> with_cut_lines(std::vector<Turn> turns) const;
  void gather();

  MPI_Comm comm_;
  const model::Case& case_;
  const LocalMesh& mesh_;
  std::vector<int> cut_;                // lines that the partition cuts
  std::vector<Neighbours> neighbours_;  // by owned node
  struct Worst {
    advice::LongElements at;
    double turn_of_element = 0;  // rad, at both ends of an element together
  };
  // By line, as far as this rank has nodes of it or the ranks have put together what they have.
  std::vector<Worst> worst_;
  std::vector<double> tension_;   // N, by line: the largest so far where volumes press
  std::vector<double> reported_;  // by line, N: the error that has been reported
  std::vector<Snaps::OverVolume> over_;
  std::vector<std::string> new_warnings_;
  int force_ = -1, friction_ = -1, before_ = -1, after_ = -1;  // among the fields
};

}  // namespace hawser::record
