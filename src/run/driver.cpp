// Sequence of a run: reading, static equilibrium, time integration, final messages and exit code.
#include "hawser/run/driver.hpp"

#include <fmt/format.h>
#include <petsclog.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "hawser/advice/restart.hpp"
#include "hawser/advice/run.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/case_json.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/record/energy_audit.hpp"
#include "hawser/record/recorder.hpp"
#include "hawser/run/bodies_in_contact.hpp"
#include "hawser/run/events.hpp"
#include "hawser/run/feeder_nodes.hpp"
#include "hawser/run/hull_check.hpp"
#include "hawser/run/output_place.hpp"
#include "hawser/run/progress.hpp"
#include "hawser/run/restart.hpp"
#include "hawser/run/run_parts.hpp"
#include "hawser/run/step_observer.hpp"
#include "hawser/run/volumes.hpp"

namespace hawser::run {
namespace {

// A part of the table of -log_view (PETSc: stage) for its lifetime; inside, events are named by term.
class LoggedPart {
 public:
  explicit LoggedPart(const char* name) {
    PetscLogStage part = -1;
    check(PetscLogStageGetId(name, &part));  // already registered by an earlier run of this process
    if (part < 0) check(PetscLogStageRegister(name, &part));
    check(PetscLogStagePush(part));
  }
  ~LoggedPart() { PetscLogStagePop(); }
};

// A solver error ends the run with the results computed so far.
void finish_failed(record::Recorder& recorder, const Progress& progress, const SolveError& e) {
  std::vector<std::string> messages = progress.messages();
  messages.push_back(fmt::format("warning: {}", e.what()));
  recorder.finish(std::move(messages));
}

// Time steps of a run up to `end` [s], with outputs, checkpoints and events. True: stopped early by a signal,
// on all ranks. Throws SolveError with everything on disk. Collective.
bool integrate(Simulation& sim, double end, record::Recorder& recorder, Events& events,
               FeederNodes& feeder_nodes, Progress& progress) {
  const LoggedPart logged("dynamics");
  accept_stop_signals();
  Dynamics& d = sim.dynamics();
  progress.begin(d.committed().s.time, end);
  StepObserver observer(sim, end, recorder, events, feeder_nodes, progress);
  try {
    d.run(
        end, [&](double t) { return observer.next_stop(t); },
        [&](const StepInfo& info) { return observer.observe(info); });
  } catch (const SolveError& e) {
    observer.save_state();
    finish_failed(recorder, progress, e);
    throw;
  }
  return observer.stopped();
}

// Prints the final results; `table`: of extremes.
void print_results(const model::Case& c, const record::Recorder& recorder, const std::string& table) {
  fmt::print("\n{}", table);
  for (const std::string& more : recorder.tables()) fmt::print("\n{}", more);
  if (c.dynamics.enabled) {
    const record::Audit& a = recorder.energy().figures();
    fmt::print("\n{}\n", advice::energy_of_run({.brought_in = a.brought_in,
                                                .kinetic = a.change.kinetic,
                                                .strain = a.change.strain,
                                                .friction = a.change.friction,
                                                .damping = a.change.damping,
                                                .unresolved = a.change.unresolved,
                                                .error = a.error,
                                                .percent = a.percent(),
                                                .size = a.size()}));
    if (const std::string n = a.note(); !n.empty()) fmt::print("\nnote: {}\n", n);
    if (const std::string w = recorder.energy().warning(); !w.empty()) fmt::print("\nwarning: {}\n", w);
  }
  for (const std::string& w : recorder.warnings()) fmt::print("\nwarning: {}\n", w);
}

// Newest checkpoint of a restart, and notes on differences from the run that wrote it.
struct RestartFrom {
  io::Checkpoint checkpoint;
  std::vector<std::string> notes;
};

bool is_over(double time, double end) { return time >= end * (1 - 1e-12); }

// Refuses a run without steps if its file would begin after its end, or would replace results. At the end of
// the case it writes a file of the last state.
void check_end(MPI_Comm comm, const std::string& restart, double time, double end, const OutputPlace& place) {
  if (place.appends() || !is_over(time, end)) return;
  on_root(comm, [&] {
    std::error_code unknown;
    if (!is_over(end, time) || std::filesystem::exists(place.path(), unknown))
      throw InputError(advice::cannot_continue(restart, advice::ends_before_checkpoint(time, end)));
  });
}

// Prints notes before the start, and warnings, which a restart does not repeat.
void print_notes(Simulation& sim, const std::vector<LoadedVolume>& volumes, const OutputPlace& place,
                 const std::optional<RestartFrom>& restart, Progress& progress) {
  const model::Case& c = sim.model();
  progress.print(advice::model_size(sim.mesh().nodes(), ranks_of(sim.system().comm()), sim.cut_elements()));
  progress.print_notes(place.notes());
  if (restart) progress.print_notes(restart->notes);
  progress.print_notes(all_notes(c, volumes, sim.notes()));
  if (restart) return;
  progress.print_warnings(sim.warnings());
}

// Sets the simulation to its checkpoint.
void restore_run(const io::Checkpoint& checkpoint, const std::string& path, Simulation& sim, Events& events,
                 FeederNodes& feeder_nodes, Progress& progress) {
  for (const std::string& e : events.restore(checkpoint)) progress.print(e);
  feeder_nodes.restore(checkpoint, path);
  restore(checkpoint, sim);
  for (const std::string& e : events.apply_due()) progress.print(e);
}

// The recorder of a run, created at the first output, so that a case without equilibrium leaves no file.
class RecorderAtFirstOutput {
 public:
  RecorderAtFirstOutput(Simulation& sim, const std::vector<LoadedVolume>& volumes, io::RunInfo run_info,
                        const std::optional<RestartFrom>& restart, bool appends, const Progress& progress)
      : sim_(sim),
        volumes_(volumes),
        run_info_(std::move(run_info)),
        restart_(restart),
        appends_(appends),
        progress_(progress) {}
  bool exists() const { return recorder_.has_value(); }
  // Collective at the first call.
  record::Recorder& get() {
    if (recorder_) return *recorder_;
    run_info_.messages = progress_.messages();
    return recorder_.emplace(sim_.subject(surfaces(volumes_)), volume_meshes(sim_.model(), volumes_),
                             std::move(run_info_),
                             appends_ ? record::RecorderFile::append : record::RecorderFile::create,
                             restart_ ? &restart_->checkpoint : nullptr);
  }

 private:
  Simulation& sim_;
  const std::vector<LoadedVolume>& volumes_;
  io::RunInfo run_info_;
  const std::optional<RestartFrom>& restart_;
  const bool appends_;
  const Progress& progress_;
  std::optional<record::Recorder> recorder_;
};

// Statics with an output for each stage. If it fails, the file is completed, if there is one.
void find_equilibrium_with_outputs(Simulation& sim, Events& events, RecorderAtFirstOutput& recorder,
                                   Progress& progress) {
  try {
    const LoggedPart logged("statics");
    solve_static_stages(sim, events, progress, [&](size_t k) {
      if (k + 1 < sim.model().stages.size()) recorder.get().stage(k, sim.state().at_rest());
    });
  } catch (const SolveError& e) {
    if (recorder.exists()) finish_failed(recorder.get(), progress, e);
    throw;
  }
  // Statics has a pair for every element and volume that may meet, motion a few of them.
  release_freed_memory();
}

// Starts dynamics from the static equilibrium, or from the start shape without statics; writes a checkpoint
// so that a run killed early can be continued.
void start_motion(Simulation& sim, Events& events, record::Recorder& recorder, Progress& progress) {
  for (const std::string& e : events.begin()) progress.print(e);
  sim.dynamics().start(sim.state());
  progress.print_notes(bodies_driven_apart(sim.model(), sim.system(), sim.dynamics().committed_kinematics()));
  // A start at rest is recorded at rest: initial velocities of motions are applied after it.
  recorder.start(sim.model().statics.enabled ? sim.state().at_rest() : sim.dynamics().committed_kinematics());
  sim.state() = State();  // dynamics has a separate copy
  recorder.checkpoint(make_checkpoint(sim, recorder, events));
}

// Brings simulation and recorder to where time steps begin, or a run of statics ends.
void start_or_resume(Simulation& sim, const std::optional<RestartFrom>& restart, const std::string& path,
                     bool appends, Events& events, FeederNodes& feeder_nodes, record::Recorder& recorder,
                     Progress& progress) {
  if (restart) {
    restore_run(restart->checkpoint, path, sim, events, feeder_nodes, progress);
    // A new file begins with the state from which the run continues.
    if (!appends) recorder.output(sim.dynamics().committed_kinematics());
  } else if (sim.model().dynamics.enabled) {
    start_motion(sim, events, recorder, progress);
  } else {
    recorder.start(sim.state().at_rest());
  }
}

// Prints the end of the run. stopped: by a signal.
void print_end(Simulation& sim, const record::Recorder& recorder, const std::string& table, bool stopped,
               double end) {
  const model::Case& c = sim.model();
  print_results(c, recorder, table);
  const std::string& path = recorder.file().path();
  if (stopped) fmt::print("\n{}\n", advice::stopped_by_signal(sim.dynamics().committed().s.time, end, path));
  fmt::print("\nresults: {}\n", path);
  fmt::print("view them: hawser view {}\n", path);
  if (c.output.xdmf) fmt::print("in ParaView: paraview {}\n", recorder.file().xdmf_path());
  std::fflush(stdout);
}

}  // namespace

int run(MPI_Comm comm, const RunOptions& options) {
  const int rank = rank_of(comm);
  const bool prints = rank == 0 && !options.quiet;
  const bool restarted = !options.restart.empty();
  Progress progress(prints);
  model::Case read = io::read_case(options.case_path, read_progress(progress), comm, options.changes);
  if (!options.output.empty()) read.output.file = std::filesystem::absolute(options.output).string();
  const OutputPlace place(comm, read.output.file, options.restart, read.inputs);
  read.output.file = place.path();
  if (restarted && !read.dynamics.enabled) throw InputError(advice::restart_needs_dynamics(read));
  std::vector<LoadedVolume> volumes = load_volumes(read, comm, read_progress(progress));
  set_hydrostatics(read, volumes);
  read = with_targets_met(comm, std::move(read), volumes, progress, options.restart);
  io::RunInfo about = run_info(comm, read, options.options_text);
  forget_file(read);
  std::vector<BodySkeleton> of_bodies = skeletons(read, volumes);
  Simulation sim(comm, std::move(read), surfaces(volumes), std::move(of_bodies), volume_facets(volumes));
  sim.forget_lines_of_others();
  const model::Case& c = sim.model();
  const double end =
      options.stop_at > 0 ? std::min(options.stop_at, c.dynamics.duration) : c.dynamics.duration;
  std::optional<RestartFrom> restart;
  if (restarted) {
    restart.emplace(read_restart(options.restart, sim));
    check_end(comm, options.restart, restart->checkpoint.time, end, place);
    restart->notes = compare_changes(comm, options.restart, c.changes);
  }
  print_notes(sim, volumes, place, restart, progress);
  if (!restart && !c.statics.enabled) sim.check_inside();

  Events events(comm, sim);
  RecorderAtFirstOutput at_first_output(sim, volumes, std::move(about), restart, place.appends(), progress);
  if (restart) {
    progress.print(advice::continuing_from(options.restart, restart->checkpoint.time));
    if (is_over(restart->checkpoint.time, end)) progress.print(advice::nothing_left());
  } else if (c.statics.enabled) {
    find_equilibrium_with_outputs(sim, events, at_first_output, progress);
  }

  record::Recorder& recorder = at_first_output.get();
  FeederNodes feeder_nodes(sim);
  start_or_resume(sim, restart, options.restart, place.appends(), events, feeder_nodes, recorder, progress);

  if (c.dynamics.enabled) progress.print_warnings(recorder.remarks());
  const bool stopped = c.dynamics.enabled && integrate(sim, end, recorder, events, feeder_nodes, progress);
  progress.end();
  progress.print_notes(events.not_happened());
  if (c.dynamics.enabled)
    progress.print_notes(
        sim.take_stiffness_raises(fmt::format("by t = {:.6g} s", sim.dynamics().committed().s.time)));
  const std::string table = recorder.finish(progress.messages());
  if (prints) print_end(sim, recorder, table, stopped, end);
  if (stopped) return kExitStopped;
  if (!c.dynamics.enabled || !recorder.energy().figures().wrong()) return 0;
  // A nonzero exit code always has a printed reason.
  if (rank == 0 && !prints) fmt::print(stderr, "hawser: {}\n", recorder.energy().warning());
  return kExitEnergy;
}

int print_case(MPI_Comm comm, const std::string& case_path, const std::vector<std::string>& changes) {
  const std::string json = io::case_json(io::read_case(case_path, {}, comm, changes));
  if (rank_of(comm) == 0) fmt::print("{}\n", json);
  return 0;
}

}  // namespace hawser::run
