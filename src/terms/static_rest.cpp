// Support of a floating body in statics: buoyancy and springs, lines and links, friction on other bodies.
#include "hawser/terms/static_rest.hpp"

#include <algorithm>

#include "hawser/model/body_pairs.hpp"
#include "hawser/model/check.hpp"

namespace hawser {
namespace {

bool in_lines_or_links(const model::Case& c, int body) {
  const std::string& name = c.bodies[body].name;
  return !model::line_ends_at(c, c.bodies[body]).empty() ||
         std::any_of(c.links.begin(), c.links.end(),
                     [&](const model::Link& l) { return l.end_a.body == name || l.end_b.body == name; }) ||
         (!c.lines.empty() && std::any_of(c.volumes.begin(), c.volumes.end(), [&](const model::Volume& v) {
           return v.body == name && c.contact.takes_part(v);
         }));
}

// True if buoyancy and springs alone support the body at rest.
bool floats_at_rest(const model::Case& c, const model::BodyMass& m) {
  if (!m.in_water && !m.hull) return false;
  const model::Water& w = c.environment.water;
  const Vec3 springs = m.spring_stiffness();
  const double neutral = m.mass * (1 - 1e-9);  // kg, up to round-off of the volume
  const bool carried = m.hull || springs.z() > 0 || w.density * m.in_water->volume >= neutral;
  const bool flows = !w.current.profile.empty() && !(w.current.ramp > 0);
  return carried && (!flows || springs.head<2>().minCoeff() > 0);
}

// True if springs support the body at rest: under its weight, and in water, wind, current and contact, whose
// forces turn it, too.
bool rests_on_springs(const model::BodyMass& m, model::ContactOfBody contact) {
  const Vec3 springs = m.spring_stiffness();
  const bool in_flow = m.wind || m.current || m.in_water || m.hull || !m.members.empty();
  const bool against_turning = !m.stiffness_matrix.isZero() || m.turning_stiffness.minCoeff() > 0;
  const bool pushed = in_flow || contact != model::ContactOfBody::none;
  return against_turning && (!m.weight || springs.z() > 0) && (!pushed || springs.head<2>().minCoeff() > 0);
}

}  // namespace

StaticRest static_rest(const model::Case& c, int body) {
  const model::BodyMass& m = *c.bodies[body].mass;
  const bool held_in_flow = (m.wind || m.current) && m.spring_stiffness().head<2>().minCoeff() > 0;
  const bool positioned = m.positioning && m.positioning->proportional.head<2>().minCoeff() > 0;
  const model::ContactOfBody contact = model::contact_of_body(c, c.bodies[body].name);
  StaticRest out;
  out.supported = m.hydrodynamics || held_in_flow || positioned || in_lines_or_links(c, body) ||
                  floats_at_rest(c, m) || rests_on_springs(m, contact);
  out.loaded = !m.loads.empty();
  out.by_friction = contact == model::ContactOfBody::with_friction;
  return out;
}

}  // namespace hawser
