// Checks of platforms for other conventions or units and missing bodies.
#include <algorithm>
#include <cmath>

#include "hawser/math/freedoms.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/check_drift.hpp"
#include "hawser/model/check_freedoms.hpp"
#include "hawser/model/check_long_waves.hpp"

namespace hawser::model {
namespace {

void check_symmetric(const Mat6& K, const char* key, const Issues& issue) {
  constexpr double kRounded = 1e-6;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < i; ++j)
      if (std::abs(K(i, j) - K(j, i)) > kRounded * K.cwiseAbs().maxCoeff())
        issue(key, "is not symmetric: row {} has {:g} in column {}, and row {} has {:g} in column {}", i + 1,
              K(i, j), j + 1, j + 1, K(j, i), i + 1);
}

void check_dissipates(const Mat6& B, const char* key, const Issues& issue) {
  for (int i = 0; i < 6; ++i)
    if (B(i, i) < 0)
      issue(key, "row {} has {:g} on the diagonal: damping must not be negative", i + 1, B(i, i));
}

// Checks the input required for buoyancy. twice: message for a body with 'in_water', whose buoyancy would be
// counted twice.
void check_afloat(const Case& c, const BodyMass& m, const char* twice, const Issues& issue) {
  if (!c.environment.water.present) issue("", "there is no water: give 'environment: {{water: ...}}'");
  if (!(c.environment.gravity > 0))
    issue("", "needs gravity for its buoyancy, and 'environment.gravity' is 0; it must be above 0");
  if (m.in_water) issue("", "{}", twice);
  if (!m.weight)
    issue("",
          "includes the weight and buoyancy of the body, so that the weight always acts: remove 'weight'");
}

// The body must have wave forces.
void check_wave_forces(const Case& c, const Body& b, const Issues& issue) {
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  if (const auto missing = missing_freedom(c, b); missing && missing->is_refused())
    issue(h.key(), "{}", text_of(*missing, h));
  else
    check_long_waves(c, b, issue);
}

void check_platform(const Case& c, const Body& b, const Issues& issue) {
  const BodyMass& m = *b.mass;
  const BodyHydrodynamics& h = *m.hydrodynamics;
  check_afloat(c, m, "replaces 'in_water': give one of the two", issue);
  if (m.hull && m.hull->wave_pressure && h.wave_forces())
    issue("excitation",
          "the wave forces of the files contain the pressure of the waves, which 'hull' adds again: set "
          "'wave_pressure: false' there, or 'excitation: false'");
  if (h.excitation && c.environment.water.present && !c.environment.water.waves.none() &&
      h.data->excitation.empty())
    issue(h.key(), "the case has waves, but {} has no wave forces: add them, or set 'excitation: false'",
          h.data->excitation_file);
  const double C33 = hydrostatics(m, c.environment.water.density, c.environment.gravity).stiffness(0, 0);
  if (C33 < 0 && !m.hull)
    issue(h.key(),
          "the hydrostatic stiffness C33 of heave is {:.4g} N/m, and it is rho g times the area of the "
          "waterplane, so that it cannot be negative: does the file have the other sign?",
          C33);
  if (h.wave_forces()) check_wave_forces(c, b, issue);
  if (const DriftSize size = drift_size(c, b); size.is_refused()) issue(h.key(), "{}", text_of(size, h));
  check_symmetric(h.stiffness, "stiffness", issue);
  check_dissipates(h.damping, "damping", issue);
  check_dissipates(h.quadratic_damping, "quadratic_damping", issue);
}

void check_hull(const Case& c, const Body& b, const Issues& issue) {
  const BodyMass& m = *b.mass;
  check_afloat(
      c, m, "'in_water' includes buoyancy as well: give one of the two, and drag and added mass by 'members'",
      issue);
  for (const std::string& name : m.hull->volumes) {
    const auto has_name = [&name](const Volume& v) { return v.name == name; };
    const auto volume = std::find_if(c.volumes.begin(), c.volumes.end(), has_name);
    if (volume == c.volumes.end()) continue;  // reported elsewhere
    if (volume->body != b.name)
      issue("volumes", "volume '{}' moves with {}, not with this body: set 'body: {}' there", name,
            volume->body.empty() ? "nothing" : "body '" + volume->body + "'", b.name);
    if (volume->is_plane())
      issue("volumes", "volume '{}' is a plane, which displaces no finite volume", name);
    if (std::count(m.hull->volumes.begin(), m.hull->volumes.end(), name) > 1)
      issue("volumes", "names volume '{}' twice", name);
  }
}

void check_members(const Case& c, const Body& b, const Issues& issue) {
  if (!c.environment.water.present) issue("members", "there is no water: give 'environment: {{water: ...}}'");
  for (size_t i = 0; i < b.mass->members.size(); ++i)
    if (const BodyMember& m = b.mass->members[i]; m.from == m.to)
      issue(fmt::format("members[{}].to", i), "is the same point as 'from': a member has a length");
}

void check_flow(const Case& c, const Body& b, const Issues& issue) {
  if (b.mass->wind && !c.environment.wind.present)
    issue("wind", "there is no wind: give 'environment: {{wind: ...}}'");
  if (b.mass->current && !c.environment.water.present)
    issue("current", "there is no water: give 'environment: {{water: ...}}'");
}

void check_positioning(const BodyMass& m, const Issues& issue) {
  const DynamicPositioning& p = *m.positioning;
  for (int k = 0; k < 3; ++k)
    if (p.integral[k] > 0 && !(p.proportional[k] > 0))
      issue("integral",
            "has {:g} for {}, where 'proportional' has 0: an integral part alone is unstable, so give a "
            "proportional part",
            p.integral[k], kFreedomNames[kHorizontalFreedoms[k]]);
  if (p.proportional.isZero() && p.derivative.isZero())
    issue("", "needs 'proportional' or 'derivative' parts: without them the thrusters do nothing");
}

}  // namespace

void check_platforms(const Case& c, const Issues& issue) {
  for (const Body& b : c.bodies)
    if (b.mass && b.mass->positioning)
      check_positioning(*b.mass, issue.below("bodies." + b.name + ".floating.positioning"));
  for (const Body& b : c.bodies) {
    if (!b.mass) continue;
    const Issues of_body = issue.below("bodies." + b.name + ".floating");
    check_symmetric(b.mass->stiffness_matrix, "stiffness_matrix", of_body);
    check_dissipates(b.mass->damping_matrix, "damping_matrix", of_body);
    check_flow(c, b, of_body);
  }
  for (const Body& b : c.bodies)
    if (b.mass && b.mass->hydrodynamics)
      check_platform(c, b, issue.below("bodies." + b.name + ".floating.hydrodynamics"));
  for (const Body& b : c.bodies) {
    if (b.mass && b.mass->hull) check_hull(c, b, issue.below("bodies." + b.name + ".floating.hull"));
    if (b.mass && !b.mass->members.empty())
      check_members(c, b, issue.below("bodies." + b.name + ".floating"));
  }
  for (const std::vector<int>& group : radiating_groups(c)) {
    const Body& first = c.bodies[group.front()];
    const HydrodynamicData& data = *first.mass->hydrodynamics->data;
    if (static_cast<int>(group.size()) != data.bodies)
      issue("bodies." + first.name + ".floating.hydrodynamics." + first.mass->hydrodynamics->key(),
            "{} has {} bodies that radiate on each other, but {} of the case {} it: each needs an entry with "
            "its number as 'body' and the same 'length_scale'",
            data.radiation_file, data.bodies, group.size(), group.size() == 1 ? "uses" : "use");
  }
}

}  // namespace hawser::model
