// The clash report of a run on all its ranks: what they find touching is kept by each, and put together on
// rank 0 when results are written.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/record/clash_log.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"

namespace hawser {
class BodyContactTerm;
class LinePairs;
class LineVolumeContact;
}  // namespace hawser

namespace hawser::record {

class ClashReport : public Recording, public HasClashes {
 public:
  // True when the case wants a report and anything can touch.
  static bool wanted(const Subject& subject);
  // The subject outlives it.
  explicit ClashReport(const Subject& subject);

  // Before the next step is prepared. Communicates only now and then.
  void step(const Snapshot& s) override;
  io::ClashTables take() override;
  const io::ReportedClashes& reported() const override { return log_.reported(); }
  void begin_file() override { log_.begin_file(); }
  // The clashes with the largest forces.
  std::string table() const override;

  // As records of the first node.
  void save(io::Checkpoint& to) override;
  void restore(const io::Checkpoint& from) override;

 private:
  void collect();

  const MPI_Comm comm_;
  const Subject& subject_;
  const LineVolumeContact* contact_;     // null: none of its kind
  const LinePairs* line_pairs_;          // likewise
  const BodyContactTerm* body_contact_;  // likewise
  int rank_;
  ClashSettings settings_;
  std::vector<int> volumes_;   // of the case: those of the contact of lines with volumes
  std::vector<double> steps_;  // since the last collect(): time, number of touches, touches
  int waiting_ = 0;            // steps in it
  ClashLog log_;               // of rank 0
};

}  // namespace hawser::record
