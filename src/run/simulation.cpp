// The class Simulation: creation of mesh, partition and force terms, and settings of the time integration.
#include "hawser/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "hawser/advice/contact_stiffness.hpp"
#include "hawser/advice/run.hpp"
#include "hawser/advice/statics.hpp"
#include "hawser/advice/supports.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/body_pairs.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/longest_step.hpp"
#include "hawser/model/switched.hpp"
#include "hawser/record/support_rollers.hpp"
#include "hawser/run/contact_stiffness.hpp"
#include "hawser/run/line_pairs.hpp"
#include "hawser/run/node_owners.hpp"
#include "hawser/solve/start_shape.hpp"
#include "hawser/terms/bed_contact.hpp"
#include "hawser/terms/bodies_in_flow.hpp"
#include "hawser/terms/bodies_in_water.hpp"
#include "hawser/terms/body_contact.hpp"
#include "hawser/terms/dynamic_positioning.hpp"
#include "hawser/terms/end_springs.hpp"
#include "hawser/terms/feeders.hpp"
#include "hawser/terms/hulls.hpp"
#include "hawser/terms/line_mass.hpp"
#include "hawser/terms/line_structure.hpp"
#include "hawser/terms/lines_in_water.hpp"
#include "hawser/terms/links.hpp"
#include "hawser/terms/platform_water.hpp"
#include "hawser/terms/point_loads.hpp"
#include "hawser/terms/rigid_bodies.hpp"
#include "hawser/terms/soil_resistance.hpp"

namespace hawser::run {
namespace {

// Radius and mass of the elements, and held nodes, for contact along elements.
std::vector<LineContactElement> contact_elements(const model::Case& c, const LocalMesh& mesh,
                                                 const std::vector<int>& held) {
  std::vector<bool> is_held(static_cast<size_t>(mesh.nodes()), false);
  for (const int n : held) is_held[n] = true;
  std::vector<LineContactElement> out;
  for (const LocalElement& e : mesh.elements) {
    const Element& g = mesh.element(e);
    const auto& type = c.line_types[g.type];
    LineContactElement& element = out.emplace_back();
    if (c.contact.takes_part(c.lines[g.line])) element.radius = 0.5 * type.contact_diameter;
    element.mass_per_length = type.mass_per_length;
    element.damping_time = g.beam ? type.stiffness_damping : 0;
    element.rolling = c.contact.rolling;
    element.held = {is_held[e.first], is_held[e.second]};
  }
  return out;
}

// Local nodes with prescribed position during the whole run.
std::vector<int> held_nodes(const model::Case& c, const LocalMesh& local, const Feeders* feeders,
                            const std::vector<TiedNode>& tied) {
  std::set<int> released;  // nodes of the mesh
  if (feeders) {
    const std::vector<int> fed = feeders->fed_nodes();
    released.insert(fed.begin(), fed.end());
  }
  for (const model::Event& e : c.events)
    if (e.action.kind == model::Action::Kind::release) {
      const LineSpan& span = local.mesh->lines[c.line_index(e.action.line)];
      released.insert(span.end_node(e.action.line_end));
    }
  std::vector<int> held;
  for (const TiedNode& s : tied)
    if (s.position_mask != 0 && !released.count(local.global[s.node])) held.push_back(s.node);
  return held;
}

}  // namespace

// Creates a force term owned by the system.
template <class Term, class... From>
Term* Simulation::add(From&&... from) {
  auto term = std::make_unique<Term>(std::forward<From>(from)...);
  Term* out = term.get();
  system_->add(std::move(term));
  return out;
}

Simulation::Simulation(MPI_Comm comm, model::Case c, std::vector<std::shared_ptr<const Surface>> surfaces,
                       std::vector<BodySkeleton> skeletons, const VolumeFacets& facets)
    : case_(std::move(c)),
      mesh_(std::make_unique<Mesh>(build_mesh(case_))),
      bodies_(std::make_shared<Bodies>(case_.bodies)) {
  distribute(comm);
  if (std::any_of(case_.lines.begin(), case_.lines.end(),
                  [](const auto& l) { return l.end_a.feed || l.end_b.feed; }))
    add<Feeders>(local(), case_);
  add_line_terms();
  StartShape start = start_shape(comm, case_, local(), *bodies_, surfaces);
  notes_ = std::move(start.notes);
  const Kinematics at = start.state.at_rest();
  bodies_->fix_placed_in_space(comm, case_, at);
  if (!case_.links.empty()) add<Links>(comm, case_, local(), bodies_, at);
  if (Feeders* fed = feeders()) {
    fed->clamp(start.ends);
    start.tied = fed->with_held(start.tied);
  }
  const std::vector<int> held = held_nodes(case_, local(), feeders(), start.tied);
  add_seabed(at, held);
  add_contact(at, held, surfaces);
  add_bodies(std::move(surfaces), std::move(skeletons), facets);
  if (auto between = make_line_pairs(comm, case_, local(), details_)) system_->add(std::move(between));

  state_ = std::move(start.state);
  any_laid_ = start.any_laid;
  laid_ = std::move(start.laid);
  system_->tie(std::move(start.tied), [b = bodies_](int body, double t) { return b->pose(body, t); });
}

// Distributes the mesh over the ranks.
void Simulation::distribute(MPI_Comm comm) {
  const int rank = rank_of(comm);
  const int size = ranks_of(comm);
  const NodeRanks owner = node_owners(comm, case_, *mesh_, *bodies_, size);
  cut_ = hawser::cut_elements(*mesh_, owner);
  if (size > 1 && owner.runs().size() == 1 && !uncut_lines(case_).empty())
    notes_.push_back(advice::one_rank_has_all());
  system_ = std::make_unique<System>(comm, local_mesh(*mesh_, owner, rank, size));
  bodies_->in_state(case_, local());
}

// Adds the terms of lines alone: stiffness and mass, loads and masses at nodes, end springs, water.
void Simulation::add_line_terms() {
  add<LineStructure>(local(), case_);
  add<LineMass>(local(), case_);
  bool loads = false, masses = false, springs = false;
  for (const auto& line : case_.lines) {
    loads |= !line.point_loads.empty();
    masses |= !line.masses.empty();
    springs |= line.end_a.rotational_stiffness > 0 || line.end_b.rotational_stiffness > 0;
  }
  if (loads) add<PointLoads>(local(), point_loads(case_, local()));
  if (masses) add<PointMasses>(local(), point_masses(case_, local()), case_.environment.gravity);
  if (springs) add<EndSprings>(local(), bodies_, end_springs(case_, local()));
  if (case_.environment.water.present) add<LinesInWater>(local(), case_);
}

void Simulation::add_seabed(const Kinematics& start, const std::vector<int>& held) {
  if (!case_.environment.seabed.present) return;
  add<BedContact>(local(), case_, held);
  if (std::any_of(case_.lines.begin(), case_.lines.end(), [](const auto& l) { return !l.buried.empty(); }))
    add<SoilResistance>(system_->comm(), local(), case_, start, held);
}

// Adds contact of lines with volumes, and warnings of their start contact. Throws InputError if lines start
// below their supports.
void Simulation::add_contact(const Kinematics& start, const std::vector<int>& held,
                             const std::vector<std::shared_ptr<const Surface>>& surfaces) {
  const MPI_Comm comm = system_->comm();
  volumes_ = volumes_of_lines(case_, surfaces);
  for (ContactVolume& volume : volumes_)
    if (volume.settings.basis == model::StiffnessBasis::automatic)
      choose_stiffness(case_, *mesh_, volume, notes_);
  bodies_->exchange_poses(comm, start);
  start_contact_ = start_contact(placed_lines(start), volumes_);
  notes_.insert(notes_.end(), start_contact_.notes.begin(), start_contact_.notes.end());
  if (!case_.supports.empty()) {
    std::vector<RigidPose> poses;
    for (int b = 0; b < bodies_->size(); ++b) poses.push_back(bodies_->pose(b, start));
    const auto wrong =
        advice::below_supports(case_, record::support_crossings(comm, case_, local(), start, poses), poses);
    if (wrong) throw WrongPlaces(case_.refusal(wrong->key, wrong->why));
  }
  if (volumes_.empty()) return;
  auto* contact = add<LineVolumeContact>(local(), bodies_, volumes_, contact_elements(case_, local(), held),
                                         comm, case_.contact.method);
  contact->exclude_ends(start_contact_.excluded_ends);
}

// Adds bodies with mass, the water around them, and contact between bodies.
void Simulation::add_bodies(std::vector<std::shared_ptr<const Surface>> surfaces,
                            std::vector<BodySkeleton> skeletons, const VolumeFacets& facets) {
  const auto any = [this](const auto& has) {
    return std::any_of(case_.bodies.begin(), case_.bodies.end(),
                       [&has](const model::Body& b) { return b.mass && has(*b.mass); });
  };
  support_.resize(case_.bodies.size());
  for (int n = 0; n < local().owned; ++n) {
    const int body = mesh_->node(local().global[n]).body;
    if (body >= 0) support_[static_cast<size_t>(body)] = static_rest(case_, body);
  }
  if (mesh_->line_nodes() < mesh_->nodes()) {
    add<RigidBodies>(case_, local(), bodies_);
    if (any([](const model::BodyMass& m) { return m.in_water || !m.members.empty(); }))
      add<BodiesInWater>(case_, local());
    if (any([](const model::BodyMass& m) { return m.hull.has_value(); })) add<Hulls>(case_, local(), facets);
    if (any([](const model::BodyMass& m) { return m.wind || m.current; })) add<BodiesInFlow>(case_, local());
    if (any([](const model::BodyMass& m) { return m.positioning.has_value(); }))
      add<DynamicPositioning>(case_, local());
    if (any([](const model::BodyMass& m) { return m.hydrodynamics.has_value(); }))
      add<PlatformWater>(case_, local());
  }
  if (model::body_pairs(case_).empty() || skeletons.size() != case_.volumes.size()) return;
  std::vector<BodyVolume> touching;
  for (size_t v = 0; v < case_.volumes.size(); ++v)
    touching.push_back({std::move(surfaces[v]), std::move(skeletons[v])});
  add<BodyContact>(system_->comm(), case_, local(), bodies_, std::move(touching));
}

std::optional<RigidPose> Simulation::body_pose(int body, const Kinematics& state) const {
  return record::body_pose(*bodies_, local(), body, state);
}

Feeders* Simulation::feeders() const { return system_->find<Feeders>(); }

record::Subject Simulation::subject(std::vector<std::shared_ptr<const Surface>> surfaces) {
  return {case_, *system_, *bodies_, std::move(surfaces), [this]() -> Dynamics& { return dynamics(); }};
}

std::vector<std::string> Simulation::tilting_warnings() const {
  std::vector<std::string> out;
  const auto* in_water = system_->find<BodiesInWater>();
  if (!in_water) return out;
  std::vector<double> cut(case_.bodies.size());
  for (const int b : in_water->in_surface(state_.at_rest())) cut[static_cast<size_t>(b)] = 1;
  all_reduce(system_->comm(), MPI_SUM, cut);
  for (size_t b = 0; b < cut.size(); ++b)
    if (cut[b] > 0 && case_.bodies[b].mass->spring_turning_stiffness().head<2>().minCoeff() == 0)
      out.push_back(advice::no_waterplane(case_.bodies[b].name));
  return out;
}

std::vector<std::string> Simulation::take_stiffness_raises(const std::string& when) {
  std::vector<std::string> out;
  for (AdaptsStiffness* t : system_->with<AdaptsStiffness>())
    for (const advice::StiffnessRaise& raise : t->take_raises())
      out.push_back(advice::raised_stiffness(raise, when));
  return out;
}

PlacedLines Simulation::placed_lines(const Kinematics& state) const {
  return {system_->comm(), case_, local(), *bodies_, feeders(), state};
}

void Simulation::check_inside() const {
  bodies_->exchange_poses(system_->comm(), state_.at_rest());
  const std::string wrong = still_inside(placed_lines(state_.at_rest()), volumes_, start_contact_);
  if (!wrong.empty()) throw InputError(case_.path + ": " + wrong);
}

std::string Simulation::inside(int volume, const Kinematics& state) const {
  ContactVolume v = volumes_[volume];
  v.off = false;
  std::vector<ExcludedEnds> excluded_ends;
  for (ExcludedEnds ends : start_contact_.excluded_ends)
    if (ends.volume == volume) {
      ends.volume = 0;
      excluded_ends.push_back(ends);
    }
  bodies_->exchange_poses(system_->comm(), state);
  return inside_text(placed_lines(state), v, excluded_ends);
}

void Simulation::enable_contact(const model::Action& action) {
  for (size_t v = 0; v < volumes_.size(); ++v)
    if (model::switches(action, volumes_[v].settings)) {
      volumes_[v].off = !action.enabled;
      line_volume_contact()->enable(static_cast<int>(v), action.enabled);
    }
}

std::string Simulation::inside(const model::Action& action, const Kinematics& state) const {
  for (size_t v = 0; v < volumes_.size(); ++v)
    if (action.enabled && model::switches(action, volumes_[v].settings))
      if (std::string where = inside(static_cast<int>(v), state); !where.empty()) return where;
  return "";
}

void Simulation::forget_lines_of_others() {
  if (rank_of(system_->comm()) == 0) return;
  // All lines determine the longest step.
  if (case_.dynamics.max_step == 0) case_.dynamics.max_step = model::longest_step(case_).length;
  std::vector<bool> kept(case_.lines.size(), false);
  for (int n = 0; n < local().element_ghosts_end; ++n)
    if (const int line = local().node(n).line; line < std::ssize(case_.lines)) kept[line] = true;
  for (const Inside& s : start_contact_.inside) kept[s.line] = true;
  if (const Feeders* fed = feeders())
    for (const Feeder& f : fed->all()) kept[f.line] = true;
  case_.forget_lines_and_bodies(kept);
}

DynamicsSettings Simulation::dynamics_settings() const {
  const model::Dynamics& d = case_.dynamics;
  DynamicsSettings s;
  s.rho_infinity = d.rho_infinity;
  s.tolerance = d.tolerance;
  s.step.fixed = d.step;
  s.step.resolve_impacts = d.resolve_impacts;
  s.step.longest = d.max_step > 0 ? d.max_step : model::longest_step(case_).length;
  s.step.first = s.step.longest / 10;
  // 1e-7 s, or a millionth of a fixed step that is longer than 0.1 s.
  s.step.shortest = d.min_step > 0 ? d.min_step : std::max(1e-7, 1e-6 * d.step);
  s.step.error_tolerance = d.error_tolerance;
  if (d.error_tolerance > 0) return s;
  // One percent of the diameter per step is far below the accuracy of a line's shape or tension in results.
  for (const auto& t : case_.line_types)
    s.step.error_tolerance = std::max(s.step.error_tolerance, 0.01 * t.outer_diameter);
  std::vector<double> diameters;
  for (const auto& t : case_.line_types) diameters.push_back(t.outer_diameter);
  const Runs<double> largest = largest_of_types(mesh(), diameters);
  for (size_t l = 0; l < largest.size(); ++l)
    s.error_weight.push_back(largest[l] > 0 ? s.step.error_tolerance / (0.01 * largest[l]) : 1);
  return s;
}

Dynamics& Simulation::dynamics() {
  if (!dynamics_) dynamics_ = std::make_unique<Dynamics>(*system_, dynamics_settings());
  return *dynamics_;
}

}  // namespace hawser::run
