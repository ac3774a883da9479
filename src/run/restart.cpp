// Vectors, step control numbers and histories of force terms of a checkpoint, their checks after reading, and
// their restoration.
#include "hawser/run/restart.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <sstream>

#include "hawser/advice/restart.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/hdf5.hpp"
#include "hawser/io/results_size.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/model/schema.hpp"
#include "hawser/record/audit_checkpoint.hpp"
#include "hawser/record/clash_report.hpp"
#include "hawser/run/feeder_nodes.hpp"
#include "hawser/run/restart_file_check.hpp"
#include "hawser/run/version.hpp"

namespace hawser::run {
namespace {

const char* const kPosition = "position";
const char* const kVectors[] = {kPosition,
                                "velocity",
                                "acceleration",
                                "angular_velocity",
                                "angular_acceleration",
                                "algorithmic_acceleration",
                                "algorithmic_angular_acceleration"};

const char *const kReaction = "reaction", *const kMeanQ = "mean_force_algorithmic",
                  *const kMeanF = "mean_force_end";
const char* const kDirectors = "director_acceleration";
const char* const kAlgorithmicDirectors = "algorithmic_director_acceleration";

const std::string kResolvedUntil = "step.resolved until";
const std::string kKey = "key.";        // and a dotted key: its value, by number_of()
const char* const kKeys = "case.keys";  // how many of them there are

// Vectors of a state, const or not.
auto& vectors(auto& s, size_t i) {
  decltype(&s.s.x) all[] = {&s.s.x, &s.s.v, &s.s.a, &s.s.w, &s.s.alpha, &s.ax, &s.aw};
  return *all[i];
}

// Field with components number(n, k), k < `components`, of each node, evaluated when written.
template <class Number>
io::CheckpointField field_of(size_t owned, int components, Number number) {
  const auto width = static_cast<size_t>(components);
  return {components, {}, [owned, width, number] {
            std::vector<double> values(width * owned);
            for (size_t n = 0; n < owned; ++n)
              for (size_t k = 0; k < width; ++k) values[width * n + k] = number(n, k);
            return values;
          }};
}

// Hash of a text: 53 bits of FNV-1a (Fowler, Noll and Vo).
double number_of(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return static_cast<double>(hash >> 11);
}

// Identity of the state and contact history: rotating nodes, order of volumes, and values of the keys that a
// restart must not change. Positions are compared of bodies that move by their mass: that of another body is
// a part of its motion, and large farms have many of them.
std::map<std::string, double> signature(const Simulation& simulation) {
  std::map<std::string, double> out;
  double& beams = out["case.rotating nodes"];
  for (int n = 0; n < simulation.mesh().nodes(); ++n) beams += simulation.mesh().node(n).rotates;
  const auto& volumes = simulation.model().volumes;
  for (size_t v = 0; v < volumes.size(); ++v) out["case.volume " + volumes[v].name] = static_cast<double>(v);
  const auto& bodies = simulation.model().bodies;
  for (size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies.has(i) || !bodies[i].mass) continue;
    const model::Body& b = bodies[i];
    for (const auto& [key, value] : {std::pair{"position", b.position}, {"rotation_deg", b.rotation}})
      out[fmt::format("{}bodies.{}.{}", kKey, b.name, key)] =
          number_of(fmt::format("{:.9g} {:.9g} {:.9g}", value.x(), value.y(), value.z()));
  }
  double& keys = out[kKeys];
  const auto add = [&](const model::Value& tree, const std::string& prefix) {
    for (const auto& [key, value] : model::fixed_values(tree)) {
      out[kKey + prefix + key] = number_of(value);
      ++keys;
    }
  };
  if (simulation.model().tree) add(*simulation.model().tree, "");
  if (simulation.model().farm) {
    const std::vector<model::FarmPart>& parts =
        simulation.model().farm->parts;  // of which several may be of one file
    for (size_t k = 0; k < parts.size(); ++k)
      add(*parts[k].tree, fmt::format("farm[{}], {}: ", k, parts[k].given));
  }
  return out;
}

// The first of these numbers in which the case of a checkpoint differs; empty: none.
std::string difference(const std::map<std::string, double>& in_checkpoint,
                       const std::map<std::string, double>& in_case) {
  std::set<std::string> names;
  for (const auto* side : {&in_checkpoint, &in_case})
    for (const auto& [name, number] : *side) names.insert(name);
  for (const std::string& name : names) {
    const auto a = in_checkpoint.find(name);
    const auto b = in_case.find(name);
    if (a != in_checkpoint.end() && b != in_case.end() && a->second == b->second) continue;
    if (name == "case.rotating nodes") return advice::other_beams();
    if (name.starts_with("case.volume ")) return advice::other_volumes();
    if (!name.starts_with(kKey)) continue;
    const std::string key = name.substr(kKey.size());
    return advice::other_key(key, a == in_checkpoint.end() ? advice::KeyDiffers::missing_in_checkpoint
                                  : b == in_case.end()     ? advice::KeyDiffers::missing_in_case
                                                           : advice::KeyDiffers::other_value);
  }
  return "";
}

// Fault in the time, the step control numbers or this rank's part of the state; empty: none.
std::string damage(const io::Checkpoint& c) {
  const auto wrong = advice::damaged_checkpoint;
  if (!(c.time >= 0 && c.time < HUGE_VAL)) return wrong("the time", c.time);
  for (const auto& [name, value] : c.scalars)
    if (name.starts_with("step.") && !(value >= 0 && value <= 1e9)) return wrong(name, value);
  for (const auto& [name, field] : c.nodes)
    for (const double value : field.values)
      if (!std::isfinite(value)) return wrong(name, value);
  return "";
}

// True if an event of the case releases this end of a line.
bool releases(const model::Case& c, const std::string& line, LineEnd end) {
  return std::any_of(c.events.begin(), c.events.end(), [&](const model::Event& e) {
    return e.action.kind == model::Action::Kind::release && e.action.line == line && e.action.line_end == end;
  });
}

void restore_vectors(const io::Checkpoint& c, const LocalMesh& m, const char* name, std::vector<Vec3>& to) {
  const auto& f = c.nodes.at(name);
  const size_t owned = to.empty() ? 0 : m.owned;
  for (size_t n = 0; n < owned; ++n) to[n] = Eigen::Map<const Vec3>(f.values.data() + 3 * n);
}

// Positions and rotations of the owned nodes of a checkpoint; other nodes have none.
State restored_shape(const io::Checkpoint& c, const LocalMesh& m) {
  State s(m.nodes());
  s.time = c.time;
  restore_vectors(c, m, kPosition, s.x);
  const auto& q = c.nodes.at("rotation").values;
  const size_t owned = m.owned;
  for (size_t n = 0; n < owned; ++n) s.q[n] = Quat(q[4 * n], q[4 * n + 1], q[4 * n + 2], q[4 * n + 3]);
  return s;
}

// Positions, rotations and rates of a checkpoint, ghosts included. Collective.
AlphaState restored_state(const io::Checkpoint& c, const LocalMesh& m, const System& system) {
  AlphaState s;
  s.s = restored_shape(c, m);
  alpha_start(m, s);
  const size_t owned = m.owned;
  for (size_t i = 0; i < std::size(kVectors); ++i) restore_vectors(c, m, kVectors[i], vectors(s, i));
  for (const auto& [name, values] : {std::pair{kDirectors, &s.s.directors}, {kAlgorithmicDirectors, &s.ad}}) {
    if (!has_directors(m)) break;
    const auto& f = c.nodes.at(name).values;
    for (size_t n = 0; n < owned; ++n) (*values)[n] = Eigen::Map<const Mat3>(f.data() + 9 * n);
  }
  system.update_ghosts(s.s);
  system.update_ghosts(s.ax);
  if (has_directors(m)) {
    system.update_ghosts(s.aw);
    system.update_ghosts(s.ad);
  }
  return s;
}

// Fault for an end of a line that the case holds at an anchor or a floating body, at another position than
// that of the checkpoint; empty: none. Bodies with prescribed motion are excluded, since their motion may
// differ. Collective.
std::string moved_end(const io::Checkpoint& c, Simulation& simulation) {
  constexpr double kRounding = 1e-6;                          // m
  if (!Events::has_all_of(c, simulation.model())) return "";  // Events::restore reports it
  const System& system = simulation.system();
  const LocalMesh& m = simulation.local();
  const Mesh& mesh = *m.mesh;
  State s = restored_shape(c, m);
  system.update_ghosts(s);
  for (const TiedNode& tied : system.tied_nodes().nodes()) {
    if (!m.owns(tied.node) || tied.body >= 0 || tied.position_mask != 7) continue;
    if (tied.frame >= 0 && m.node(tied.frame).body < 0) continue;
    const Vec3 held = tied.frame < 0 ? tied.at : Vec3(s.x[tied.frame] + s.q[tied.frame] * tied.at);
    if ((held - s.x[tied.node]).norm() < kRounding) continue;
    const int line = m.node(tied.node).line;
    for (const LineEnd end : kLineEnds)
      if (mesh.lines[line].end_node(end) == m.global[tied.node] &&
          !releases(simulation.model(), mesh.line_names[line], end))
        return advice::other_end(mesh.line_names[line], end, s.x[tied.node], held);
  }
  return "";
}

// Stores state, reactions and mean forces of the owned nodes.
void save_nodes(const LocalMesh& m, const AlphaState& s, const std::vector<double>& reactions,
                const MeanForces& mean, io::Checkpoint& c) {
  const size_t owned = m.owned;
  for (size_t i = 0; i < std::size(kVectors); ++i)
    c.nodes[kVectors[i]] = field_of(owned, 3, [&values = vectors(s, i)](size_t n, size_t k) {
      return values.empty() ? 0 : values[n][static_cast<Eigen::Index>(k)];
    });
  for (const auto& [name, values] : {std::pair{kDirectors, &s.s.directors}, {kAlgorithmicDirectors, &s.ad}})
    if (has_directors(m))
      c.nodes[name] =
          field_of(owned, 9, [&directors = *values](size_t n, size_t k) { return directors[n].data()[k]; });
  c.nodes["rotation"] = field_of(owned, 4, [&values = s.s.q](size_t n, size_t k) {
    return k == 0 ? values[n].w() : values[n].vec()[static_cast<Eigen::Index>(k) - 1];
  });
  const auto rows = [&](const char* name, const std::vector<double>& values) {
    c.nodes[name] = field_of(owned, 6, [&m, &values](size_t n, size_t k) {
      const size_t b = 3 * static_cast<size_t>(m.block[n]);
      return !values.empty() && (k < 3 || m.rotates(static_cast<int>(n))) ? values[b + k] : 0.0;
    });
  };
  rows(kReaction, reactions);
  rows(kMeanQ, mean.q);
  rows(kMeanF, mean.f);
}

}  // namespace

double planned_numbers(Simulation& simulation, record::Recorder& recorder) {
  const LocalMesh& m = simulation.local();
  AlphaState s{simulation.state(), {}, {}, {}};
  alpha_start(m, s);
  const MeanForces none{std::vector<double>(3 * static_cast<size_t>(m.blocks()), 0.0),
                        std::vector<double>(3 * static_cast<size_t>(m.blocks()), 0.0)};
  io::Checkpoint c;
  save_nodes(m, s, none.q, none, c);
  recorder.save(c);
  return io::checkpoint_numbers(c);
}

io::Checkpoint make_checkpoint(Simulation& simulation, record::Recorder& recorder, const Events& events) {
  Dynamics& d = simulation.dynamics();
  io::Checkpoint c;
  c.time = d.committed().s.time;
  save_nodes(simulation.local(), d.committed(), d.reactions(), d.mean_forces(), c);
  for (const auto& term : simulation.system().terms())
    c.records[std::string(term->checkpoint_key())] = {
        term->checkpoint_kinds(), {}, [&owner = *term](NodeRange nodes) {
          return owner.checkpoint_records(nodes);
        }};
  c.scalars = signature(simulation);
  c.scalars["step.proposal"] = d.control().proposal();
  c.scalars["step.wait"] = d.control().wait();
  c.scalars["step.impact period"] = d.control().impact_period();
  c.scalars[kResolvedUntil] = d.control().resolved_until();
  c.scalars["step.last"] = d.last_step();
  double work = d.support_work();
  all_reduce(simulation.system().comm(), MPI_SUM, work);
  c.scalars["support_work"] = work;
  recorder.save(c);
  events.save(c);
  FeederNodes(simulation).save(c);
  return c;
}

namespace {

// Version of hawser that wrote the file, if it is another one than this; else empty. Collective.
std::string other_version(MPI_Comm comm, const std::string& path) {
  std::string version;
  on_root(comm, [&] { version = io::h5::read_text_attribute(io::h5::open_read(path), "version"); });
  version = first_text(comm, version);
  return version == kVersion ? "" : version;
}

InputError older(MPI_Comm comm, const std::string& path, const std::string& reason) {
  return InputError(advice::cannot_continue(
      path, advice::other_quantities(path, reason, other_version(comm, path), kVersion)));
}

}  // namespace

void check_records(const io::Checkpoint& c, const System& system, const std::string& path) {
  for (const auto& term : system.terms())
    if (const auto it = c.records.find(std::string(term->checkpoint_key()));
        it != c.records.end() && it->second.kinds != term->checkpoint_kinds())
      throw older(system.comm(), path, it->first);
}

namespace {

io::Checkpoint read_checked(const std::string& path, Simulation& simulation) {
  const LocalMesh& m = simulation.local();
  const MPI_Comm comm = simulation.system().comm();
  const std::vector<int> owned(m.global.begin(), m.global.begin() + m.owned);
  check_restart_file(comm, path, simulation.mesh(), owned);
  io::Checkpoint c = io::read_checkpoint(comm, path, simulation.mesh().nodes(), owned);
  const auto refuse = [&](const std::string& why) {
    return InputError(advice::cannot_continue(path, advice::other_case(why)));
  };
  std::map<std::string, double> in_checkpoint = c.scalars;
  std::erase_if(in_checkpoint,
                [](const auto& s) { return !s.first.starts_with("case.") && !s.first.starts_with(kKey); });
  if (!c.scalars.count(kKeys)) throw older(comm, path, "the case");
  if (!c.scalars.count(kResolvedUntil)) throw older(comm, path, "the impacts of its steps");
  if (const std::string other = difference(in_checkpoint, signature(simulation)); !other.empty()) {
    const std::string version = other_version(comm, path);
    throw refuse(version.empty() ? other : advice::other_or_version(other, path, version, kVersion));
  }
  if (const std::string wrong = first_text(comm, damage(c)); !wrong.empty())
    throw InputError(advice::cannot_continue(path, wrong));
  if (!c.nodes.count(kMeanQ)) throw older(comm, path, "the mean forces of cables");
  if (!record::has_audit(c)) throw older(comm, path, "the energy audit");
  if (!record::ClashReport::can_restore(c)) throw older(comm, path, "the clash report");
  check_records(c, simulation.system(), path);
  if (const std::string moved = first_text(comm, moved_end(c, simulation)); !moved.empty())
    throw refuse(moved);
  return c;
}

}  // namespace

io::Checkpoint read_restart(const std::string& path, Simulation& simulation) {
  try {
    return read_checked(path, simulation);
  } catch (const InputError& e) {
    const std::vector<std::string>& changes = simulation.model().changes;
    if (changes.empty()) throw;
    throw InputError(advice::changed_by_set(e.what(), changes));
  }
}

std::vector<std::string> compare_changes(MPI_Comm comm, const std::string& path,
                                         const std::vector<std::string>& changes) {
  std::vector<std::string> notes;
  on_root(comm, [&] {
    const io::h5::Id file = io::h5::open_read(path);
    if (!io::h5::exists(file, "set")) return;
    std::istringstream lines(io::h5::read_text(file, "set"));
    std::string in_checkpoint;
    for (std::string line; std::getline(lines, line);) in_checkpoint += " --set " + line;
    const std::string in_case =
        changes.empty() ? "" : fmt::format(" --set {}", fmt::join(changes, " --set "));
    if (in_checkpoint != in_case) notes.push_back(advice::other_changes(path, in_checkpoint, in_case));
  });
  return notes;
}

namespace {

// Values by block from those stored by node; zero at ghosts.
std::vector<double> restored_rows(const io::Checkpoint& c, const LocalMesh& m, const char* name) {
  std::vector<double> out(3 * static_cast<size_t>(m.blocks()), 0);
  const auto& r = c.nodes.at(name).values;
  for (size_t n = 0; n < static_cast<size_t>(m.owned); ++n)
    for (size_t k = 0; k < (m.rotates(static_cast<int>(n)) ? 6u : 3u); ++k)
      out[3 * static_cast<size_t>(m.block[n]) + k] = r[6 * n + k];
  return out;
}

Dynamics::RestartData restored_data(const io::Checkpoint& c, const Simulation& simulation, int rank) {
  Dynamics::RestartData data;
  // The case may request shorter steps than before.
  const StepSettings step = simulation.dynamics_settings().step;
  data.step_proposal = std::min(c.scalars.at("step.proposal"), step.fixed > 0 ? step.fixed : step.longest);
  data.step_wait = static_cast<int>(c.scalars.at("step.wait"));
  data.step_impact_period = c.scalars.at("step.impact period");
  data.step_resolved_until = c.scalars.at(kResolvedUntil);
  data.last_step = c.scalars.at("step.last");
  data.support_work = rank == 0 ? c.scalars.at("support_work") : 0;
  data.mean = {restored_rows(c, simulation.local(), kMeanQ), restored_rows(c, simulation.local(), kMeanF)};
  return data;
}

}  // namespace

void restore(const io::Checkpoint& c, Simulation& simulation) {
  const LocalMesh& m = simulation.local();
  const System& system = simulation.system();
  const AlphaState state = restored_state(c, m, system);
  for (const auto& term : system.terms())
    if (const auto it = c.records.find(std::string(term->checkpoint_key())); it != c.records.end())
      term->restore(it->second.records);
  const Dynamics::RestartData data = restored_data(c, simulation, rank_of(system.comm()));
  const std::vector<double> reactions = restored_rows(c, m, kReaction);
  simulation.dynamics().resume(state, reactions, data);
}

}  // namespace hawser::run
