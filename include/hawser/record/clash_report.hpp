// Clash report of a run on all ranks: each rank stores its contacts; rank 0 assembles the clashes when
// results are written.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/record/clash_log.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"

namespace hawser {
class BodyContact;
class LinePairs;
}  // namespace hawser

namespace hawser::record {

class ClashReport : public Recording {
 public:
  // True if the case enables the report and has any contact.
  static bool enabled(const Subject& subject);
  // False if the checkpoint has a report with other quantities, of another version.
  static bool can_restore(const io::Checkpoint& from);
  // The subject must outlive the report.
  explicit ClashReport(const Subject& subject);

  void declare(Declarations& to) override { to.contents.clashes = true; }
  // Must precede the preparation of the next step. Communicates only every kMostSteps steps.
  void step(const Snapshot& s) override;
  void take_clashes(io::ClashTables& to) override;
  void begin_file() override { log_.begin_file(); }
  void add_reported(io::ReportedClashes& to) const override { to = log_.reported(); }
  // Table of the clashes with the largest forces; empty: no clashes.
  std::string table() const override;

  // Stored as records of the first node.
  void save(io::Checkpoint& to) override;
  void restore(const io::Checkpoint& from) override;

 private:
  void collect();

  const MPI_Comm comm_;
  const Subject& subject_;
  const LinePairs* line_pairs_;      // null: no such contact
  const BodyContact* body_contact_;  // likewise
  int rank_;
  ClashSettings settings_;
  std::vector<int> volumes_;  // indices in the case of the volumes in contact with lines
  // Since the last collect(): the steps, the same on all ranks, and the contacts of this rank in them.
  struct Step {
    double time = 0;  // s
    int contacts = 0;
  };
  std::vector<Step> steps_;
  ActiveContacts contacts_;
  ClashLog log_;  // on rank 0
};

}  // namespace hawser::record
