// What a run does after each accepted step: outputs and checkpoints that are due, events, and the stop by a
// signal.
#pragma once

#include <mpi.h>

#include "hawser/base/share_of_time.hpp"
#include "hawser/record/output_times.hpp"
#include "hawser/record/recorder.hpp"
#include "hawser/run/events.hpp"
#include "hawser/run/feeder_nodes.hpp"
#include "hawser/run/progress.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::run {

// From now on SIGINT, SIGTERM and SIGUSR1, which mpirun forwards to all ranks, end the run within twenty
// steps with everything on disk. A second signal ends it immediately.
void accept_stop_signals();

class StepObserver {
 public:
  // end: s, of the run. The arguments outlive the observer.
  StepObserver(Simulation& sim, double end, record::Recorder& recorder, Events& events,
               FeederNodes& feeder_nodes, Progress& progress);

  // Records the step, executes events, and writes what is due. Returns whether the run continues. Collective.
  bool observe(const StepInfo& info);
  // Writes a checkpoint. Collective.
  void save_state();
  // s, of the next output, checkpoint or event after `time`.
  double next_stop(double time) const;
  bool stopped() const { return stopped_; }  // early, by a signal, on all ranks

 private:
  struct Due {
    bool output, checkpoint;
  };
  // What any rank requests: to stop, or a checkpoint by the clock.
  struct Requests {
    bool stop = false, checkpoint = false;
  };
  double checkpoint_interval() const;  // s
  Requests record_step(const StepInfo& info, const Due& due);

  Simulation& sim_;
  Dynamics& dynamics_;
  const double end_;
  record::Recorder& recorder_;
  Events& events_;
  FeederNodes& feeder_nodes_;
  Progress& progress_;
  const MPI_Comm comm_;
  const int rank_;
  const record::OutputTimes times_;
  double output_at_, checkpoint_at_;  // s
  ShareOfTime checkpoints_;
  int steps_since_requests_ = 0;  // since the ranks last agreed on requests
  bool stopped_ = false;
};

}  // namespace hawser::run
