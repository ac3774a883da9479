// How the CPU time of one residual and one tangent is measured, and how `hawser check` estimates the time and
// memory of a whole run from it.
#include "hawser/app/cost.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/solve/linear_solver.hpp"

namespace hawser::app {
namespace {

// Of the cases in cases/: residuals and tangents a step of dynamics and in statics, the share of a step that
// goes elsewhere (preparing contact, bounds of the step, what is recorded), automatic steps over the longest
// ones.
constexpr double kResiduals = 4, kTangents = 2, kElsewhere = 0.3, kAutomatic = 0.5;
constexpr double kContact = 3;  // lines come to lie on meshes that are far from them in the start shape
constexpr double kStaticsIterations = 60, kStaticsResiduals = 2;
constexpr double kEnough = 0.02;  // CPU s that a part is measured for
constexpr int kMostRepeats = 50;

double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

// Mean CPU time of a call. What the first one makes for all others is not counted, unless it takes long
// alone.
template <typename Call>
double cost_of(const Call& call) {
  const double first = cpu_time();
  call();
  const double begun = cpu_time();
  if (begun - first > 10 * kEnough) return begun - first;
  int n = 0;
  while (n < kMostRepeats && (n == 0 || cpu_time() - begun < kEnough)) call(), ++n;
  return (cpu_time() - begun) / n;
}

}  // namespace

double expected_cost(const CostParts& p) {
  double cost = p.statics ? kStaticsIterations * (kStaticsResiduals * p.residual + p.tangent) : 0;
  if (p.duration > 0)
    cost +=
        p.duration / p.step * (p.flow + (1 + kElsewhere) * (kResiduals * p.residual + kTangents * p.tangent));
  return p.meshes ? kContact * cost : cost;
}

CostParts measured_parts(Simulation& sim) {
  const model::Case& c = sim.model();
  CostParts parts;
  parts.statics = c.statics.enabled;
  double h = 0.1;
  if (c.dynamics.enabled) {
    const StepSettings step = sim.dynamics_settings().step;
    parts.duration = c.dynamics.duration;
    h = parts.step = step.fixed > 0 ? step.fixed : kAutomatic * step.longest;
  }
  parts.meshes = sim.contact() &&
                 std::any_of(c.volumes.begin(), c.volumes.end(),
                             [&](const model::Volume& v) { return !v.shape && c.contact.takes_part(v); });
  System& system = sim.system();
  State state = sim.state();
  const size_t n = state.x.size();
  for (auto* a : {&state.v, &state.a, &state.w, &state.alpha}) a->resize(n, Vec3::Zero());
  if (system.couple(state.view(h), h) == Coupled::anew) system.spread(state);
  system.prepare(state.view(h), h);
  VecHandle r = system.create_vector(), u;
  check(VecDuplicate(r.get(), u.out()));
  const MatHandle J = system.create_matrix();
  KspHandle ksp;
  check(KSPCreate(system.comm(), ksp.out()));
  configure_linear_solver(ksp.get(), system, "dynamics_");
  const std::vector<double> zero(3 * static_cast<size_t>(system.mesh().blocks()), 0);
  const Weights weights{1, 2 / h, 4 / (h * h)};  // of the trapezoidal rule
  const auto residual = [&] { system.residual(state.view(h), r.get()); };
  parts.residual = cost_of(residual);
  if (c.dynamics.enabled) {
    // The first one at another time finds the flow of waves, those after it keep it.
    const double begun = cpu_time();
    state.time += h;
    residual();
    state.time -= h;
    parts.flow = std::max(0.0, cpu_time() - begun - parts.residual);
  }
  parts.tangent = cost_of([&] {
    system.tangent(state.view(h), weights, zero, false, J.get());
    check(KSPSetOperators(ksp.get(), J.get(), J.get()));
    check(KSPSolve(ksp.get(), r.get(), u.get()));
  });
  return parts;
}

std::string cost_sentence(const CostParts& parts) {
  const double cost = expected_cost(parts);
  return fmt::format("expected cost: {} CPU s{}",
                     cost < 1 ? std::string("less than 1") : fmt::format("about {:.2g}", cost),
                     parts.duration > 0 ? fmt::format(", if steps are of about {:.2g} s", parts.step) : "");
}

double peak_memory() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return 1024.0 * static_cast<double>(use.ru_maxrss);
}

std::string memory_sentence(double read, double measured) {
  constexpr double kRun = 2.2;  // what a run takes beside the files over what its parts take
  const double gb = 1e-9 * (read + kRun * (measured - read));
  return fmt::format("expected memory: about {:.2g} GB", gb);
}

}  // namespace hawser::app
