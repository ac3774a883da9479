// Table of extremes: for each line the largest (or smallest) value of some fields over all steps, with time
// and place.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/io/results.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/mesh/per_line.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/utilisation.hpp"

namespace hawser {
class Feeders;
}

namespace hawser::record {

// True if a row of the summary is the largest tension of a line and exceeds round-off.
bool is_largest_tension(const model::Case& c, const io::SummaryRow& row);

class LineExtremes : public Recording {
 public:
  // Unknown utilisations and parts inside a feeder are excluded. Both arguments must outlive the object.
  LineExtremes(const Subject& subject, const Utilisation& utilisation);

  void declare(Declarations& to) override;
  void step(const Snapshot& s) override;
  // Grouped by line.
  std::vector<io::SummaryRow> summary() override;
  // Warnings for rows beyond the capacity of a line.
  std::vector<Warning> warnings(const std::vector<io::SummaryRow>& summary) override;
  void save(io::Checkpoint& to) override;
  void restore(const io::Checkpoint& from) override;

 private:
  struct Extreme {
    double value = 0, time = 0, arc = 0;
    bool set = false;
  };
  struct Quantity {
    std::string name, unit;
    std::vector<size_t> fields;
    bool largest = true;
    PerLine<Extreme> lines;  // over this rank's nodes
  };
  std::vector<CheckpointRecord> checkpoint_records(NodeRange nodes) const;

  const MPI_Comm comm_;
  const model::Case& case_;
  const LocalMesh& local_;
  const Feeders* feeders_;  // null: no line is fed
  const Utilisation& utilisation_;
  std::vector<Field> fields_;
  std::vector<bool> has_beams_;  // by line
  std::vector<Quantity> quantities_;
};

}  // namespace hawser::record
