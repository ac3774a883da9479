// The class Simulation: static equilibrium, its friction and restraints, and its report.
#include <algorithm>
#include <utility>

#include "hawser/advice/statics.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/model/body_pairs.hpp"
#include "hawser/run/bodies_in_contact.hpp"
#include "hawser/run/line_pairs.hpp"
#include "hawser/run/simulation.hpp"
#include "hawser/terms/bed_contact.hpp"
#include "hawser/terms/line_structure.hpp"
#include "hawser/terms/static_rest.hpp"

namespace hawser::run {
namespace {

// First mobilisation length of bed friction in statics, about a line's radius [m]. Statics continues from
// this soft friction to stiffer ones: Newton's method fails if it starts with the stiff law, which has no
// stiffness beyond the mobilisation length.
constexpr double kFirstSlip = 0.1;

// Largest number of steps of relaxation without friction if the search with friction, which takes about as
// many, can follow.
constexpr int kMostStepsBeforeFriction = 150;

RelaxationUse relaxation_use(model::Relaxation given, StartsFrom from) {
  if (given == model::Relaxation::always) return RelaxationUse::always;
  if (given == model::Relaxation::never) return RelaxationUse::never;
  return from == StartsFrom::release ? RelaxationUse::first : RelaxationUse::when_newton_fails;
}

StaticsSettings settings_of(const model::Case& c, StartsFrom from) {
  StaticsSettings settings;
  settings.tolerance = c.statics.tolerance;
  settings.max_iterations = c.statics.max_iterations;
  settings.relaxation = relaxation_use(c.statics.relaxation, from);
  settings.relaxation_steps = c.statics.relaxation_steps;
  return settings;
}

}  // namespace

// By the case, because a rank without nodes has no friction and statics is collective.
bool Simulation::lays_lines() const {
  return system_->find<BedContact>() && friction_in_statics_.value_or(true) && any_laid_;
}

// Continues from the equilibrium with soft friction, under the weight of lines that lay at the start, through
// stiffer friction to the law of dynamics; with `full` mobilisation under the contact forces found.
void Simulation::solve_with_contact_friction(StaticsSettings settings, StaticsReport& report) {
  settings.starts_near = true;
  BedContact& bed = *system_->find<BedContact>();
  const auto solve = [&] {
    const StaticsReport more = find_equilibrium(*system_, settings, state_);
    report.iterations += more.iterations;
    report.relaxation_steps += more.relaxation_steps;
    report.escapes += more.escapes;
    report.norms = more.norms;  // the inertia of friction's unsymmetric tangent has no meaning
  };
  for (const double slip : {kFirstSlip / 30, 0.0}) {
    bed.mobilise_at(slip);
    if (case_.environment.seabed.full) bed.press_by_contact(state_.at_rest());
    solve();
  }
  bed.use_contact_friction(state_.at_rest());
  solve();
}

StaticsReport Simulation::solve_statics(std::function<void(const StaticsReport&)> progress, StartsFrom from) {
  StaticsSettings settings = settings_of(case_, from);
  settings.friction = contact_friction_in_statics();
  settings.progress = std::move(progress);
  const StaticsReport report = find_equilibrium_or_rest_by_friction(settings);
  if (line_volume_contact() || line_pairs()) system_->commit(state_.at_rest());
  check_inside();
  for (ChecksRest* t : system_->with<ChecksRest>()) t->check_at_rest(state_.at_rest());
  note_contact_at_rest();
  note_bodies_held_without_weight();
  note_slack_lines(report.relaxation_steps > 0);
  return report;
}

// Bodies that start in contact and that nothing else supports come to rest there. No result if one of them
// does not stay where it is, for example on a slope without friction; the state is then that of the start.
std::optional<StaticsReport> Simulation::rest_in_contact(StaticsSettings settings) {
  const std::vector<RestsOnBody> on = bodies_starting_in_contact(case_, support_, *system_, state_.at_rest());
  if (on.empty()) return std::nullopt;
  const StaticsStart start(*system_, state_);
  const std::vector<RigidPose> from = poses_of(*system_, *bodies_, state_.at_rest());
  resting_.assign(case_.bodies.size(), false);
  for (const RestsOnBody& r : on) resting_[static_cast<size_t>(r.body)] = true;
  friction_in_statics_ = true;
  settings.friction = true;
  try {
    StaticsReport report = find_restrained_equilibrium(settings);
    const std::vector<TouchingVolumes> touching = touching_volumes(*system_, state_.at_rest());
    if (have_stayed(case_, on, touching, from, poses_of(*system_, *bodies_, state_.at_rest()))) return report;
  } catch (const SolveError&) {
    // Without friction it may be possible.
  }
  resting_.clear();
  friction_in_statics_.reset();
  system_->revert_stiffness();
  start.restore(state_);
  return std::nullopt;
}

// Without friction a line may have no equilibrium, or none that can be found on the facets of a mesh.
// Friction that the case has then brings it to rest on the path from the start.
StaticsReport Simulation::find_equilibrium_or_rest_by_friction(StaticsSettings settings) {
  const bool may_rest = !friction_in_statics_ && !case_.statics.contact_friction.has_value() &&
                        case_.statics.relaxation != model::Relaxation::never;
  if (may_rest)
    if (const std::optional<StaticsReport> report = rest_in_contact(settings)) return *report;
  if (!may_rest || !case_.contact.has_friction(case_.volumes)) return find_restrained_equilibrium(settings);
  const StaticsStart start(*system_, state_);
  std::string failure;
  try {
    StaticsSettings without_friction = settings;
    without_friction.relaxation_steps = std::min(settings.relaxation_steps, kMostStepsBeforeFriction);
    return find_restrained_equilibrium(without_friction);
  } catch (const SolveError& no_equilibrium) {
    failure = no_equilibrium.what();
  }
  system_->revert_stiffness();
  start.restore(state_);
  enable_friction_in_statics(true);
  settings.friction = true;
  try {
    const StaticsReport report = find_restrained_equilibrium(settings);
    notes_.push_back(advice::rests_by_contact_friction());
    return report;
  } catch (const SolveError& with_friction) {
    throw SolveError(advice::second_failure(failure, with_friction.what()));
  }
}

bool Simulation::has_equilibrium(size_t body, const StaticRest& support) const {
  if (resting_.empty()) return support.is_computed(contact_friction_in_statics());
  return support.is_computed(false) || resting_[body];
}

// By body of the case, for those of this rank.
std::vector<bool> Simulation::bodies_with_equilibrium() const {
  std::vector<bool> out;
  for (size_t b = 0; b < support_.size(); ++b) out.push_back(has_equilibrium(b, support_[b]));
  return out;
}

StaticsReport Simulation::find_restrained_equilibrium(const StaticsSettings& settings) {
  enable_friction_at_rest();
  const std::vector<RestrainedInStatics*> restrained = system_->with<RestrainedInStatics>();
  const std::vector<Vec3> v = state_.v;  // floating bodies may have initial velocities
  const std::vector<Vec3> w = state_.w;
  const std::vector<bool> computed = bodies_with_equilibrium();
  for (RestrainedInStatics* t : restrained) t->begin_statics(computed);
  StaticsReport report = find_equilibrium(*system_, settings, state_);
  if (lays_lines()) solve_with_contact_friction(settings, report);
  for (HasFriction* t : system_->with<HasFriction>()) t->enable_friction(true);
  for (RestrainedInStatics* t : restrained) t->end_statics();
  if (restrained.empty()) return report;
  for (size_t n = 0; n < static_cast<size_t>(local().owned); ++n) {
    state_.v[n] = v[n];
    state_.w[n] = w[n];
  }
  system_->update_ghosts(state_);
  return report;
}

// Bed friction begins in the laid position.
void Simulation::enable_friction_at_rest() {
  BedContact* bed = system_->find<BedContact>();
  for (HasFriction* t : system_->with<HasFriction>())
    t->enable_friction(contact_friction_in_statics() && t != bed);
  if (!lays_lines()) return;
  bed->lay(laid_, state_.at_rest(), case_.environment.seabed.full);
  bed->mobilise_at(kFirstSlip);
}

void Simulation::note_contact_at_rest() {
  for (std::string& note : take_stiffness_raises("in statics")) notes_.push_back(std::move(note));
  if (!line_pairs()) return;
  std::string note = shared_places_note(line_pairs()->shared(), *mesh_);
  if (!note.empty()) notes_.push_back(std::move(note));
}

void Simulation::note_bodies_held_without_weight() {
  if (rank_of(system_->comm()) != 0) return;
  for (size_t b = 0; b < case_.bodies.size(); ++b) {
    const model::Body& body = case_.bodies[b];
    if (!body.mass || !body.mass->weight || body.mass->hull || body.mass->spring_stiffness().z() > 0)
      continue;
    const model::ContactOfBody contact = model::contact_of_body(case_, body.name);
    if (contact == model::ContactOfBody::none || has_equilibrium(b, static_rest(case_, static_cast<int>(b))))
      continue;
    notes_.push_back(advice::held_without_weight(body.name, contact == model::ContactOfBody::with_friction));
  }
}

void Simulation::note_slack_lines(bool relaxed) {
  std::vector<double> slack = system_->find<LineStructure>()->slack_length(state_.at_rest());
  all_reduce(system_->comm(), MPI_SUM, slack);
  if (rank_of(system_->comm()) != 0) return;
  for (size_t l = 0; l < slack.size(); ++l)
    if (slack[l] > 0 && !case_.lines[l].end_a.feed && !case_.lines[l].end_b.feed)
      notes_.push_back(advice::slack_at_rest(mesh_->line_names[l], slack[l], relaxed));
}

}  // namespace hawser::run
