// Common parts of `hawser run` and `hawser modes`: statics with its notes, description of a run.
#include "hawser/run/run_parts.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <ctime>
#include <memory>
#include <optional>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "hawser/advice/run.hpp"
#include "hawser/advice/statics.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/case_json.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/model/notes.hpp"
#include "hawser/model/schema.hpp"
#include "hawser/run/bodies_in_contact.hpp"
#include "hawser/run/events.hpp"
#include "hawser/run/hull_check.hpp"
#include "hawser/run/line_pairs.hpp"
#include "hawser/run/lines_on_bed.hpp"
#include "hawser/run/targets.hpp"
#include "hawser/run/version.hpp"

namespace hawser::run {

io::RunInfo run_info(MPI_Comm comm, const model::Case& c, const std::string& petsc_options) {
  io::RunInfo info;
  if (rank_of(comm) != 0) return info;
  info.case_text = c.text;
  info.case_path = c.path;
  info.case_read = io::case_json(c);
  info.changes = fmt::format("{}", fmt::join(c.changes, "\n"));
  info.version = kVersion;
  info.options = petsc_options;
  info.ranks = ranks_of(comm);
  info.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  return info;
}

std::vector<std::string> all_notes(const model::Case& c, const std::vector<LoadedVolume>& volumes,
                                   const std::vector<std::string>& choices) {
  std::vector<std::string> all = c.change_notes;
  all.insert(all.end(), c.notes.begin(), c.notes.end());
  for (const auto& v : volumes)
    for (const auto& n : v.notes) all.push_back("volumes." + v.name + ": " + n);
  all.insert(all.end(), choices.begin(), choices.end());
  return model::grouped_notes(model::notes_by_place(c, std::move(all)));
}

model::Case with_targets_met(MPI_Comm comm, model::Case c, const std::vector<LoadedVolume>& volumes,
                             Progress& progress, const std::string& restart,
                             const std::function<void()>& on_iteration) {
  if (!has_targets(c)) return c;
  MetTargets met;
  try {
    met = !restart.empty()
              ? with_lengths_of(c, restart, comm)
              : meet_targets(
                    comm, c, volumes,
                    [&](const StaticsReport& now) {
                      progress.statics(now.iterations, now.relaxation_steps, now.norms.relative());
                      if (on_iteration) on_iteration();
                    },
                    [&](const std::string& trial) { progress.busy(trial, 0); });
  } catch (const SolveError&) {
    progress.print_notes(model::grouped_notes(c.notes));  // may explain the failure
    throw;
  }
  progress.print_notes(model::notes_by_place(c, std::move(met.sentences)));
  met.model.output.file = c.output.file;  // may be set by the command line
  // The case was read again; its hydrostatics (set_hydrostatics) do not depend on lengths of lines.
  for (size_t b = 0; b < c.bodies.size(); ++b)
    if (const model::Body& from = c.bodies[b]; from.mass && from.mass->hull)
      met.model.bodies[b].mass->hull = from.mass->hull;
  return std::move(met.model);
}

namespace {

// Lines that hold each other without friction; none with friction. Collective.
std::optional<advice::HookedLines> hooked_without_friction(Simulation& sim) {
  if (sim.contact_friction_in_statics()) return std::nullopt;
  std::optional<advice::HookedLines> hooked = hooked_lines(sim.system(), sim.state().at_rest());
  if (hooked) hooked->friction = sim.model().contact.has_friction({});
  return hooked;
}

// hooked: lines that hold each other after many steps.
StaticsReport solve_one(Simulation& sim, Progress& progress, StartsFrom from,
                        std::optional<advice::HookedLines>& hooked) {
  constexpr int kManySteps = 500;  // of dynamic relaxation; more is unusual
  const model::Case& c = sim.model();
  const size_t before = sim.notes().size();
  advice::LongRelaxation relaxation{
      .steps = kManySteps,
      .line_pairs = sim.line_pairs() != nullptr,
      .slides_freely = sim.line_volume_contact() && !sim.contact_friction_in_statics()};
  bool reported = !relaxation.line_pairs && !relaxation.slides_freely;
  const StaticsReport s = sim.solve_statics(
      [&](const StaticsReport& now) {
        progress.statics(now.iterations, now.relaxation_steps, now.norms.relative());
        if (reported || now.relaxation_steps < kManySteps) return;
        reported = true;
        relaxation.hooked = hooked = hooked_without_friction(sim);
        progress.print("note: " + advice::long_relaxation(relaxation));
      },
      from);
  progress.print_notes({sim.notes().begin() + static_cast<std::ptrdiff_t>(before), sim.notes().end()});
  progress.print(
      advice::statics_done(s.iterations, s.relaxation_steps,
                           !sim.contact_friction_in_statics() && c.contact.has_friction(c.volumes)));
  for (const std::string& line : lines_on_bed(sim.model(), sim.system(), sim.state().at_rest()))
    progress.print(line);
  const std::string below = lines_below_water(c, sim.system(), sim.state().at_rest());
  if (!below.empty()) progress.print_notes({below});
  if (s.remaining) progress.print_warnings({advice::rests_out_of_balance(*s.remaining)});
  if (s.escapes > 0) progress.print("note: " + advice::unstable_equilibria_left(s.escapes));
  progress.print_warnings(sim.tilting_warnings());
  progress.print_warnings(platforms_tilted(sim.system().comm(), c, sim.bodies(), sim.state().at_rest()));
  if (s.negative_eigenvalues > 0)
    progress.print("warning: " + advice::unstable_at_rest(s.negative_eigenvalues));
  return s;
}

}  // namespace

StaticsReport solve_static_stages(Simulation& sim, Events& events, Progress& progress,
                                  const std::function<void(size_t)>& on_equilibrium) {
  const std::vector<TouchingVolumes> at_start = touching_volumes(sim.system(), sim.state().at_rest());
  StaticsReport last;
  std::optional<advice::HookedLines> hooked;
  try {
    events.solve_stages([&](StartsFrom from) { last = solve_one(sim, progress, from, hooked); },
                        [&](const std::string& text) { progress.print(text); }, on_equilibrium);
  } catch (const SolveError&) {
    if (!hooked) hooked = hooked_without_friction(sim);
    if (rank_of(sim.system().comm()) == 0)
      progress.print("note: " + advice::statics_failed(sim.model(), hooked));
    throw;
  }
  progress.print_warnings(model::notes_by_place(
      sim.model(),
      platforms_off_start(sim.system().comm(), sim.model(), sim.bodies(), sim.state().at_rest())));
  progress.print_notes(bodies_moved_by_statics(sim.model(), sim.system(), sim.bodies(), sim.state().at_rest(),
                                               at_start, sim.contact_friction_in_statics()));
  return last;
}

void forget_file(model::Case& c) {
  std::string().swap(c.text);  // assigning an empty text would keep the capacity
  if (c.tree) c.tree = std::make_shared<model::Value>(model::without_values(*c.tree));
}

void release_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

io::ReadProgress read_progress(Progress& progress) {
  return {[&progress](const std::string& title) { progress.print(title); },
          [&progress](const std::string& text, double seconds) { progress.busy(text, seconds); }};
}

}  // namespace hawser::run
