// The class ContactVolumes: raises the automatic stiffness of a volume until lines penetrate no deeper than
// allowed. The penetration is computed in line_volume_automatic_stiffness.cpp. See docs/theory/contact.md,
// "Stiffness that follows the run".
#include <algorithm>
#include <cmath>

#include "hawser/base/mpi.hpp"
#include "hawser/terms/automatic_stiffness.hpp"
#include "hawser/terms/contact_volumes.hpp"

namespace hawser {
namespace {

// kAllowed: penetration, as a fraction of the radius, beyond which an automatic stiffness is raised; less
// than the 0.005 of the initial choice, so that a raise begins before that is reached. kMoving: factor on it
// in motion. kRaisedTo: fraction of the allowed penetration for which the new stiffness is computed.
constexpr double kAllowed = 0.004, kMoving = 2, kRaisedTo = 0.25;
// Penetration of an impact with all of its mass and speed, as a fraction of the radius.
constexpr double kImpactDepth = 0.5;
// In steps that resolve an impact the stiffness is raised only if the penetration exceeds kDeepInAnImpact
// times the allowed one and at least the fraction kPressed of the contact force is not due to inertia.
constexpr double kDeepInAnImpact = 10, kPressed = 0.99;
// In motion, the allowed penetration at the deepest point of a straight element (at an edge) is kDeepest
// times the allowed mean over the element. At rest the deepest point decides, because the tension of a line
// between fixed ends depends on it.
constexpr double kDeepest = 10;
// Largest factor on the stiffness per step for static loads; faster growth is due to an impact.
constexpr double kMostInAStep = 4;

// kWorthIt: smallest factor for which the stiffness is raised, because the solution must be repeated.
// kLeastInAStep: smallest limit of the factor in a step that resolves an impact.
constexpr double kWorthIt = 1.05, kLeastInAStep = 1.06;

}  // namespace

std::vector<double> ContactVolumes::stiffnesses() const {
  std::vector<double> all;
  for (const ContactVolume& v : volumes_) all.push_back(v.settings.normal_stiffness);
  return all;
}

bool ContactVolumes::any_automatic() const {
  return std::any_of(volumes_.begin(), volumes_.end(), [](const ContactVolume& v) { return v.automatic; });
}

// Statics restores the history of its start after it has raised the trial stiffness, which is not reduced.
void ContactVolumes::restore(std::vector<double> stiffness) {
  if (!any_automatic()) return;
  all_reduce(comm_, MPI_MAX, stiffness);
  for (size_t k = 0; k < volumes_.size(); ++k) {
    if (!volumes_[k].automatic || !(stiffness[k] > committed_[k])) continue;
    double& trial = volumes_[k].settings.normal_stiffness;
    trial = std::max(trial, stiffness[k]);
    committed_[k] = stiffness[k];
    reported_[k] = stiffness[k];  // by the run that raised it
  }
}

std::vector<advice::StiffnessRaise> ContactVolumes::take_raises() {
  std::vector<advice::StiffnessRaise> out;
  for (size_t k = 0; k < volumes_.size(); ++k)
    if (committed_[k] != reported_[k])
      out.push_back({volumes_[k].settings.name, reported_[k], committed_[k]});
  reported_ = committed_;
  return out;
}

void ContactVolumes::require(int volume, const NormalLaw& law, const PressedPoint& p, double step,
                             std::vector<double>& required) const {
  const size_t k = volume;
  const double now = volumes_[k].settings.normal_stiffness;
  const double given = volumes_[k].settings.allowed_penetration;
  const double allowed = given > 0 ? given : kAllowed * p.radius;
  if (p.held) return;
  double demand = 0;
  // Period with the stiffness at the start of the step.
  const double period = contact_period(law.stiffness * committed_[k] / now, p.mass);
  const bool in_impact = resolves_impact(step, period);
  const bool pressed = !in_impact || p.static_fraction > kPressed;
  const double times = in_impact ? kDeepInAnImpact : step > 0 ? kMoving : 1;
  const bool at_rest = step <= 0;
  const double depth = given > 0 || at_rest ? p.depth : std::max(p.mean_depth, times / kDeepest * p.depth);
  if (pressed && p.static_fraction * depth > times * allowed) {
    const double max_factor = in_impact ? std::max(1 + step / period, kLeastInAStep) : kMostInAStep;
    demand = now * p.static_fraction * depth / (kRaisedTo * allowed);
    if (step > 0) demand = std::min(demand, max_factor * committed_[k]);
  }
  // The penetration of an impact is u sqrt(m/k). A spring that is already loaded releases its energy only
  // within a part of its period; raising its stiffness would only load it further.
  const bool loaded = in_impact && p.depth > 0;
  if (step > 0 && !loaded)
    demand =
        std::max(demand, now * p.mass * std::pow(p.speed / (kImpactDepth * p.radius), 2) / law.stiffness);
  // A deeper penetration would end the run.
  if (p.depth > p.radius) demand = std::max(demand, now * std::pow(2 * p.depth / p.radius, 2));
  // The contact of an end is as short as it is deep, so that the criteria above would raise the stiffness
  // until an impact is far shorter than the line's own vibration.
  if (p.end_on && !(given > 0)) demand = std::min(demand, volumes_[k].max_stiffness_end_on);
  required[k] = std::max(required[k], demand);
}

bool ContactVolumes::raise(std::vector<double>& required) {
  if (!any_automatic()) return false;
  all_reduce(comm_, MPI_MAX, required);
  bool more = false;
  for (size_t k = 0; k < required.size(); ++k) {
    ContactVolume& v = volumes_[k];
    const double stiffness = std::min(required[k], v.max_stiffness);
    if (!v.automatic || !(stiffness > kWorthIt * v.settings.normal_stiffness)) continue;
    v.settings.normal_stiffness = stiffness;
    more = true;
  }
  return more;
}

bool ContactVolumes::revert_raise() {
  bool changed = false;
  for (size_t k = 0; k < volumes_.size(); ++k) {
    changed = changed || raised(static_cast<int>(k));
    volumes_[k].settings.normal_stiffness = committed_[k];
  }
  return changed;
}

bool ContactVolumes::has_back(int volume) const {
  return !dynamic_cast<const PlaneSurface*>(&surface(volume));
}

double ContactVolumes::depth_limit(int volume, double radius) const {
  if (!automatic(volume) && !has_back(volume)) return std::numeric_limits<double>::infinity();
  return settings(volume).depth_limit(radius, automatic(volume));
}

}  // namespace hawser
