// The class LineVolumeContact: step limits due to present contacts and to elements that approach a volume,
// and detection of unresolved events at the end of a step: contact that ends too fast to be predicted, when a
// wave along the line separates an element that was at rest, and an element that a wave drives deeper than
// its initial speed.
#include <algorithm>
#include <array>

#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {
namespace {

constexpr std::array<double, 3> kSamples{0, 0.5, 1};  // positions along an element

Vec3 along(std::span<const Vec3> nodes, const LocalElement& e, double xi) {
  return (1 - xi) * nodes[static_cast<size_t>(e.first)] + xi * nodes[static_cast<size_t>(e.second)];
}

// Velocity relative to the body, m/s.
Vec3 velocity_at_start(const LineVolumePair& p, double xi) {
  return p.start.shape.velocity(xi) - p.start.pose.velocity_at(p.start.shape.point(xi));
}

// A beam bends locally under contact, so its whole mass does not move with the contact point.
bool straight(const AxisShape& shape) { return shape.count() < AxisShape::kMaxPositions; }

}  // namespace

void LineVolumeContact::limit_step(const Kinematics& committed, ImpactEvents& to) {
  for (Pair& pair : pairs_) {
    limit_by_active_contacts(pair, committed, to);
    limit_ahead(pair, committed, to);
  }
}

void LineVolumeContact::add_impact_at(const Pair& pair, const Kinematics& committed, double xi, double length,
                                      double gap, const Vec3& normal, bool last, ImpactEvents& to,
                                      double contact_length) const {
  const Quat back = pair.start.pose.rotation.conjugate();
  const Vec3 velocity = back * velocity_at_start(pair, xi);
  const Vec3 acceleration = back * along(committed.a, local(pair), xi);
  const ContactSpring s = spring(pair, xi, contact_length);
  // In contact the spring is damped by zeta; after it the line alone, by beta omega/2.
  const double of_line = 0.5 * settings(pair).damping_time / s.inverse_frequency;
  const Approach at{.gap = gap,
                    .closing = -normal.dot(velocity),
                    .acceleration = normal.dot(acceleration),
                    .last = last,
                    .damping = std::min(s.damping, of_line)};
  limit_depth(pair.radius, at, to);
  const double mass = settings(pair).mass_per_length * length * pair.length / contact_length;
  if (local(pair).counted && length > 0)
    to.add(impact_event(s.inverse_frequency, s.significant_depth, mass, at), element(pair).line);
}

void LineVolumeContact::limit_by_active_contacts(const Pair& pair, const Kinematics& committed,
                                                 ImpactEvents& to) const {
  // The deepest point of contact with a facet group stands for its whole length in contact; with contact at
  // nodes each node is separate.
  const bool at_nodes = finder_.at_nodes();
  const auto last = pair.start.points.end();
  for (auto first = pair.start.points.begin(), end = first; first != last; first = end) {
    end = std::find_if(first, last, [&](const AxisContactPoint& p) { return p.group != first->group; });
    const auto deepest =
        std::min_element(first, end, [](const auto& a, const auto& b) { return a.gap < b.gap; });
    double all = 0;
    for (auto p = first; p != end; ++p) all += p->weight;
    for (auto p = first; p != end; ++p)
      add_impact_at(pair, committed, p->xi, p == deepest && !at_nodes ? all : p->weight,
                    p->gap - pair.smoothing(), p->normal, p == deepest || at_nodes, to,
                    at_nodes || !straight(pair.start.shape) ? pair.length : all);
  }
}

void LineVolumeContact::predict_impacts(const Pair& pair, const Kinematics& committed, double xi,
                                        const SurfacePoint& p, ImpactEvents& to) const {
  const bool at_nodes = finder_.at_nodes();
  const bool touching = std::any_of(pair.start.points.begin(), pair.start.points.end(),
                                    [&](const AxisContactPoint& h) { return !at_nodes || h.xi == xi; });
  // Weights of Simpson's rule, or of the nodes. limit_by_active_contacts() treats points in contact.
  const double gap = p.distance - pair.contact_distance;
  const double part = at_nodes ? 0.5 : (xi == 0.5 ? 4.0 : 1.0) / 6;
  add_impact_at(pair, committed, xi, gap < 0 && touching ? 0 : part * pair.length, gap, p.normal, false, to,
                pair.length);
}

bool LineVolumeContact::predict_impacts_by_group(const Pair& pair, const Kinematics& committed,
                                                 ImpactEvents& to) const {
  const auto speed = [&](double xi) { return velocity_at_start(pair, xi).norm(); };
  FacetGroups facet_groups;
  finder_.facet_groups_ahead(
      pair, std::min(0.5, 2 * to.max_step) * std::max({speed(0), speed(0.5), speed(1)}), facet_groups);
  for (const FacetGroup& w : facet_groups.list)
    for (const double xi : kSamples) {
      if (!finder_.takes_part(pair, xi)) continue;
      const auto p =
          volumes_.surface(pair.volume)
              .query_group(w, pair.start.pose.to_body(pair.start.shape.point(xi)),
                           pair.contact_distance + 0.5 * (pair.start.shape.slope_bound() + speed(xi)));
      if (p) predict_impacts(pair, committed, xi, *p, to);
    }
  return facet_groups.several();
}

// Skips points known to be clear ahead, and points whose contact could not limit the step or be an impact.
void LineVolumeContact::limit_ahead(Pair& pair, const Kinematics& committed, ImpactEvents& to) const {
  const AxisShape& start = pair.start.shape;
  const Surface& surface = volumes_.surface(pair.volume);
  const double clearance = LineVolumeFinder::clearance_at_start(pair);
  const bool facet_groups = pair.start.several_groups && predict_impacts_by_group(pair, committed, to);
  const bool by_gap = finder_.by_gap();
  std::vector<ClearancePoint> free;
  for (size_t i = 0; i < kSamples.size(); ++i) {
    const double xi = kSamples[i];
    const double speed = velocity_at_start(pair, xi).norm();
    // The range of the query: half the upper bound of |dx/dxi|, and the distance covered in half a second.
    const double far = 0.5 * (start.slope_bound() + speed);
    const double within = pair.contact_distance + far;
    const ContactSpring s = spring(pair, xi, pair.length);
    const bool matters = may_limit_depth(pair.radius, clearance, speed, to) ||
                         may_impact(s.inverse_frequency, s.significant_depth, speed,
                                    along(committed.a, local(pair), xi).norm());
    if (clearance > far || !matters || !finder_.takes_part(pair, xi)) continue;
    const Vec3 y = pair.start.pose.to_body(start.point(xi));
    const auto p =
        by_gap ? finder_.query(pair, 0, xi, y, within) : surface.query(y, within, pair.cache.ahead[i]);
    if (const double away = p ? p->distance : within; away > pair.contact_distance)
      free.push_back({xi, away});
    if (!p) continue;
    pair.cache.ahead[i] = p->triangle;
    if (!facet_groups) predict_impacts(pair, committed, xi, *p, to);
  }
  if (by_gap || free.size() < kSamples.size()) return;
  double worst = 0;
  const auto free_radius = [&] {
    return least_distance(free, start.slope_bound(), start.bend_bound(), worst) - pair.contact_distance;
  };
  if (!(free_radius() > std::max(clearance, 0.0))) return;  // Surface::free_radius() only shortens distances
  for (size_t i = 0; i < free.size(); ++i)
    free[i].distance = surface.free_radius(pair.start.pose.to_body(start.point(free[i].xi)), free[i].distance,
                                           pair.cache.ahead[i]);
  pair.cache.clearance.offer(bezier_in(pair.start.pose, start), free_radius());
}

// Contact of a pair at the end of a converged step.
struct LineVolumeContact::EndOfStep {
  const Pair& pair;
  AxisShape shape;
  const RigidPose& pose;
  const ContactQuadrature& contact;
  double step = 0;  // s

  // Displacement of a point in the step, m, axes of the body.
  Vec3 displacement(double xi) const {
    return pose.to_body(shape.point(xi)) - pair.start.pose.to_body(pair.start.shape.point(xi));
  }
  int group_of(const QuadraturePoint& p) const { return contact.panels[p.panel].group; }
  // m, of the element in contact with a facet group.
  double contact_length(int group) const {
    double sum = 0;
    for (const QuadraturePoint& q : contact.quadrature)
      if (group_of(q) == group && pair.in_contact(q.surface)) sum += q.weight;
    return sum;
  }
};

// A place on an element that lost or gained contact within the step. Force and potential are those of the
// spring at the end of the step with contact; path and speed are along the normal.
struct LineVolumeContact::Crossing {
  double xi = 0;
  double weight = 0, contact_length = 0;  // m, of the place; of all places with this facet group
  double force = 0, potential = 0;        // N/m, J/m
  double path = 0, speed = 0;             // m, m/s
};

void LineVolumeContact::add_crossing(const EndOfStep& end, const Crossing& c, UnresolvedImpacts& to) const {
  const double length = finder_.at_nodes() || !straight(end.shape) ? end.pair.length : c.contact_length;
  const ContactSpring s = spring(end.pair, c.xi, length);
  const double error = c.weight * crossing_error(s.inverse_frequency, s.significant_depth, c.force,
                                                 c.potential, c.path, c.speed);
  if (error > 0) to.list.push_back({element(end.pair).line, -1, error});
}

// Adds the places that lost contact because an interval ended or became shorter.
void LineVolumeContact::add_lost_contacts(const EndOfStep& end, UnresolvedImpacts& to) const {
  const ContactQuadrature& contact = end.contact;
  for (int group = 0; group < end.pair.facet_groups(); ++group) {
    double contact_length = 0;
    for (const AxisContactPoint& p : end.pair.previous(group)) contact_length += p.weight;
    for (const AxisContactPoint& p : end.pair.previous(group)) {
      const auto contains_point = [&](const auto& s) { return s.from <= p.xi && p.xi <= s.to; };
      const auto is_contact = [&](const ContactPanel& s) { return s.group == group && contains_point(s); };
      if (std::any_of(contact.panels.begin(), contact.panels.end(), is_contact) &&
          std::none_of(contact.filled.begin(), contact.filled.end(), contains_point))
        continue;
      const Vec3 separation_velocity = end.shape.velocity(p.xi) - end.pose.velocity_at(end.shape.point(p.xi));
      add_crossing(
          end,
          {p.xi, p.weight, contact_length, p.elastic_force(), p.potential,
           p.normal.dot(end.displacement(p.xi)), (end.pose.rotation * p.normal).dot(separation_velocity)},
          to);
    }
  }
}

// Adds the places that gained contact by an approach.
void LineVolumeContact::add_new_contacts(const EndOfStep& end, UnresolvedImpacts& to) const {
  const Pair& pair = end.pair;
  for (const QuadraturePoint& p : end.contact.quadrature) {
    const auto& previous = pair.previous(end.group_of(p));
    const auto contains_point = [&](const AxisContactPoint& q) { return q.from <= p.xi && p.xi <= q.to; };
    if (!pair.in_contact(p.surface) || std::any_of(previous.begin(), previous.end(), contains_point))
      continue;
    // In axial sliding elements begin and end contact, but the length in contact does not change.
    const Vec3 along = (end.pose.rotation.conjugate() * end.shape.slope(p.xi)).normalized();
    const Vec3 displacement = end.displacement(p.xi);
    const Vec3 across =
        finder_.at_nodes() ? displacement : Vec3(displacement - along * along.dot(displacement));
    const double approach = -p.surface.normal.dot(across);
    if (!(approach > pair.contact_distance - p.surface.distance)) continue;
    const NormalForce f = normal_force(pair.law(p.xi).normal, p.surface.distance - pair.radius, 0);
    add_crossing(end,
                 {p.xi, p.weight, end.contact_length(end.group_of(p)), f.elastic, f.potential, approach,
                  approach / end.step},
                 to);
  }
}

bool LineVolumeContact::sinks_too_far(const EndOfStep& end) const {
  const double radius = end.pair.radius;
  for (int group = 0; group < end.pair.facet_groups(); ++group) {
    double deepest = 0;
    double deepest_before = 0;
    for (const QuadraturePoint& p : end.contact.quadrature)
      if (end.group_of(p) == group) deepest = std::max(deepest, radius - p.surface.distance);
    for (const AxisContactPoint& p : end.pair.previous(group))
      deepest_before = std::max(deepest_before, -p.gap);
    // Twice the depth that limit_depth() allows, so that an approach as predicted stays below it.
    if (deepest > std::max(deepest_before, 0.0) + radius) return true;
  }
  return false;
}

void LineVolumeContact::unresolved(const Kinematics& trial, UnresolvedImpacts& to) {
  volumes_.pose_trial(trial);
  for (Pair& pair : pairs_) {
    // Skips pairs without contact both at the start and in the last evaluation, unless the surface has
    // several facet groups: the contact may be with another one.
    if (!local(pair).counted ||
        (pair.start.points.empty() && !pair.start.several_groups && pair.trial.contact.panels.empty()))
      continue;
    const AxisShape shape(ends(trial, pair.element));
    const RigidPose& pose = volumes_.trial_pose(pair.volume);
    const EndOfStep end{pair, shape, pose, finder_.find(pair, shape, pose), trial.step};
    to.too_fast = to.too_fast || sinks_too_far(end);
    if (resolves_contact(spring(pair, 0, pair.length).inverse_frequency, trial.step) &&
        resolves_contact(spring(pair, 1, pair.length).inverse_frequency, trial.step))
      continue;
    add_lost_contacts(end, to);
    add_new_contacts(end, to);
  }
}

}  // namespace hawser
