#include "hawser/app/driver.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <petsclog.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <ctime>
#include <filesystem>

#include "hawser/app/files.hpp"
#include "hawser/app/progress.hpp"
#include "hawser/app/recorder.hpp"
#include "hawser/app/restart.hpp"
#include "hawser/app/share_nodes.hpp"
#include "hawser/app/version.hpp"
#include "hawser/app/volumes.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/model/summary.hpp"

namespace hawser::app {
namespace {

// Set by SIGINT and SIGTERM: the run ends at the next output, with everything on disk. Who cannot wait
// sends the signal again.
volatile std::sig_atomic_t stop_requested = 0;
void request_stop(int signal) {
  stop_requested = 1;
  std::signal(signal, SIG_DFL);
}

// Multiples of `every`, as numbers that do not drift.
double next_multiple(double t, double every) { return every * (std::floor(t / every + 1e-9) + 1); }

io::RunInfo run_info(const model::Case& c, const RunOptions& o, int ranks) {
  io::RunInfo info;
  info.case_text = c.text, info.case_path = c.path;
  info.version = kVersion, info.options = o.options_text, info.ranks = ranks;
  const std::time_t now = std::time(nullptr);
  info.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
  return info;
}

// A stage of -log_view for as long as it lives; inside it, events are named by term.
class Stage {
 public:
  explicit Stage(const char* name) {
    PetscLogStage stage = -1;
    check(PetscLogStageGetId(name, &stage));  // a second run of the same process knows it
    if (stage < 0) check(PetscLogStageRegister(name, &stage));
    check(PetscLogStagePush(stage));
  }
  ~Stage() { PetscLogStagePop(); }
};

bool same_file(const std::string& a, const std::string& b) {
  std::error_code e;
  return std::filesystem::equivalent(a, b, e);
}

// Seconds a node and Newton iteration (residual, tangent, factors, solve), measured with the reel, the reel
// without its drum, and that with a cable, on one core of the machine of docs/performance.md.
constexpr double kBeamCost = 1.6e-6, kCableCost = 0.5e-6, kContactCost = 0.5e-6;
constexpr double kStaticsIterations = 30;

void print_cost(const model::Case& c, long beams, long cables) {
  const auto nodes = static_cast<double>(beams + cables);
  const double iteration = kBeamCost * static_cast<double>(beams) + kCableCost * static_cast<double>(cables) +
                           (c.volumes.empty() ? 0 : kContactCost * nodes);
  double cost = c.statics.enabled ? kStaticsIterations * iteration : 0;
  std::string why;
  if (c.dynamics.enabled) {
    const model::Dynamics& d = c.dynamics;
    // Automatic steps are about half the longest; contact takes an iteration more.
    const double longest = d.max_step > 0 ? d.max_step : std::max(d.duration / 1000, 0.05);
    const double step = d.step > 0 ? d.step : 0.5 * longest;
    const int iterations = c.volumes.empty() ? 4 : 5;
    cost += d.duration / step * iterations * iteration;
    why = fmt::format(", if steps are of {:.2g} s and need {} Newton iterations", step, iterations);
  }
  if (cost < 1)
    fmt::print("expected cost: less than 1 CPU s{}\n", why);
  else
    fmt::print("expected cost: about {:.2g} CPU s{}\n", cost, why);
}

}  // namespace

int run(MPI_Comm comm, const RunOptions& options) {
  int rank = 0, size = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  model::Case c = io::read_case(options.case_path);
  if (!options.output.empty()) c.output.file = std::filesystem::absolute(options.output).string();
  const bool speak = rank == 0 && !options.quiet, restarted = !options.restart.empty();
  check_output_place(comm, c.output.file);
  if (restarted && !c.dynamics.enabled)
    throw InputError(c.path + ": dynamics: only a run in time can go on from a checkpoint");
  std::vector<LoadedVolume> volumes = load_volumes(c, comm);
  Simulation sim(comm, c, surfaces(volumes), skeletons(c, volumes));
  const double end =
      options.stop_at > 0 ? std::min(options.stop_at, c.dynamics.duration) : c.dynamics.duration;
  io::Checkpoint checkpoint;
  if (restarted) checkpoint = read_restart(options.restart, sim);
  Progress progress(speak, end);
  progress.say(
      fmt::format("{}: {} nodes on {}", c.title.empty() ? c.path : c.title, sim.mesh().nodes.size(),
                  size == 1 ? "1 rank" : fmt::format("{} ranks, {} cut elements", size, sim.cut_elements())));
  for (const auto& n : c.notes) progress.say("note: " + n);
  for (const auto& v : volumes)
    for (const auto& n : v.notes) progress.say("note: volumes." + v.name + ": " + n);
  for (const auto& n : sim.notes()) progress.say("note: " + n);

  if (restarted) {
    progress.say(fmt::format("going on from t = {:.6g} s of {}", checkpoint.time, options.restart));
    if (checkpoint.time >= end * (1 - 1e-12)) progress.say("which is the end: nothing left to compute");
  } else if (c.statics.enabled) {
    const Stage stage("statics");
    const size_t told = sim.notes().size();
    const StaticsReport s = sim.solve_statics();
    for (size_t i = told; i < sim.notes().size(); ++i) progress.say("note: " + sim.notes()[i]);
    progress.say(fmt::format(
        "statics: {} iterations{}{}{}", s.iterations,
        s.relaxation_steps > 0 ? fmt::format(", {} steps of dynamic relaxation", s.relaxation_steps) : "",
        s.escapes > 0 ? fmt::format(", {} false equilibria left", s.escapes) : "",
        !c.statics.contact_friction && c.contact.has_friction(c.volumes) ? ", without friction of contact"
                                                                         : ""));
    if (s.negative_eigenvalues > 0)
      progress.say(fmt::format("warning: the static equilibrium is unstable ({} negative eigenvalues)",
                               s.negative_eigenvalues));
  }

  const bool append = restarted && same_file(options.restart, c.output.file);
  Recorder recorder(comm, sim, volume_meshes(c, volumes), surfaces(volumes), run_info(c, options, size),
                    restarted ? &checkpoint : nullptr, append);
  if (restarted) {
    restore(checkpoint, sim);
    // A new file begins with the state the run goes on from.
    if (!append) recorder.output(checkpoint.time, sim.dynamics().kinematics());
  } else if (c.dynamics.enabled) {
    sim.dynamics().start(sim.state());
    recorder.start(0, sim.dynamics().kinematics());
    recorder.step({}, sim.dynamics().kinematics(), 0);
    recorder.output(0, sim.dynamics().kinematics());
    recorder.checkpoint(make_checkpoint(sim, recorder));  // so that a run killed at once can go on too
  } else {
    recorder.start(0, sim.state().view(0));
    recorder.step({}, sim.state().view(0), 0);
    recorder.output(0, sim.state().view(0));
  }

  if (c.dynamics.enabled) {
    const Stage stage("dynamics");
    std::signal(SIGINT, request_stop);
    std::signal(SIGTERM, request_stop);
    Dynamics& d = sim.dynamics();
    progress.begin(d.committed().s.time);
    const double every = c.output.every > 0 ? c.output.every : c.dynamics.duration / 100;
    const double keep = c.output.checkpoint_every;
    auto next_stop = [&](double t) {
      return keep > 0 ? std::min(next_multiple(t, every), next_multiple(t, keep)) : next_multiple(t, every);
    };
    double output_at = next_multiple(d.committed().s.time, every);
    double checkpoint_at = keep > 0 ? next_multiple(d.committed().s.time, keep) : output_at;
    auto observer = [&](const StepInfo& info) {
      recorder.step(info, d.kinematics(), d.support_work());
      progress.step(info.time, info.h, info.iterations);
      const double slack = 1e-9 * std::max(1.0, info.time);
      int stop = stop_requested;
      const bool last = info.time >= end - slack;
      const bool output = info.time >= output_at - slack || last;
      const bool save = info.time >= checkpoint_at - slack || last;
      // Whether somebody asked to stop is agreed on where everybody meets anyhow.
      if (output || save)
        MPI_Allreduce(MPI_IN_PLACE, &stop, 1, MPI_INT, MPI_MAX, comm);
      else
        stop = 0;
      if (output || stop)
        recorder.output(info.time, d.kinematics()), output_at = next_multiple(info.time, every);
      if (save || stop) {
        recorder.checkpoint(make_checkpoint(sim, recorder));
        checkpoint_at = keep > 0 ? next_multiple(info.time, keep) : output_at;
      }
      return stop == 0;
    };
    try {
      d.run(end, next_stop, observer);
    } catch (const SolveError&) {
      recorder.finish();
      throw;
    }
  }
  progress.end();
  if (c.dynamics.enabled)
    for (const std::string& n :
         sim.raised_stiffness(fmt::format("by t = {:.6g} s", sim.dynamics().committed().s.time)))
      progress.say("note: " + n);
  const std::string table = recorder.finish();
  if (speak) {
    fmt::print("\n{}", table);
    if (const std::string clashes = recorder.clash_table(); !clashes.empty()) fmt::print("\n{}", clashes);
    const Audit& a = recorder.audit();
    if (c.dynamics.enabled)
      fmt::print(
          "\nenergy: brought in {:.6g} J; kinetic {:.6g}, strain {:.6g}, friction {:.6g}, damping {:.6g} J; "
          "not accounted for {:.3g} J ({:.3g} %)\n",
          a.brought_in, a.now.kinetic, a.now.strain, a.now.friction, a.now.damping, a.error, a.percent());
    if (const std::string w = a.warning(c.dynamics.step > 0); c.dynamics.enabled && !w.empty())
      fmt::print("\nwarning: {}\n", w);
    for (const std::string& w : recorder.warnings()) fmt::print("\nwarning: {}\n", w);
    fmt::print("\nresults: {}\n", recorder.file().path());
    if (c.output.xdmf) fmt::print("look at them: paraview {}\n", recorder.file().xdmf_path());
    std::fflush(stdout);
  }
  return stop_requested ? 130 : 0;
}

int check_case(MPI_Comm comm, const std::string& case_path, int ranks) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  if (ranks == 0) MPI_Comm_size(comm, &ranks);
  const model::Case c = io::read_case(case_path);
  const std::vector<LoadedVolume> volumes = load_volumes(c, comm);
  if (rank != 0) return 0;
  fmt::print("{}", model::summary(c));
  for (const auto& v : volumes) {
    fmt::print("volume {}: {}\n", v.name, v.report);
    for (const auto& n : v.notes) fmt::print("  note: {}\n", n);
  }
  const Mesh mesh = build_mesh(c);
  const std::vector<int> owner = share_nodes(c, mesh, Bodies(c.bodies), ranks);
  std::vector<int> share(static_cast<size_t>(ranks), 0);
  long beams = 0;
  for (size_t n = 0; n < owner.size(); ++n)
    ++share[static_cast<size_t>(owner[n])], beams += mesh.nodes[n].rotates;
  const auto [least, most] = std::minmax_element(share.begin(), share.end());
  fmt::print("partition: {} rank{}, {} nodes{}, {} cut elements\n", ranks, ranks > 1 ? "s" : "",
             ranks > 8 ? fmt::format("{} to {}", *least, *most) : fmt::format("{}", fmt::join(share, " + ")),
             ranks > 8 ? " each" : "", cut_elements(mesh, owner));
  print_cost(c, beams, static_cast<long>(mesh.nodes.size()) - beams);
  fmt::print("the case is good\n");
  return 0;
}

}  // namespace hawser::app
