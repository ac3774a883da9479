// Tension errors of straight elements across edges of volumes and over lines (docs/theory/element-length.md,
// "Edges"), evaluated after every step and reported at the next output.
#pragma once

#include <mpi.h>

#include <span>
#include <string>
#include <vector>

#include "hawser/advice/long_elements.hpp"
#include "hawser/base/exchange.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/mesh/per_line.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/pressed_part.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/snaps.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser::record {

class EdgeErrors : public Recording {
 public:
  EdgeErrors(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh);

  // State by owned node; vectors have three components each.
  struct Values {
    std::span<const double> force, friction;  // N, contact force of volumes, including friction
    std::span<const double> before, after;    // N, effective tension towards end A and towards end B
    // N, contact force of lines, including friction; empty: none.
    std::span<const double> line_force{}, line_friction{};
  };
  // Ranks that share a line exchange one summary per part that a rank owns. Collective.
  void update(const Kinematics& state, const Values& values);
  // Sentence if the largest error so far [N] exceeds the allowed fraction of the given tension [N]; else
  // empty. For a line of this rank.
  std::string warning(int line, double largest_tension) const;

  const PerLine<Snaps::VolumePassage>& volume_passages() const { return passages_; }

  void declare(Declarations& to) override;
  void step(const Snapshot& s) override;
  void output(const Snapshot& s) override;
  std::vector<std::string> remarks() override;
  std::vector<Warning> warnings(const std::vector<io::SummaryRow>& summary) override;

 private:
  struct Neighbours {
    int before = -1, after = -1;  // local nodes; -1 unless the adjacent elements are cables
    double length = 0;            // m, longer adjacent element
  };
  struct NodesOfLine {  // consecutive nodes of a line on one rank
    int line = 0, rank = 0;
    int first = 0, last = 0;  // node numbers of the mesh
  };
  struct OfLine {
    advice::LongElements at;     // largest error so far
    double turn_of_element = 0;  // rad, sum over both ends of an element there
    double sharp_turn = 0;       // rad, the same at a sharp edge; 0: the turn is even
    double tension = 0;          // N, largest so far
    bool reported = false;       // during the run; the end of the run reports the largest error
  };
  std::vector<PressedTurn> turns(const Kinematics& state, const Values& values) const;
  const model::LineType& type_at(int node) const;  // type of the element after the node
  void update_worst(int line, const PressedPart& of_line, double time);
  static bool exceeds(const OfLine& of_line, double largest_tension);
  static std::string warning(const std::string& name, const OfLine& of_line, double largest_tension);

  MPI_Comm comm_;
  const model::Case& case_;
  const LocalMesh& mesh_;
  // Of lines with nodes on this rank that may have contact, in the order of nodes.
  std::vector<NodesOfLine> pieces_;
  IndicesByRank shared_;                // indices of pieces of the same lines on other ranks
  std::vector<Neighbours> neighbours_;  // by owned node
  PerLine<OfLine> lines_;               // the same on all ranks that share a line
  PerLine<Snaps::VolumePassage> passages_;
  std::vector<std::string> new_warnings_;
  int force_ = -1, friction_ = -1, line_force_ = -1, line_friction_ = -1;  // indices of fields
  int before_ = -1, after_ = -1;
};

}  // namespace hawser::record
