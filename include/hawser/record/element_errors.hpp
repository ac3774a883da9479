// Warnings of elements that are too long for the results of a line (docs/theory/element-length.md).
#pragma once

#include <mpi.h>

#include <span>
#include <string>
#include <vector>

#include "hawser/advice/energy.hpp"
#include "hawser/advice/long_elements.hpp"
#include "hawser/base/exchange.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/mesh/per_line.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/terms/feeders.hpp"
#include "hawser/terms/line_pairs.hpp"

namespace hawser::record {

class ElementErrors : public Recording {
 public:
  // feeders: null if no line is fed. pairs: null without contact between lines. Collective.
  ElementErrors(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh, const Feeders* feeders,
                const LinePairs* pairs = nullptr);

  // Contact between two lines, or of a line with itself, as far as this rank counts it.
  struct LineContact {
    int line = 0, other = 0;  // the smaller index first
    double force = 0;         // N, sum of the magnitudes of the normal forces
  };
  // State by owned node of the lines; empty: not available.
  struct Values {
    std::span<const double> tension;  // N, effective
    std::span<const double> moment;   // N m, of beams
    std::vector<bool> pressed;        // true where volumes or lines touch the line; empty: nowhere
    std::vector<bool> supported;      // true where contact acts on the line
    std::vector<bool> on_volume{};    // true where volumes touch the line; empty: nowhere
    std::vector<bool> on_line{};      // true where lines touch the line; empty: nowhere
    std::vector<LineContact> contacts{};
  };
  // For lines that the partition cuts, the ranks that share a line send a few numbers per node to the owner
  // of its first node. Lines in contact with lines are gathered. Collective.
  void update(const Kinematics& state, const Values& values);

  void declare(Declarations& to) override;
  void output(const Snapshot& s) override;
  std::vector<Warning> warnings(const std::vector<io::SummaryRow>& summary) override;

  // One sentence per significant error of a line of this rank, relative to the largest tension [N] and moment
  // [N m] of the run.
  std::vector<std::string> warnings(int line, double largest_tension, double largest_moment) const;

 private:
  using Worst = advice::LongElements;  // largest so far, per line
  struct OfLine {
    bool held = false;  // at both ends, so that the tension depends on the length
    Worst sag, corner, bend, lift;
  };
  struct At {  // node of a state
    Vec3 x = Vec3::Zero();
    double tension = 0, moment = 0;
    bool pressed = false, supported = false;
    bool two_sided = false;  // Node::two_sided
    bool on_volume = false;
    bool on_line = false;
  };
  struct InState {  // line in a state
    const LineSpan& line;
    std::span<const At> nodes;
    std::span<const Element> elements;
    int first;  // nodes at the ends of what is outside of feeders
    int last;
    double time;  // s
  };
  struct Corners {  // excess over volumes and over lines, without errors
    Worst over_volumes, over_lines;
  };
  struct OverLines {  // held line in contact with lines, in a state
    int line = 0;
    Worst corner;                        // over lines
    double tension = 0, compliance = 0;  // N; m, T dl/dT
  };
  At node(size_t n, const Kinematics& state, const Values& values) const;
  // Adds the line to `over_lines` if it is held and lines touch it.
  void update_sag(const InState& s, OfLine& worst, std::vector<OverLines>& over_lines) const;
  // An element that touches both counts as over volumes.
  Corners corners(const InState& s) const;
  // Collective.
  void update_over_lines(const std::vector<OverLines>& local, const std::vector<LineContact>& contacts);
  void update_lifts(const InState& s, Worst& worst) const;
  void update_bends(const InState& s, OfLine& of_line) const;
  const model::LineType& type(const Element& e) const;
  double arc(const LineSpan& line, int node) const;  // m, of the line's node

  const model::Case& case_;
  const LocalMesh& mesh_;
  const Feeders* feeders_;
  const bool volumes_are_held_;
  const LinePairs* pairs_ = nullptr;  // null unless a line that may touch lines is held at both ends
  MPI_Comm comm_;
  // Lines with all nodes on this rank; cut lines whose first node this rank owns, and their number of nodes.
  std::vector<int> uncut_, cut_;
  size_t cut_nodes_ = 0;
  // Sent: local nodes of lines whose first node the other rank owns. Received: places of its nodes among the
  // nodes of cut_.
  IndicesByRank shared_;
  PerLine<OfLine> lines_;           // valid on the rank that owns the first node
  int tension_ = -1, moment_ = -1;  // indices of fields
  struct TouchField {               // field with components that are nonzero in contact
    int index = 0, components = 1;
    advice::ContactWith with = advice::ContactWith::nothing;
  };
  std::vector<TouchField> touches_;
};

}  // namespace hawser::record
