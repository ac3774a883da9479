// Trial run of `hawser check`, and extrapolation of CPU time and memory of a whole run.
#include "hawser/run/cost.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include "hawser/advice/cost.hpp"
#include "hawser/base/error.hpp"
#include "hawser/record/output_times.hpp"
#include "hawser/record/result_parts.hpp"
#include "hawser/run/events.hpp"
#include "hawser/run/feeder_nodes.hpp"
#include "hawser/run/run_parts.hpp"
#include "hawser/run/step_actions.hpp"

namespace hawser::run {
namespace {

// Typical numbers for statics that does not end in the trial, from the cases in cases/; steps are the longest
// ones.
constexpr double kIterationsOfStatics = 60, kIterationsPerStep = 4;

struct BudgetSpent {};  // thrown when statics has used its share

struct Sample {
  double cpu = 0, time = 0;  // CPU s from the start of dynamics; simulated time, s
};

// Number of steps and CPU time per simulated time of a whole run, from those of the trial.
void extrapolate(const std::vector<Sample>& samples, TrialRun& trial) {
  trial.reached = samples.back().time;
  trial.moved = true;
  const auto half = std::find_if(samples.begin(), samples.end(),
                                 [&](const Sample& w) { return w.cpu >= 0.5 * samples.back().cpu; });
  const Sample from = half == samples.end() - 1 ? Sample{} : *half;
  // Steps of the initial transient, and further ones as long as those of the second half.
  const double recent_steps = std::max(static_cast<double>(samples.end() - half), 1.0);
  trial.steps = static_cast<double>(samples.size()) +
                (trial.duration - trial.reached) * recent_steps / std::max(trial.reached - from.time, 1e-300);
  trial.rate = (samples.back().cpu - from.cpu) / (samples.back().time - from.time);
}

}  // namespace

double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

namespace {

// A trial run under way.
struct RunningTrial {
  Simulation& sim;
  const model::Case& c;
  const std::function<void(const Kinematics&)>& on_state;
  double end = 0;  // s, of CPU time
  TrialRun result;

  bool budget_spent() const { return cpu_time() > end; }
  void run_statics(Events& events);
  void run_dynamics(Events& events);
};

void RunningTrial::run_statics(Events& events) {
  double first = 0;  // CPU s at the end of the first iteration, which includes the setup
  const auto report = [&](const StaticsReport& now) {
    if (now.iterations <= 1) first = cpu_time();
    if (now.iterations <= 1 || !budget_spent()) return;
    result.iteration = (cpu_time() - first) / (now.iterations - 1);
    throw BudgetSpent();
  };
  events.solve_stages([&](StartsFrom from) { sim.solve_statics(report, from); });
}

void RunningTrial::run_dynamics(Events& events) {
  std::vector<Sample> samples;
  const record::OutputTimes times(c);
  Dynamics& d = sim.dynamics();
  FeederNodes feeder_nodes(sim);
  events.begin();
  d.start(sim.state());
  const double at_rest = cpu_time();
  d.run(
      result.duration, [&](double t) { return std::min(times.next(t), events.next(t)); },
      [&](const StepInfo& info) {
        act_after_step(
            events, feeder_nodes, [] {}, [](const std::string&) {});
        if (on_state) on_state(d.committed_kinematics());
        samples.push_back({cpu_time() - at_rest, info.time});
        return !budget_spent();
      });
  extrapolate(samples, result);
}

}  // namespace

TrialRun trial_run(Simulation& sim, const model::Case& c, double budget,
                   const std::function<void(const Kinematics&)>& on_state) {
  const double begun = cpu_time();
  RunningTrial trial{sim, c, on_state, begun + budget, {}};
  TrialRun& result = trial.result;
  if (c.dynamics.enabled) {
    const StepSettings step = sim.dynamics_settings().step;
    result.duration = c.dynamics.duration;
    result.longest = step.fixed > 0 ? step.fixed / record::kAutomaticSteps : step.longest;
  }
  try {
    Events events(sim.system().comm(), sim);
    if (c.statics.enabled)
      trial.run_statics(events);
    else
      sim.check_inside();
    release_freed_memory();  // as in a run
    if (on_state) on_state(sim.state().at_rest());
    if (c.dynamics.enabled) trial.run_dynamics(events);
  } catch (const BudgetSpent&) {
  } catch (const InputError&) {
    throw;  // an error of the case
  } catch (const std::exception& e) {
    result.failure = e.what();
  }
  result.spent = cpu_time() - begun;
  return result;
}

double expected_cost(const TrialRun& t) {
  if (t.iteration > 0)
    return t.iteration *
           (kIterationsOfStatics + kIterationsPerStep * t.duration / (record::kAutomaticSteps * t.longest));
  return t.spent + t.rate * (t.duration - t.reached);
}

std::string cost_sentence(const TrialRun& t) {
  if (!t.failure.empty()) return advice::trial_fails(t.failure);
  return advice::expected_cost(expected_cost(t),
                               {.by_statics = t.iteration > 0, .reached = t.reached, .duration = t.duration});
}

std::string size_sentence(const io::ResultsSize& size, const std::string& folder) {
  advice::ResultBytes bytes{{{"fields", size.fields},
                             {"histories", size.histories},
                             {"checkpoints", size.checkpoints},
                             {"meshes", size.meshes}},
                            size.total()};
  bytes.contact_point = size.contact_point;
  std::error_code unknown;
  const std::filesystem::space_info disk = std::filesystem::space(folder, unknown);
  if (!unknown) bytes.available = static_cast<double>(disk.available);
  return advice::expected_results(bytes, folder);
}

double peak_memory() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return 1024.0 * static_cast<double>(use.ru_maxrss);
}

namespace {

// Bytes of this process as Linux counts them: its address space, what of that is resident, and the part of
// that which belongs to files. Zeros elsewhere.
std::array<double, 3> counted_memory() {
  std::array<double, 3> pages{};
  std::ifstream("/proc/self/statm") >> pages[0] >> pages[1] >> pages[2];
  for (double& n : pages) n *= static_cast<double>(sysconf(_SC_PAGESIZE));
  return pages;
}

}  // namespace

double memory_now() {
  const double now = counted_memory()[1];
  return now > 0 ? now : peak_memory();
}

double file_memory_now() { return counted_memory()[2]; }

std::string memory_sentence(const MemoryUse& use, double imbalance, int ranks) {
  constexpr double kMotionOverStatics = 1.3;  // memory of dynamics over that of statics
  // What a run has on each rank and the trial has not, bytes: code and buffers that write results, and those
  // of messages between ranks. Measured as the constant part of the peak memory of 100 to 1000 lines on 1, 2
  // and 4 ranks with HDF5 1.10 and Open MPI 4.1.
  constexpr double kResults = 6e6, kMessages = 5e6;
  const double on_all = use.shared + use.of_files;
  const double of_work = (use.moved ? 1 : kMotionOverStatics) * (use.measured - on_all) * imbalance / ranks;
  const double not_in_trial = kResults + (ranks > 1 ? kMessages : 0);
  return advice::expected_memory(std::max(use.read, on_all + of_work) + not_in_trial, ranks > 1);
}

}  // namespace hawser::run
