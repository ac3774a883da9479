// By how much the automatic stiffness of a volume is raised, until lines are no deeper than they may be. How
// deep they are: line_volume_automatic_stiffness.cpp. See docs/theory/contact.md, "Stiffness that follows
// the run".
#include <algorithm>
#include <cmath>

#include "hawser/base/gather.hpp"
#include "hawser/terms/automatic_stiffness.hpp"
#include "hawser/terms/contact_volumes.hpp"

namespace hawser {
namespace {

// Of the radius, deeper than which an automatic stiffness is raised (below the 0.005 it is chosen for, so
// that a raise begins before that is reached); how often that in motion; to what of it.
constexpr double kAllowed = 0.004, kMoving = 2, kRaisedTo = 0.25;
// Of the radius: what an impact may take it in by, with all of its mass at all of its speed.
constexpr double kImpactDepth = 0.5;
// Of the period of the mass on its spring: shorter steps follow an impact, and what is deep in them is the
// impact's.
constexpr double kFollowing = 2;
// In such steps the stiffness is raised only where the line is kDeepInAnImpact times deeper than allowed and
// the part kPressed of the contact force at least is not due to inertia.
constexpr double kDeepInAnImpact = 10, kPressed = 0.99;
// In motion, of what is allowed in the mean over a straight element: what is allowed at its deepest point,
// over an edge. At rest the deepest point decides, since the tension of a line between fixed ends depends on
// it.
constexpr double kDeepest = 10;
// Most that what presses raises a stiffness in a step: what grows faster is an impact.
constexpr double kMostInAStep = 4;

// A raise is solved again with, and what it is for moves with it: less than this is left.
constexpr double kWorthIt = 1.05, kLeastInAStep = 1.06;

}  // namespace

std::vector<double> ContactVolumes::stiffnesses() const {
  std::vector<double> all;
  for (const ContactVolume& v : volumes_) all.push_back(v.settings.normal_stiffness);
  return all;
}

void ContactVolumes::raise_to(int volume, double stiffness) {
  if (!automatic(volume)) return;
  volumes_[volume].settings.normal_stiffness = committed_[volume] = std::max(stiffness, committed_[volume]);
}

void ContactVolumes::require(int volume, const NormalLaw& law, const PressedPoint& p, double step,
                             std::vector<double>& wanted) const {
  const size_t k = volume;
  const double now = volumes_[k].settings.normal_stiffness, given = volumes_[k].settings.allowed_penetration;
  const double allowed = given > 0 ? given : kAllowed * p.radius;
  if (p.held) return;
  double want = 0;
  // Of the stiffness that the step began with.
  const double period = contact_period(law.stiffness * committed_[k] / now, p.mass);
  const bool resolves_impact = step > 0 && p.mass > 0 && step < kFollowing * period;
  const bool pressed = !resolves_impact || p.static_share > kPressed;
  const double times = resolves_impact ? kDeepInAnImpact : step > 0 ? kMoving : 1;
  const bool at_rest = step <= 0;
  const double depth = given > 0 || at_rest ? p.depth : std::max(p.mean_depth, times / kDeepest * p.depth);
  if (pressed && p.static_share * depth > times * allowed) {
    const double most = resolves_impact ? std::max(1 + step / period, kLeastInAStep) : kMostInAStep;
    want = now * p.static_share * depth / (kRaisedTo * allowed);
    if (step > 0) want = std::min(want, most * committed_[k]);
  }
  // u sqrt(m/k) is how deep an impact goes. What is in the spring already comes out of it no faster than in a
  // part of the period: to raise the stiffness then would only load the spring.
  const bool loaded = resolves_impact && p.depth > 0;
  if (step > 0 && !loaded)
    want = std::max(want, now * p.mass * std::pow(p.speed / (kImpactDepth * p.radius), 2) / law.stiffness);
  // The run would end.
  if (p.depth > p.radius) want = std::max(want, now * std::pow(2 * p.depth / p.radius, 2));
  wanted[k] = std::max(wanted[k], want);
}

bool ContactVolumes::raise(std::vector<double>& wanted) {
  if (std::none_of(volumes_.begin(), volumes_.end(), [](const ContactVolume& v) { return v.automatic; }))
    return false;
  all_reduce(comm_, MPI_MAX, wanted);
  bool more = false;
  for (size_t k = 0; k < wanted.size(); ++k) {
    ContactVolume& v = volumes_[k];
    const double to = std::min(wanted[k], v.most);
    if (!v.automatic || !(to > kWorthIt * v.settings.normal_stiffness)) continue;
    v.settings.normal_stiffness = to;
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

double ContactVolumes::deepest(int volume, double radius) const {
  const ContactVolume& c = volumes_[volume];
  const model::Volume& v = c.settings;
  if (!c.automatic && !has_back(volume)) return HUGE_VAL;
  return v.force_table ? std::max(radius, v.force_table->rows().back().first) : radius;
}

}  // namespace hawser
