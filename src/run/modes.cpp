// Table of natural modes, and the results file with one output per mode.
#include "hawser/run/modes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hawser/advice/modes.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/freedoms.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/check.hpp"
#include "hawser/record/result_parts.hpp"
#include "hawser/run/events.hpp"
#include "hawser/run/hull_check.hpp"
#include "hawser/run/output_place.hpp"
#include "hawser/run/run_parts.hpp"
#include "hawser/run/simulation.hpp"
#include "hawser/run/volumes.hpp"
#include "hawser/solve/natural_modes.hpp"
#include "hawser/terms/dynamic_positioning.hpp"

namespace hawser::run {
namespace {

// Amplitude of drawn modes: largest displacement relative to the longest line, and upper limit of the
// rotation of bodies.
constexpr double kDrawn = 0.05, kTurned = 0.3;  // relative; rad
// Smallest fraction of a body's kinetic energy in a degree of freedom that is named.
constexpr double kNamed = 0.2;

// Place of the largest translation or rotation of a mode, the same on all ranks.
struct Extent {
  double size = 0;
  int node = -1;  // of the mesh; -1: none
  Vec3 along = Vec3::Zero();
};

Extent largest(MPI_Comm comm, const LocalMesh& local, const std::vector<Vec3>& values) {
  Extent p;
  for (size_t n = 0; n < static_cast<size_t>(local.owned); ++n)
    if (const double size = values[n].norm(); size > p.size)
      p = {size, local.global[n], values[n].cwiseAbs()};
  broadcast_largest(comm, p.size, 0, p);
  return p;
}

// The floating body with the largest motion, at its origin or a line attachment, relative to `size`; the same
// on all ranks.
struct MovingBody {
  int body = -1;  // in the case; -1: none moves by half of it
  double fraction = 0.5;
};

MovingBody moving_body(MPI_Comm comm, const Simulation& sim, const std::vector<Vec3>& values, double size) {
  const model::Case& c = sim.model();
  const LocalMesh& local = sim.local();
  std::vector<double> moved(c.bodies.size());
  for (size_t n = 0; n < static_cast<size_t>(local.owned); ++n) {
    const Node& node = local.node(n);
    int body = -1;
    if (node.body >= 0) {
      body = node.body;
    } else {
      const LineSpan& span = sim.mesh().lines[node.line];
      const int i = local.global[n] - span.first_node;
      if (i != 0 && i != span.nodes - 1) continue;
      const model::End& e = c.lines[node.line].end(i == 0 ? LineEnd::A : LineEnd::B);
      if (e.kind == model::EndKind::body) body = c.body_index(e.carrier);
    }
    if (c.floats(body)) moved[body] = std::max(moved[body], values[n].norm());
  }
  if (!moved.empty()) all_reduce(comm, MPI_MAX, moved);
  MovingBody out;
  for (size_t b = 0; b < moved.size(); ++b)
    if (moved[b] >= out.fraction * size) out = {static_cast<int>(b), moved[b] / size};
  return out;
}

// Freedoms of a floating body in a mode, such as "pitch, surge", the largest first: those with at least a
// fifth of the kinetic energy m v_c²/2 + sum I_k w_k²/2, in body axes, the same on all ranks. turns: the
// origin is at rest, and only rotations are named.
std::string freedoms(MPI_Comm comm, Simulation& sim, const NaturalMode& mode, int body, bool turns) {
  const model::BodyMass& m = *sim.model().bodies[body].mass;
  std::vector<double> energy(6, 0.0);
  if (const int n = sim.bodies().local_node(body); n >= 0 && sim.local().owns(n)) {
    const Mat3 axes = sim.state().q[n].toRotationMatrix();
    const Vec3 turn = axes.transpose() * mode.rotation[n];
    const Vec3 displacement = axes.transpose() * mode.shape[n];  // of the centre of mass
    for (int k = 0; k < 3; ++k) {
      energy[k] = turns ? 0 : m.mass * displacement[k] * displacement[k];
      energy[3 + k] = m.inertia[k] * turn[k] * turn[k];
    }
  }
  all_reduce(comm, MPI_MAX, energy);
  const double sum = std::accumulate(energy.begin(), energy.end(), 0.0);
  std::vector<size_t> order = {0, 1, 2, 3, 4, 5};
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return energy[a] > energy[b]; });
  std::vector<std::string> named;
  for (const size_t k : order)
    if (energy[k] >= kNamed * sum && sum > 0) named.push_back(kFreedomNames[k]);
  return fmt::format("{}", fmt::join(named, ", "));
}

double period_of(const NaturalMode& mode) { return 2 * M_PI / std::sqrt(mode.squared); }

void without_added_mass(model::Case& c) {
  for (model::LineType& t : c.line_types) t.Ca_normal = t.Ca_axial = 0;
  for (model::Body& b : c.bodies)
    if (b.mass)
      for (model::BodyMember& m : b.mass->members) m.added = m.axial_added = 0;
}

// True if the modes have damping ratios, which come with frequency-dependent added mass.
bool has_platforms(const model::Case& c) {
  return std::any_of(c.bodies.begin(), c.bodies.end(),
                     [](const model::Body& b) { return b.mass && b.mass->hydrodynamics; });
}

std::string row(MPI_Comm comm, Simulation& sim, int number, const NaturalMode& mode,
                const Extent& translation, const Extent& rotation) {
  const Mesh& mesh = sim.mesh();
  const bool turns = translation.node < 0;
  const Extent& p = turns ? rotation : translation;
  const bool vibrates = mode.squared > kFreeMotion;
  std::string when =
      vibrates ? fmt::format("{:>12.5g} {:>14.5g}", period_of(mode), 1 / period_of(mode))
               : fmt::format("{:>12} {:>14}", mode.squared < -kFreeMotion ? "unstable" : "free", "-");
  if (has_platforms(sim.model()))
    when += vibrates ? fmt::format(" {:>13.3g}", mode.damping_ratio) : fmt::format(" {:>13}", "-");
  std::string where = mesh.place(p.node);
  const MovingBody with = moving_body(comm, sim, turns ? mode.rotation : mode.shape, p.size);
  if (with.body >= 0 && mesh.node(p.node).body < 0) {
    const std::string body = "body " + sim.model().bodies[with.body].name;
    where = with.fraction > 0.99 ? body + " (" + where + ")" : where + ", with " + body;
  }
  if (with.body >= 0) where += ": " + freedoms(comm, sim, mode, with.body, turns);
  return fmt::format("{:>4} {}  {:>5.2f} {:>5.2f} {:>5.2f}  {}{}\n", number, when, p.along.x(), p.along.y(),
                     p.along.z(), where, turns ? ", rotation without displacement" : "");
}

io::ResultContents contents(MPI_Comm comm, const Simulation& sim, const std::vector<LoadedVolume>& volumes,
                            const ModesOptions& options, int count) {
  const model::Case& c = sim.model();
  io::ResultContents out;
  out.run = run_info(comm, c, options.options_text);
  out.line_nodes = record::nodes_of_lines(sim.mesh());
  out.line_labels = record::result_line_labels(c, sim.mesh());
  out.volumes = volume_meshes(c, volumes);
  out.fields = {{"position", "m", 3}, {"mode_shape", "1", 3}};
  out.series = {{"modes", {{"period", "s", 1}, {"frequency", "Hz", 1}}}};
  out.bodies = static_cast<int>(c.bodies.size());
  for (const auto& b : c.bodies) out.body_names.push_back(b.name);
  out.xdmf = c.output.xdmf;
  out.expected_outputs = out.expected_steps = count + 1;
  out.body_nodes = sim.mesh().body_nodes();
  return out;
}

std::vector<double> flat(const std::vector<Vec3>& values, int nodes) {
  std::vector<double> out;
  for (int n = 0; n < nodes; ++n) out.insert(out.end(), values[n].begin(), values[n].end());
  return out;
}

// Factor of the translations [1] and rotations [rad] of a drawn mode, m.
double displayed_size(MPI_Comm comm, const Simulation& sim, const NaturalMode& mode) {
  double size = sim.model().lines.empty() ? 1 : 0;  // m
  double turn = 0;                                  // rad
  for (const auto& line : sim.model().lines) size = std::max(size, kDrawn * model::length_of(line));
  for (int b = 0; b < sim.bodies().size(); ++b)
    if (const int n = sim.bodies().local_node(b); n >= 0) turn = std::max(turn, mode.rotation[n].norm());
  all_reduce(comm, MPI_MAX, turn);
  return size * turn > kTurned ? kTurned / turn : size;
}

// The state `at` displaced by `size` times a mode.
State moved(const State& at, const NaturalMode& mode, double size) {
  State out = at;
  for (size_t n = 0; n < out.x.size(); ++n) {
    out.x[n] += size * mode.shape[n];
    out.q[n] = exp_so3(size * mode.rotation[n]) * out.q[n];
  }
  return out;
}

void write(MPI_Comm comm, Simulation& sim, const std::vector<LoadedVolume>& volumes,
           const ModesOptions& options, const std::string& path, const std::vector<NaturalMode>& modes,
           const std::vector<std::string>& messages) {
  const int rank = rank_of(comm);
  const LocalMesh& local = sim.local();
  std::vector<int> owned(local.global.begin(), local.global.begin() + local.owned);
  io::ResultsFile file = io::ResultsFile::create(
      comm, path, contents(comm, sim, volumes, options, static_cast<int>(modes.size())), std::move(owned));
  const std::vector<Vec3> zero(static_cast<size_t>(local.owned), Vec3::Zero());
  file.write_output(0, {flat(sim.state().x, local.owned), flat(zero, local.owned)},
                    record::body_poses(sim.bodies(), sim.system(), sim.state().at_rest()));
  double number = 0;
  for (const NaturalMode& mode : modes) {
    ++number;
    const State displayed = moved(sim.state(), mode, displayed_size(comm, sim, mode));
    const double period = mode.squared > kFreeMotion ? period_of(mode) : HUGE_VAL;
    file.append_series(number, {rank == 0 ? std::vector<double>{period, 1 / period} : std::vector<double>{}});
    file.write_output(number, {flat(displayed.x, local.owned), flat(mode.shape, local.owned)},
                      record::body_poses(sim.bodies(), sim.system(), displayed.at_rest()));
  }
  file.finish({}, {}, messages);
}

}  // namespace

int modes(MPI_Comm comm, const ModesOptions& options) {
  const int rank = rank_of(comm);
  Progress progress(rank == 0 && !options.quiet);
  model::Case c = io::read_case(options.case_path, read_progress(progress), comm, options.changes);
  const OutputPlace place(comm, path_of_output(c.path, options.output, "-modes.h5"), "", c.inputs);
  if (!c.statics.enabled) throw InputError(advice::modes_need_statics(c));
  std::vector<LoadedVolume> volumes = load_volumes(c, comm, read_progress(progress));
  set_hydrostatics(c, volumes);
  c = with_targets_met(comm, std::move(c), volumes, progress);
  if (!options.added_mass) without_added_mass(c);
  Simulation sim(comm, c, surfaces(volumes), skeletons(c, volumes), volume_facets(volumes));
  progress.print_notes(place.notes());
  progress.print_notes(all_notes(c, volumes, sim.notes()));
  progress.print_warnings(sim.warnings());
  Events events(comm, sim);
  const StaticsReport statics = solve_static_stages(sim, events, progress);
  if (auto* thrusters = sim.system().find<DynamicPositioning>()) thrusters->integrate_at_rest(false);
  const std::vector<NaturalMode> modes = natural_modes(sim.system(), sim.state().at_rest(), options.count);
  progress.end();
  std::string table =
      fmt::format("{:>4} {:>12} {:>14}{}  {:^17}  {}\n", "mode", "period [s]", "frequency [Hz]",
                  has_platforms(c) ? " damping ratio" : "", "x, y, z there", "largest at");
  for (size_t i = 0; i < modes.size(); ++i)
    table += row(comm, sim, static_cast<int>(i) + 1, modes[i], largest(comm, sim.local(), modes[i].shape),
                 largest(comm, sim.local(), modes[i].rotation));
  const auto unstable = std::count_if(modes.begin(), modes.end(),
                                      [](const NaturalMode& m) { return m.squared < -kFreeMotion; });
  if (statics.negative_eigenvalues > unstable)
    table += advice::faster_instabilities(statics.negative_eigenvalues - unstable) + "\n";
  write(comm, sim, volumes, options, place.path(), modes, progress.messages());
  if (rank == 0 && !options.quiet) {
    fmt::print("\n{}", table);
    if (modes.size() < static_cast<size_t>(options.count))
      fmt::print("\n{}\n", advice::model_has_no_more_modes(modes.size()));
    fmt::print("\nresults: {}\n", place.path());
  }
  return 0;
}

}  // namespace hawser::run
