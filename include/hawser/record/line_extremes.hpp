// The table of extremes: of each line the largest (or smallest) value of some fields over all steps, with the
// time and the place.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/io/results.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/utilisation.hpp"

namespace hawser {
class Feeders;
}

namespace hawser::record {

// Whether a row of the summary is the largest tension of a line, and that is more than round-off.
bool is_largest_tension(const model::Case& c, const io::SummaryRow& row);

class LineExtremes : public Recording {
 public:
  // A utilisation that is not known does not count, nor what is inside a feeder. Both outlive it.
  LineExtremes(const Subject& subject, const Utilisation& utilisation);

  void declare(Declarations& to) override;
  void step(const Snapshot& s) override;
  // The rows of all lines, those of a line together.
  std::vector<io::SummaryRow> summary() override { return table(); }
  // Of rows that are more than a line bears.
  std::vector<Finding> findings(const std::vector<io::SummaryRow>& summary, const Audit& audit) override;
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
    std::vector<Extreme> lines;  // of this rank's nodes
  };
  std::vector<io::SummaryRow> table() const;
  std::vector<CheckpointRecord> records(NodeRange nodes) const;

  const MPI_Comm comm_;
  const model::Case& case_;
  const LocalMesh& local_;
  const Feeders* feeders_;  // null: no line is fed
  const Utilisation& utilisation_;
  std::vector<Field> fields_;
  std::vector<std::string> names_;  // of lines
  std::vector<bool> has_beams_;     // of lines
  std::vector<Quantity> quantities_;
};

}  // namespace hawser::record
