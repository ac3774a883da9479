// The class StepObserver: times of outputs and checkpoints, and requests of signals and of the clock, on
// which the ranks agree.
#include "hawser/run/step_observer.hpp"

#include <algorithm>
#include <csignal>

#include "hawser/base/mpi.hpp"
#include "hawser/run/restart.hpp"
#include "hawser/run/step_actions.hpp"

namespace hawser::run {
namespace {

constexpr double kCheckpointShare = 0.02;  // of the time, unless the case gives their interval

// Steps after which the ranks also agree on requests between outputs, so that a signal ends a run whose steps
// have become very short.
constexpr int kStepsBetweenRequests = 20;

volatile std::sig_atomic_t stop_requested = 0;
void request_stop(int signal) {
  stop_requested = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void accept_stop_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) std::signal(signal, request_stop);
}

StepObserver::StepObserver(Simulation& sim, double end, record::Recorder& recorder, Events& events,
                           FeederNodes& feeder_nodes, Progress& progress)
    : sim_(sim),
      dynamics_(sim.dynamics()),
      end_(end),
      recorder_(recorder),
      events_(events),
      feeder_nodes_(feeder_nodes),
      progress_(progress),
      comm_(sim.system().comm()),
      rank_(rank_of(comm_)),
      times_(sim.model()),
      output_at_(record::next_multiple(dynamics_.committed().s.time, times_.every)),
      checkpoint_at_(record::next_multiple(dynamics_.committed().s.time, checkpoint_interval())),
      checkpoints_(kCheckpointShare) {}

bool StepObserver::observe(const StepInfo& info) {
  const double slack = record::time_tolerance(info.time);
  const bool last = info.time >= end_ - slack;
  const Due due{info.time >= output_at_ - slack || last, info.time >= checkpoint_at_ - slack || last};
  Requests requests;
  // Outputs have the state before the events, checkpoints the state after them.
  act_after_step(
      events_, feeder_nodes_, [&] { requests = record_step(info, due); },
      [&](const std::string& e) { progress_.print(e); });
  const bool by_case = due.checkpoint && (last || times_.checkpoint_every > 0);
  if (by_case || requests.stop || requests.checkpoint) save_state();
  if (due.checkpoint)
    checkpoint_at_ =
        times_.checkpoint_every > 0 ? record::next_multiple(info.time, times_.checkpoint_every) : output_at_;
  stopped_ = requests.stop && !last;
  return !requests.stop;
}

void StepObserver::save_state() {
  checkpoints_.spend([&] { recorder_.checkpoint(make_checkpoint(sim_, recorder_, events_)); });
}

double StepObserver::next_stop(double time) const { return std::min(times_.next(time), events_.next(time)); }

double StepObserver::checkpoint_interval() const {
  return times_.checkpoint_every > 0 ? times_.checkpoint_every : times_.every;
}

StepObserver::Requests StepObserver::record_step(const StepInfo& info, const Due& due) {
  recorder_.step(info, dynamics_.committed_kinematics());
  progress_.step(info.time, info.h, info.iterations);
  int requests[2] = {0, 0};
  if (due.output || due.checkpoint || ++steps_since_requests_ == kStepsBetweenRequests) {
    steps_since_requests_ = 0;
    requests[0] = stop_requested;
    requests[1] = rank_ == 0 && times_.checkpoint_every <= 0 && checkpoints_.due();
    all_reduce(comm_, MPI_MAX, requests);
  }
  if (due.output) {
    recorder_.output(dynamics_.committed_kinematics());
    output_at_ = record::next_multiple(info.time, times_.every);
  }
  progress_.print_warnings(recorder_.remarks());
  return {requests[0] != 0, requests[1] != 0};
}

}  // namespace hawser::run
