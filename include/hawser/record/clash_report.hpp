// The clash report of a run on all its ranks: what they find touching is kept by each, and put together on
// rank 0 when results are written.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/record/clash_log.hpp"
#include "hawser/record/subject.hpp"

namespace hawser {
class BodyContactTerm;
class LinePairs;
class LineVolumeContact;
}  // namespace hawser

namespace hawser::record {

class ClashReport {
 public:
  // True when the case wants a report and anything can touch in the simulation.
  static bool wanted(const Subject& subject);
  ClashReport(MPI_Comm comm, const Subject& subject);

  // An accepted step, before the next one is prepared. Collective, but communicates only now and then.
  void step(double time);
  // Of rank 0: what an output is to hold. Collective.
  io::ClashTables take();
  // Of rank 0: what outputs have given the file so far. Another one begins with nothing.
  const io::ClashesTold& told() const { return log_.told(); }
  void begin_file() { log_.begin_file(); }

  // The share of a checkpoint, as records of the first node. Collective both; restore() wants all that is in
  // the checkpoint.
  static std::vector<HistoryKind> history() { return {{"clash log", {{"number", 1, ""}}}}; }
  std::vector<HistoryRecord> save();
  void restore(const std::vector<HistoryRecord>& records);

  // The clashes with the largest forces in words; on rank 0, after take().
  std::string table() const;

 private:
  void collect();
  std::vector<double> of_all(const std::vector<double>& mine) const;

  MPI_Comm comm_;
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
