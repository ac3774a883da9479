// Warnings of elements that are too long for the current and waves around them
// (docs/theory/element-length.md).
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/base/runs.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/system.hpp"

namespace hawser {
class LinesInWater;
}

namespace hawser::record {

class WaterErrors : public Recording {
 public:
  // Case and system must outlive the object.
  WaterErrors(const model::Case& c, const System& system);

  // Update at a state of the run; most steps are skipped because waves are expensive. Collective.
  void update_sampled(const Kinematics& state);
  // Update at every state. Collective.
  void update(const Kinematics& state);

  // One sentence per significant error, the same on all ranks. Collective.
  std::vector<std::string> warnings() const;

  void stage(const Snapshot& s) override { update(s.at); }
  void step(const Snapshot& s) override { update_sampled(s.at); }
  std::vector<Warning> warnings(const std::vector<io::SummaryRow>& summary) override;

 private:
  struct Where {                                   // element of this rank with the largest error
    double error = 0, arc = 0, z = 0, length = 0;  // N, m; z relative to the still water
    double diameter = 0;                           // m
    int line = 0;
    bool crossed = false;  // by the surface
  };
  // Sums by group for a state, with each element cut into `parts` (LinesInWater::flow_error).
  struct Sums {
    std::vector<double> error, force, weight;  // N, of all ranks; submerged weight across the lines
    std::vector<Where> where;
  };
  Sums sums(const Kinematics& state, int parts, const std::vector<bool>& groups) const;
  std::vector<int> sufficient_parts(const Kinematics& state, std::vector<bool> groups) const;
  void update_tension(const Kinematics& state);

  struct Group {                                // lines connected by joints, which share loads
    double force = 0, weight = 0, tension = 0;  // N, largest values
    double error = 0, time = 0;                 // N, s, worst case
    int parts = 1;                              // into which an element should be cut
    int first = 0, lines = 0;                   // first of the lines, and their number
    Where where;
    double negligible_error() const;  // N
  };
  std::string warning(const Group& g, const Where& w) const;
  MPI_Comm comm_;
  const model::Case& case_;
  const LocalMesh& mesh_;
  const HasAxialStiffness& structure_;
  const LinesInWater* water_;  // null: it does not move
  Runs<int> group_;            // of each line, by place in groups_; -1: another rank has all of it
  std::vector<Group> groups_;  // those that several ranks have, equal on all, then others of this rank
  size_t shared_ = 0;          // how many ranks share
  int steps_ = 0;              // since the last evaluation in motion
};

}  // namespace hawser::record
