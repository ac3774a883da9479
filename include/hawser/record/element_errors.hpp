// Where the elements of a line are too long for what is asked of its results (docs/theory/element-length.md).
#pragma once

#include <mpi.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hawser/advice/long_elements.hpp"
#include "hawser/base/gather.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {

class ElementErrors : public Recording {
 public:
  // feeders: null where no line is fed. Collective.
  ElementErrors(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh, const Feeders* feeders);

  // Of a state, by owned node of the lines; empty: there is none of it.
  struct Values {
    std::span<const double> tension;  // N, effective
    std::span<const double> moment;   // N m, of beams
    std::span<const double> pressed;  // N, normal force of volumes
    std::vector<bool> carried;        // something touches the line there
  };
  // Collective: a few numbers a node of lines that the partition cuts.
  void update(const Kinematics& at, const Values& values);

  void declare(Declarations& to) override;
  void output(const Snapshot& s) override;
  std::vector<Finding> findings(const std::vector<io::SummaryRow>& summary, const Audit& audit) override;

  // What may be wrong by more than a line of this rank bears, a sentence each: the largest tension [N] and
  // moment [N m] of the run against which errors are judged.
  std::vector<std::string> warnings(int line, double largest_tension, double largest_moment) const;

 private:
  using Worst = advice::LongElements;  // so far, of a line
  struct OfLine {
    Worst sag, bend, lift;
  };
  struct At {  // a node in a state
    Vec3 x = Vec3::Zero();
    double tension = 0, moment = 0, pressed = 0;
    bool carried = false;
  };
  At node(size_t n, const Kinematics& at, const Values& values) const;
  std::vector<At> of_cut_lines(const Kinematics& at, const Values& values) const;
  void update_sag(const LineSpan& line, std::span<const At> nodes, int first, int last, double time,
                  Worst& worst) const;
  void update_lifts(const LineSpan& line, std::span<const At> nodes, int first, int last, double time,
                    Worst& worst) const;
  void update_bends(const LineSpan& line, std::span<const At> nodes, int first, int last, double time,
                    Worst& worst) const;
  const model::LineType& type(const Element& e) const;

  const model::Case& case_;
  const LocalMesh& mesh_;
  const Feeders* feeders_;
  MPI_Comm comm_;
  LineOwners owners_;
  std::vector<int> cut_nodes_;                     // of this rank, of lines that are cut
  GatherPlan plan_;                                // of their numbers
  std::vector<OfLine> lines_;                      // of lines of this rank and those that are cut
  int tension_ = -1, moment_ = -1, pressed_ = -1;  // among the fields
  std::vector<std::pair<int, int>> touches_;  // likewise with components: not zero where something touches
};

}  // namespace hawser::record
