// Where the elements of a line are too long for the current and the waves that it is in
// (docs/theory/element-length.md).
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

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
  // Case and system outlive it.
  WaterErrors(const model::Case& c, const System& system);

  // At a state of the run; most steps are passed over, since waves are expensive. Collective.
  void update_sampled(const Kinematics& at);
  // At every one. Collective.
  void update(const Kinematics& at);

  // What may be wrong by more than results bear, a sentence each. Collective.
  std::vector<std::string> warnings() const;

  void stage(const Snapshot& s) override { update(s.at); }
  void step(const Snapshot& s) override { update_sampled(s.at); }
  std::vector<Finding> findings(const std::vector<io::SummaryRow>& summary, const Audit& audit) override;

 private:
  struct Where {                                   // the element of this rank with the largest error
    double error = 0, arc = 0, z = 0, length = 0;  // N, m; z from the still water
    double diameter = 0;                           // m
    int line = 0;
    bool crossed = false;  // by the surface
  };
  // Of each group in a state, if its elements are cut into so many parts (LinesInWater::flow_error).
  struct Sums {
    std::vector<double> error, force, weight;  // N, of all ranks; weight in water across the lines
    std::vector<Where> where;
  };
  Sums sums(const Kinematics& at, int parts, const std::vector<bool>& groups) const;
  std::vector<int> sufficient_parts(const Kinematics& at, std::vector<bool> groups) const;
  void update_tension(const Kinematics& at);

  struct Group {                                // lines that joints hold together, which bear a load together
    double force = 0, weight = 0, tension = 0;  // N, the largest
    double error = 0, time = 0;                 // N, s, the worst
    int parts = 1;                              // into which an element is to be cut
    Where where;
    double bears() const;  // N, of error that is of no matter
  };
  MPI_Comm comm_;
  const model::Case& case_;
  const LocalMesh& mesh_;
  const CarriesTension& structure_;
  const LinesInWater* water_;  // null: it does not move
  std::vector<int> group_;     // of each line
  std::vector<Group> groups_;  // as many as lines; some are empty
  int steps_ = 0;              // since the last look in motion
};

}  // namespace hawser::record
