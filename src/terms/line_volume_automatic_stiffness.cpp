// The class LineVolumeContact: penetration of each element into volumes, and demands to raise the automatic
// stiffness (contact_volumes_automatic_stiffness.cpp). See docs/theory/contact.md, "Stiffness that follows
// the run".
#include <algorithm>
#include <cmath>

#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {
namespace {

// Fraction of a force that remains after subtraction of the inertia of `mass` with the acceleration [m/s²]
// away from the surface.
double left_by_inertia(double force, double mass, double acceleration) {
  return force > 0 ? std::clamp(1 - mass * acceleration / force, 0.0, 1.0) : 1;
}

// True if a penetrating mass is so slow that its m v² is at most a sixteenth of k d² of the spring. It is
// then pressed in statically and does not bounce.
bool resting(double stiffness, double depth, double mass, double speed) {
  return stiffness * std::pow(0.25 * depth, 2) >= mass * speed * speed;
}

}  // namespace

// Static fraction of the force [N] on the whole element, 0 to 1.
double LineVolumeContact::static_fraction(const Pair& pair, const Kinematics& state, double force,
                                          double depth, const Vec3& normal) const {
  if (!state.moves()) return 1;
  const size_t a = local(pair).first;
  const size_t b = local(pair).second;
  const Vec3 place = 0.5 * (state.x[a] + state.x[b]);
  const Vec3 velocity = 0.5 * (state.v[a] + state.v[b]) - volumes_.trial_pose(pair.volume).velocity_at(place);
  const double mass = settings(pair).mass_per_length;
  return resting(pair.laws[0].normal.stiffness, depth, mass, normal.dot(velocity))
             ? left_by_inertia(force, mass * pair.length, 0.5 * normal.dot(state.a[a] + state.a[b]))
             : 0;
}

bool LineVolumeContact::adapt_stiffness(const Kinematics& equilibrium) {
  volumes_.pose_trial(equilibrium);
  std::vector<double> required = volumes_.stiffnesses();
  for (Pair& pair : pairs_) {
    const bool touches = !pair.trial.contact.panels.empty() || pair.start.several_groups;
    if (!volumes_.automatic(pair.volume) || (!touches && !equilibrium.moves())) continue;
    const AxisShape shape(ends(equilibrium, pair.element));
    const RigidPose& pose = volumes_.trial_pose(pair.volume);
    PressedPoint at;
    at.radius = pair.radius;
    at.mass = settings(pair).mass_per_length;
    at.held = is_held(pair);
    for (const double xi : {0.0, 1.0})
      at.speed = std::max(at.speed, (shape.velocity(xi) - pose.velocity_at(shape.point(xi))).norm());
    if (touches) finder_.find(pair, shape, pose);
    for (int w = 0; w < pair.facet_groups(); ++w) {
      double force = 0, area = 0;  // N, m²: force and integral of the depth, of the whole facet group
      Vec3 normal = Vec3::Zero();
      at.depth = 0;
      for (const QuadraturePoint& point : pair.trial.contact.quadrature) {
        if (!touches || pair.trial.contact.panels[point.panel].group != w || !pair.in_contact(point.surface))
          continue;
        const double gap = point.surface.distance - pair.radius;
        force += point.weight * normal_force(pair.law(point.xi).normal, gap, 0).elastic;
        area += point.weight * std::max(-gap, 0.0);
        if (-gap > at.depth) {
          at.depth = -gap;
          normal = pose.rotation * point.surface.normal;
        }
      }
      const Vec3 chord = shape.point(1) - shape.point(0);
      at.end_on = 2 * std::pow(chord.dot(normal), 2) > chord.squaredNorm();
      // A beam bends locally under contact, so its deepest point counts.
      at.mean_depth = shape.count() == AxisShape::kMaxPositions ? at.depth : area / pair.length;
      at.static_fraction = touches ? static_fraction(pair, equilibrium, force, at.depth, normal) : 1;
      volumes_.require(pair.volume, pair.laws[0].normal, at, equilibrium.step, required);
    }
  }
  if (!volumes_.raise(required)) return false;
  renew_laws();
  return true;
}

bool LineVolumeContact::raise_stiffness_where_blocked(const Kinematics& trial) {
  constexpr double kStiffer = 4;
  std::vector<double> required = volumes_.stiffnesses();
  for (const Pair& pair : pairs_) {
    double& demand = required[pair.volume];
    const double stiffer = kStiffer * volumes_.settings(pair.volume).normal_stiffness;
    if (demand >= stiffer || !volumes_.automatic(pair.volume)) continue;
    const AxisShape shape(ends(trial, pair.element));
    if (is_pulled_in(pair, shape, volumes_.pose_of(pair.volume, trial))) demand = stiffer;
  }
  if (!volumes_.raise(required)) return false;
  renew_laws();
  return true;
}

void LineVolumeContact::revert_stiffness() {
  if (volumes_.revert_raise()) renew_laws();
}

}  // namespace hawser
