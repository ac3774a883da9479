// The clash report of a run on all its ranks: what they find touching is kept by each, and put together on
// rank 0 when results are written.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/app/clash_log.hpp"
#include "hawser/app/simulation.hpp"
#include "hawser/io/checkpoint.hpp"

namespace hawser::app {

class ClashReport {
 public:
  // True when the case wants a report and anything can touch in the simulation.
  static bool wanted(Simulation& simulation);
  ClashReport(MPI_Comm comm, Simulation& simulation);

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
  Simulation& sim_;
  int rank_;
  ClashSettings settings_;
  std::vector<int> volumes_;   // of the case: those of the contact of lines with volumes
  std::vector<double> steps_;  // since the last collect(): time, number of touches, touches
  int waiting_ = 0;            // steps in it
  ClashLog log_;               // of rank 0
};

}  // namespace hawser::app
