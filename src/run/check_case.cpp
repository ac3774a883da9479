// Output of `hawser check`: summary of the case, start contact, partition, and results of a trial run of the
// beginning.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "hawser/advice/cost.hpp"
#include "hawser/advice/run.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/model/summary.hpp"
#include "hawser/record/recorder.hpp"
#include "hawser/record/result_parts.hpp"
#include "hawser/record/water_errors.hpp"
#include "hawser/run/bodies_in_contact.hpp"
#include "hawser/run/cost.hpp"
#include "hawser/run/driver.hpp"
#include "hawser/run/events.hpp"
#include "hawser/run/held_bodies.hpp"
#include "hawser/run/hull_check.hpp"
#include "hawser/run/lines_on_bed.hpp"
#include "hawser/run/node_owners.hpp"
#include "hawser/run/progress.hpp"
#include "hawser/run/radiation.hpp"
#include "hawser/run/restart.hpp"
#include "hawser/run/run_parts.hpp"
#include "hawser/run/start_contact.hpp"
#include "hawser/run/volumes.hpp"
#include "hawser/solve/start_shape.hpp"

namespace hawser::run {
namespace {

constexpr double kTrialTime = 4;  // CPU s, with the search for lengths
constexpr double kReserved = 1;   // CPU s of it, for the trial run if the search used the rest

struct TrialOver {};  // thrown when the search has used the time of the trial

// Prints the start contact of lines and volumes; false if a line starts inside and statics must move it out.
// Throws InputError without statics. On one rank.
bool check_start(const model::Case& c, const Mesh& mesh, const Bodies& bodies,
                 const std::vector<std::shared_ptr<const Surface>>& surfaces) {
  const std::vector<ContactVolume> volumes = volumes_of_lines(c, surfaces);
  if (volumes.empty()) return true;
  const LocalMesh local = local_mesh(mesh, NodeRanks::all_of(mesh.nodes()), 0, 1);
  const StartShape shape = start_shape(MPI_COMM_SELF, c, local, bodies, surfaces);
  const Feeders feeders(local, c);
  const PlacedLines lines{MPI_COMM_SELF, c, local, bodies, &feeders, shape.state.at_rest()};
  const StartContact start = start_contact(lines, volumes);
  for (const auto& n : start.notes) fmt::print("note: {}\n", n);
  for (const auto& w : start.warnings) fmt::print("warning: {}\n", w);
  if (start.inside.empty()) return true;
  std::fflush(stdout);
  if (!c.statics.enabled) throw InputError(c.path + ": " + still_inside(lines, volumes, start));
  return false;
}

void print_volumes(const model::Case& c, const std::vector<LoadedVolume>& volumes) {
  for (size_t i = 0; i < volumes.size(); ++i) {
    const LoadedVolume& v = volumes[i];
    if (c.volumes[i].roller || model::is_repeated(c, v.name)) continue;
    fmt::print("volume {}: {}\n", v.name, v.report);
    for (const auto& n : v.notes) fmt::print("  note: {}\n", n);
  }
  fmt::print("{}", hulls_text(c, volumes));
}

// Prints the partition for `ranks` ranks; returns its imbalance.
double print_partition(const model::Case& c, const Mesh& mesh, const Bodies& bodies, int ranks) {
  const NodeRanks owner = node_owners(MPI_COMM_SELF, c, mesh, bodies, ranks);
  const Balance shares = balance(mesh, owner, ranks);
  std::vector<int> nodes(static_cast<size_t>(ranks), 0);
  for (size_t r = 0; r < owner.runs().size(); ++r)
    nodes[owner.runs()[r].rank] += owner.end(r) - owner.runs()[r].first;
  fmt::print("{}\n", advice::partition(nodes, shares.imbalance, shares.cut_lines, shares.cut_elements));
  return shares.imbalance;
}

// Runs the beginning of the case for `budget` CPU s and prints the results.
TrialRun print_trial(Simulation& sim, const model::Case& c, double budget) {
  record::WaterErrors water(c, sim.system());
  const std::vector<TouchingVolumes> at_start = touching_volumes(sim.system(), sim.state().at_rest());
  bool rests = !c.statics.enabled;
  TrialRun tried = trial_run(sim, c, budget, [&](const Kinematics& state) {
    if (!std::exchange(rests, true)) {
      for (const std::string& line : lines_on_bed(sim.model(), sim.system(), state)) fmt::print("{}\n", line);
      for (const std::string& line : platforms_held(c, sim.system(), state)) fmt::print("{}\n", line);
      for (const std::string& line : periods_on_lines(sim)) fmt::print("{}\n", line);
      const std::string below = lines_below_water(c, sim.system(), state);
      if (!below.empty()) fmt::print("note: {}\n", below);
      const MPI_Comm comm = sim.system().comm();
      for (const std::string& w : platforms_off_start(comm, c, sim.bodies(), state))
        fmt::print("warning: {}\n", w);
      for (const std::string& w : platforms_tilted(comm, c, sim.bodies(), state))
        fmt::print("warning: {}\n", w);
      for (const std::string& note : bodies_moved_by_statics(c, sim.system(), sim.bodies(), state, at_start,
                                                             sim.contact_friction_in_statics()))
        fmt::print("note: {}\n", note);
    }
    water.update_sampled(state);
  });
  for (const std::string& w : water.warnings()) fmt::print("warning: {}\n", w);
  fmt::print("{}\n", cost_sentence(tried));
  return tried;
}

// Meets the targets of the case; false if that takes longer than the trial.
bool meet_targets_in_trial(model::Case& c, const std::vector<LoadedVolume>& volumes, Progress& progress) {
  const double begun = cpu_time();
  try {
    c = with_targets_met(MPI_COMM_SELF, c, volumes, progress, "", [begun] {
      if (cpu_time() - begun > kTrialTime) throw TrialOver();
    });
    return true;
  } catch (const TrialOver&) {
    progress.end();
    return false;
  }
}

struct StartReport {
  bool starts_outside = true;  // no line starts inside a volume
  double imbalance = 1;        // of the partition
};

// Prints start contact and partition. Then frees what only they need of the case and measures the memory that
// all ranks of a run have.
StartReport print_start(model::Case& c, const std::vector<LoadedVolume>& volumes, int ranks,
                        MemoryUse& memory) {
  const Mesh mesh = build_mesh(c);
  const Bodies bodies(c.bodies);
  StartReport out;
  out.starts_outside = check_start(c, mesh, bodies, surfaces(volumes));
  out.imbalance = print_partition(c, mesh, bodies, ranks);
  forget_file(c);
  release_freed_memory();
  memory.shared = memory_now();
  memory.of_files = -file_memory_now();
  return out;
}

// Prints everything of a case that was read, on one rank. ranks: those of the run that is planned.
void print_check(model::Case c, const std::vector<LoadedVolume>& volumes, const CheckOptions& options,
                 int ranks, Progress& progress) {
  const double begun = cpu_time();
  const bool met = !options.trial || meet_targets_in_trial(c, volumes, progress);
  const double searched = cpu_time() - begun;
  fmt::print("{}", model::summary(c));
  print_volumes(c, volumes);
  if (!met) {
    fmt::print("{}\n", advice::lengths_not_found_in_trial(kTrialTime));
    return;
  }
  MemoryUse memory{.read = peak_memory()};
  io::RunInfo about = run_info(MPI_COMM_SELF, c, "");
  const StartReport start = print_start(c, volumes, ranks, memory);
  const double peak_before = peak_memory();
  std::vector<BodySkeleton> of_bodies = skeletons(c, volumes);
  Simulation sim(MPI_COMM_SELF, std::move(c), surfaces(volumes), std::move(of_bodies),
                 volume_facets(volumes));
  const model::Case& checked = sim.model();
  if (options.verbose)
    for (const std::string& d : sim.details()) fmt::print("detail: {}\n", d);
  fmt::print("{}\n", advice::case_is_valid(start.starts_outside));
  std::fflush(stdout);
  record::Recorder recorder(sim.subject(surfaces(volumes)), volume_meshes(checked, volumes), std::move(about),
                            record::RecorderFile::none);
  TrialRun tried;
  double checkpoint = planned_numbers(sim, recorder);
  if (options.trial) {
    tried = print_trial(sim, checked, std::max(kTrialTime - searched, kReserved));
    // The search for neighbours and the partition may have taken more than all that follows.
    memory.moved = tried.moved;
    memory.measured = peak_memory() > peak_before ? peak_memory() : memory_now();
    memory.of_files += file_memory_now();
    fmt::print("{}\n", memory_sentence(memory, start.imbalance, ranks));
    if (tried.moved)
      checkpoint = io::checkpoint_numbers(make_checkpoint(sim, recorder, Events(MPI_COMM_SELF, sim)));
  }
  const io::ResultsSize size =
      io::results_size(recorder.contents(), record::expected_rows(checked, tried.steps, checkpoint));
  fmt::print("{}\n", size_sentence(size, std::filesystem::path(checked.output.file).parent_path().string()));
}

}  // namespace

int check_case(MPI_Comm comm, const CheckOptions& options) {
  const int rank = rank_of(comm);
  Progress progress(rank == 0);
  model::Case c = io::read_case(options.case_path, read_progress(progress), comm, options.changes);
  if (!options.radiation.empty()) {
    progress.end();
    write_radiation(comm, c, options.radiation);
  }
  // Surfaces that ranks share are freed collectively: all ranks free the bed's after those of volumes.
  const auto bed = c.environment.seabed.surface;
  const std::vector<LoadedVolume> volumes = load_volumes(c, comm, read_progress(progress));
  set_hydrostatics(c, volumes);
  if (rank != 0) return 0;
  progress.end();
  print_check(std::move(c), volumes, options, options.ranks > 0 ? options.ranks : ranks_of(comm), progress);
  return 0;
}

}  // namespace hawser::run
