// The trial run with which `hawser check` ends, and how the CPU time and memory of a whole run follow from
// it.
#include "hawser/app/cost.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

#include "hawser/app/output_times.hpp"

namespace hawser::app {
namespace {

// Where statics is not over in the trial: iterations of statics, and in dynamics of a step, of the cases in
// cases/; steps over the longest ones.
constexpr double kStatics = 60, kDynamics = 4, kAutomatic = 0.5;

double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Spent {};  // statics has spent what it may

}  // namespace

TrialRun trial_run(Simulation& sim, const model::Case& c, double budget) {
  TrialRun trial;
  const double begun = cpu_time();
  const auto over = [&] { return cpu_time() - begun > budget; };
  if (c.dynamics.enabled) {
    const StepSettings step = sim.dynamics_settings().step;
    trial.duration = c.dynamics.duration;
    trial.longest = step.fixed > 0 ? step.fixed / kAutomatic : step.longest;
  }
  try {
    double first = 0;  // CPU s, at the end of the first iteration, which also sets up what all others use
    if (c.statics.enabled)
      sim.solve_statics([&](const StaticsReport& now) {
        if (now.iterations <= 1) first = cpu_time();
        if (now.iterations <= 1 || !over()) return;
        trial.iteration = (cpu_time() - first) / (now.iterations - 1);
        throw Spent();
      });
    else
      sim.check_inside();
    if (c.dynamics.enabled) {
      std::vector<std::pair<double, double>> way;  // CPU s, simulated s
      const OutputTimes times(c);
      Dynamics& d = sim.dynamics();
      d.start(sim.state());
      const double at_rest = cpu_time();
      d.run(
          trial.duration, [&](double t) { return times.next(t); },
          [&](const StepInfo& info) {
            way.push_back({cpu_time() - at_rest, info.time});
            return !over();
          });
      trial.reached = way.back().second;
      const auto half = std::find_if(way.begin(), way.end(),
                                     [&](const auto& w) { return w.first >= 0.5 * way.back().first; });
      const auto from = half == way.end() - 1 ? std::pair(0.0, 0.0) : *half;
      trial.rate = (way.back().first - from.first) / (way.back().second - from.second);
    }
  } catch (const Spent&) {
  } catch (const std::exception& e) {
    trial.failure = e.what();
  }
  trial.spent = cpu_time() - begun;
  return trial;
}

double expected_cost(const TrialRun& t) {
  if (t.iteration > 0) return t.iteration * (kStatics + kDynamics * t.duration / (kAutomatic * t.longest));
  return t.spent + t.rate * (t.duration - t.reached);
}

std::string cost_sentence(const TrialRun& t) {
  if (!t.failure.empty()) return "a trial run stops: " + t.failure;
  const double cost = expected_cost(t);
  const std::string by = t.iteration > 0 ? ", by the first iterations of statics"
                         : t.reached < t.duration
                             ? fmt::format(", by its first {:.2g} of {:.4g} s", t.reached, t.duration)
                             : "";
  return fmt::format("expected cost: {} CPU s{}",
                     cost < 1 ? std::string("less than 1") : fmt::format("about {:.2g}", cost), by);
}

double peak_memory() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return 1024.0 * static_cast<double>(use.ru_maxrss);
}

std::string memory_sentence(double read, double measured) {
  constexpr double kRun = 1.3;  // what a run takes beside the files over what its beginning takes
  const double gb = 1e-9 * (read + kRun * (measured - read));
  return fmt::format("expected memory: about {:.2g} GB", gb);
}

}  // namespace hawser::app
