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

// Twice the depth that limit_depth() allows, so that an approach as predicted stays below it.
bool sinks_too_far(double radius, double before, double after) {
  return after > std::max(before, 0.0) + radius;
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
                                      double touching) const {
  const Quat back = pair.start.pose.rotation.conjugate();
  const Vec3 velocity = back * velocity_at_start(pair, xi);
  const Vec3 acceleration = back * along(committed.a, local(pair), xi);
  const Approach at{gap, -normal.dot(velocity), normal.dot(acceleration), last};
  limit_depth(pair.radius, at, to);
  const ContactSpring s = spring(pair, xi, touching);
  const double mass = settings(pair).mass_per_length * length * pair.length / touching;
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

// Adds the places that lost contact because an interval ended or became shorter, and those that gained it.
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
    const ContactQuadrature& contact = finder_.find(pair, shape, pose);
    for (int w = 0; w < pair.facet_groups(); ++w) {
      double deepest = 0, deepest_before = 0;
      for (const QuadraturePoint& p : contact.quadrature)
        if (contact.panels[p.panel].group == w) deepest = std::max(deepest, pair.radius - p.surface.distance);
      for (const AxisContactPoint& p : pair.previous(w)) deepest_before = std::max(deepest_before, -p.gap);
      to.too_fast = to.too_fast || sinks_too_far(pair.radius, deepest_before, deepest);
    }
    if (resolves_contact(spring(pair, 0, pair.length).inverse_frequency, trial.step) &&
        resolves_contact(spring(pair, 1, pair.length).inverse_frequency, trial.step))
      continue;

    const auto add = [&](double touching, double xi, double weight, double force, double potential,
                         double path, double speed) {
      const ContactSpring s =
          spring(pair, xi, finder_.at_nodes() || !straight(shape) ? pair.length : touching);
      const double error =
          weight * crossing_error(s.inverse_frequency, s.significant_depth, force, potential, path, speed);
      if (error > 0) to.list.push_back({element(pair).line, -1, error});
    };
    const auto moved = [&](double xi) -> Vec3 {
      return pose.to_body(shape.point(xi)) - pair.start.pose.to_body(pair.start.shape.point(xi));
    };
    // For the facet group in contact at the start or in the trial.
    for (int w = 0; w < pair.facet_groups(); ++w) {
      double touched = 0;
      for (const AxisContactPoint& p : pair.previous(w)) touched += p.weight;
      for (const AxisContactPoint& p : pair.previous(w)) {
        const auto holds = [&](const auto& s) { return s.from <= p.xi && p.xi <= s.to; };
        if (std::any_of(contact.panels.begin(), contact.panels.end(),
                        [&](const ContactPanel& s) { return s.group == w && holds(s); }) &&
            std::none_of(contact.filled.begin(), contact.filled.end(), holds))
          continue;
        const Vec3 x = shape.point(p.xi);
        const Vec3 leaves = shape.velocity(p.xi) - pose.velocity_at(x);
        add(touched, p.xi, p.weight, p.elastic_force(), p.potential, p.normal.dot(moved(p.xi)),
            (pose.rotation * p.normal).dot(leaves));
      }
    }
    for (const QuadraturePoint& p : contact.quadrature) {
      const auto& previous = pair.previous(contact.panels[p.panel].group);
      const auto holds = [&](const AxisContactPoint& q) { return q.from <= p.xi && p.xi <= q.to; };
      if (!pair.in_contact(p.surface) || std::any_of(previous.begin(), previous.end(), holds)) continue;
      // In axial sliding elements begin and end contact, but the length in contact does not change.
      const Vec3 along = (pose.rotation.conjugate() * shape.slope(p.xi)).normalized();
      const Vec3 all = moved(p.xi);
      const Vec3 displacement = finder_.at_nodes() ? all : Vec3(all - along * along.dot(all));
      const double came = -p.surface.normal.dot(displacement);
      if (!(came > pair.contact_distance - p.surface.distance)) continue;
      const NormalForce f = normal_force(pair.law(p.xi).normal, p.surface.distance - pair.radius, 0);
      double touches = 0;
      for (const QuadraturePoint& q : contact.quadrature)
        if (contact.panels[q.panel].group == contact.panels[p.panel].group && pair.in_contact(q.surface))
          touches += q.weight;
      add(touches, p.xi, p.weight, f.elastic, f.potential, came, came / trial.step);
    }
  }
}

}  // namespace hawser
