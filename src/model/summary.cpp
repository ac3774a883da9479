// Summary of a case for `hawser check`: motions, volumes with stiffness and friction, sea, and time steps.
// Lines are in line_summary.cpp.
#include "hawser/model/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "hawser/base/count_of.hpp"
#include "hawser/math/freedoms.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/model/longest_step.hpp"
#include "hawser/model/notes.hpp"
#include "hawser/model/platform_periods.hpp"
#include "hawser/model/positioning.hpp"
#include "hawser/model/wave_components.hpp"

namespace hawser::model {
namespace {

std::string point(const Vec3& x) { return fmt::format("({:g}, {:g}, {:g})", x.x(), x.y(), x.z()); }

std::string periods_on_matrix(const Body& b) {
  std::vector<std::string> parts;
  for (const PlatformMode& mode : modes_on_stiffness_matrix(b))
    parts.push_back(fmt::format("{} {}", kFreedomNames[static_cast<size_t>(mode.freedom)],
                                mode.period > 0 ? fmt::format("{:.4g} s", mode.period) : "none"));
  return fmt::format("    periods on its stiffness matrix alone: {}\n", fmt::join(parts, ", "));
}

std::string motion_text(const Case& c, const Body& b) {
  if (b.ride) return fmt::format("rides on line {} at {:g} m", b.ride->line, b.ride->at);
  std::string s = "stands still";
  if (b.mass) {
    const BodyMass& m = *b.mass;
    s = fmt::format(
        "moves by its mass of {:.6g} kg, {}{}", m.mass,
        m.hydrodynamics ? std::string("in the sea by its hydrodynamic coefficients")
        : m.hull        ? std::string("with the pressure of the water on its hull")
        : m.in_water    ? fmt::format("in water with a volume of {:g} m³", m.in_water->volume)
        : m.weight && c.environment.gravity > 0 ? "with its weight"
                                                : "without weight",
        m.spring_stiffness().isZero() && m.spring_turning_stiffness().isZero() ? "" : ", held by springs");
    if (b.motion.index() == 0) return s;
    s += " towards a place that ";
  }
  const std::string before = b.mass ? s : "";
  if (const auto* steady = std::get_if<ConstantMotion>(&b.motion)) {
    s = before + "moves";
    if (!steady->velocity.isZero()) s += " at " + point(steady->velocity) + " m/s";
    if (steady->rate != 0) {
      if (!steady->velocity.isZero()) s += " and";
      s += fmt::format(" turning at {:g} rad/s about {}", steady->rate, point(steady->axis));
    }
  } else if (const auto* h = std::get_if<HarmonicMotion>(&b.motion)) {
    s = before + fmt::format("moves harmonically, period {:g} s", h->period);
  } else if (const auto* t = std::get_if<TableMotion>(&b.motion)) {
    s = before + fmt::format("moves by a table of {} rows, {:g} to {:g} s{}", t->time.size(), t->time.front(),
                             t->time.back(),
                             t->between == BetweenRows::linear     ? ", straight lines between them"
                             : t->between == BetweenRows::monotone ? ", monotone between them"
                                                                   : "");
  }
  if (b.ramp > 0) s += fmt::format(", starting smoothly over {:g} s", b.ramp);
  if (b.drift) s += ", carried by a slow drift";
  return s;
}

std::string bends(std::size_t corners) {
  return corners == 0 ? "straight" : "with " + count_of(static_cast<long long>(corners), "bend");
}

struct ShapeText {
  std::string operator()(const PlaneShape& s) const {
    return fmt::format("plane through {} facing {}", point(s.point), point(s.normal));
  }
  std::string operator()(const BoxShape& s) const {
    return fmt::format("box of {:g} x {:g} x {:g} m about {}{}", s.size.x(), s.size.y(), s.size.z(),
                       point(s.centre), s.rotation.isZero(0) ? "" : ", turned");
  }
  std::string operator()(const SphereShape& s) const {
    return fmt::format("sphere of radius {:g} m about {}", s.radius, point(s.centre));
  }
  std::string operator()(const CylinderShape& s) const {
    return fmt::format("cylinder of radius {:g} m from {} to {}", s.radius, point(s.from), point(s.to));
  }
  std::string operator()(const CapsuleShape& s) const {
    return fmt::format("capsule of radius {:g} m from {} to {}", s.radius, point(s.from), point(s.to));
  }
  std::string operator()(const TorusShape& s) const {
    return fmt::format("torus of radius {:g} m, tube {:g} m, about {} with axis {}", s.radius, s.tube_radius,
                       point(s.centre), point(s.axis));
  }
  std::string operator()(const TubeShape& s) const {
    return fmt::format("tube of inner radius {:g} m, wall {:g} m, {}, from {} to {}", s.inner_radius,
                       s.wall_thickness, bends(s.path.size() - 2), point(s.path.front()),
                       point(s.path.back()));
  }
};

std::string table_text(const ContactForceTable& t) {
  return fmt::format("force by a table of {} rows up to {:g} m", t.rows().size() - 1, t.rows().back().first);
}

std::string stiffness_text(const Volume& v) {
  if (v.force_table) return table_text(*v.force_table);
  switch (v.basis) {
    case StiffnessBasis::automatic:
      return v.allowed_penetration > 0
                 ? fmt::format("stiffness automatic for {:g} m of penetration", v.allowed_penetration)
                 : "stiffness automatic";
    case StiffnessBasis::per_point:
      return fmt::format("stiffness {:g} N/m a point", v.normal_stiffness);
    case StiffnessBasis::per_length:
      return fmt::format("stiffness {:g} N/m²", v.normal_stiffness);
    case StiffnessBasis::per_area:
      return fmt::format("stiffness {:g} N/m³", v.normal_stiffness);
  }
  return {};
}

std::string form_text(const Volume& v) {
  return v.shape ? std::visit(ShapeText{}, *v.shape) : std::filesystem::path(v.mesh).filename().string();
}

std::string friction_text(const Friction& f) {
  if (f.axial == 0 && f.lateral == 0) return "no friction";
  std::string s = f.axial == f.lateral ? fmt::format("friction {:g}", f.axial)
                                       : fmt::format("friction {:g} along, {:g} across", f.axial, f.lateral);
  if (f.blend_speed > 0)
    s += f.axial_kinetic == f.lateral_kinetic
             ? fmt::format(" at rest, {:g} sliding", f.axial_kinetic)
             : fmt::format(" at rest, {:g} and {:g} sliding", f.axial_kinetic, f.lateral_kinetic);
  return s;
}

std::string fraction(int divisor) {
  switch (divisor) {
    case 1:
      return "";
    case 4:
      return "a fourth of ";
    case 10:
      return "a tenth of ";
    case 20:
      return "a twentieth of ";
    case 50:
      return "a fiftieth of ";
    case 60:
      return "a sixtieth of ";
    case 75:
      return "a seventy-fifth of ";
    case 100:
      return "a hundredth of ";
  }
  return fmt::format("1/{} of ", divisor);
}

std::string step_text(const Case& c) {
  const Dynamics& d = c.dynamics;
  if (d.step > 0) return fmt::format("steps of {:g} s", d.step);
  if (d.max_step > 0) return fmt::format("automatic steps of at most {:g} s", d.max_step);
  const LongestStep longest = longest_step(c);
  return fmt::format("automatic steps of at most {:.3g} s ({})", longest.length,
                     fraction(longest.divisor) + longest.subject);
}

std::string text_of(const WaveSystem& w) {
  switch (w.kind) {
    case WaveSystem::Kind::spectrum:
      return fmt::format("waves of Hs {:g} m, Tp {:g} s in {} components, seed {}", w.height, w.peak_period,
                         w.count, w.seed);
    case WaveSystem::Kind::regular:
      return fmt::format("a wave of {:g} m and {:g} s", w.rows.front().height, w.rows.front().period);
    case WaveSystem::Kind::table:
      return fmt::format("waves of a spectrum by {} rows in {} components, seed {}", w.spectrum.size(),
                         w.count, w.seed);
    case WaveSystem::Kind::stokes:
      return fmt::format("Stokes' wave of {:g} m and {:g} s{}", w.rows.front().height, w.rows.front().period,
                         w.current != 0 ? fmt::format(" on a current of {:g} m/s", w.current) : "");
    case WaveSystem::Kind::components:
      return fmt::format("{} waves", w.rows.size());
  }
  return "";
}

// 4 sqrt(m0), the root of the sum of squares of those of the wave systems.
double significant_height(const WaveField& waves) {
  double energy = 0;
  for (const WaveComponent& w : waves.components()) energy += 0.5 * w.amplitude * w.amplitude;
  return 4 * std::sqrt(energy);
}

void describe_sea(const Case& c, std::string& s) {
  const Water& w = c.environment.water;
  if (w.present) {
    s += fmt::format("water: {:g} kg/m³", w.density);
    if (w.depth > 0) s += fmt::format(", {:g} m deep", w.depth);
    if (!w.current.profile.empty())
      s += fmt::format(", current {:g} m/s at the surface{}", w.current.profile.front().speed,
                       w.current.exponent > 0         ? ", power law"
                       : w.current.profile.size() > 1 ? fmt::format(", {} rows", w.current.profile.size())
                                                      : "");
    if (const auto& rows = w.current.time_factor.rows(); !rows.empty())
      s += fmt::format(", times a factor by {} rows from {:g} to {:g} s", rows.size(), rows.front().first,
                       rows.back().first);
    std::vector<std::string> systems;
    for (const WaveSystem& system : w.waves.systems) systems.push_back(text_of(system));
    if (systems.size() > 1)
      s += fmt::format(", a sea of Hs {:.4g} m in {} systems: {}",
                       significant_height(wave_field(c.environment)), systems.size(),
                       fmt::join(systems, "; "));
    else if (!systems.empty())
      s += ", " + systems.front();
    s += "\n";
  }
  if (const Wind& wind = c.environment.wind; wind.present) {
    s += fmt::format("wind: {:g} m/s at {:g} m, goes to {:g} deg", wind.speed, wind.height,
                     wind.direction * 180 / M_PI);
    if (wind.gusts != GustSpectrum::none) {
      const double at_ten = wind.speed * std::pow(10 / wind.height, wind.exponent);
      double energy = 0;
      for (const Gust& g : gusts(wind.gusts, wind.speed, at_ten, wind.height, wind.components, wind.seed))
        energy += 0.5 * g.amplitude * g.amplitude;
      s += fmt::format(", gusts of {} components, seed {}, standard deviation {:.3g} m/s", wind.components,
                       wind.seed, std::sqrt(energy));
    }
    s += "\n";
  }
  const Seabed& b = c.environment.seabed;
  if (!b.present) return;
  if (b.surface)
    s += fmt::format("seabed: of {}, about {:g} m deep", b.file, b.depth);
  else
    s += fmt::format("seabed: at {:g} m", b.depth);
  if (b.slope > 0)
    s += fmt::format(", sloping {:g} deg towards {:g} deg", b.slope * 180 / M_PI, b.direction * 180 / M_PI);
  const bool by_length = b.basis == StiffnessBasis::per_length;
  s += fmt::format(", {}, {}\n",
                   b.force_table
                       ? fmt::format("{} per {}", table_text(*b.force_table), by_length ? "length" : "area")
                       : fmt::format("stiffness {:g} {}", b.normal_stiffness, by_length ? "N/m²" : "N/m³"),
                   friction_text(b.friction));
  if (b.suction > 0)
    s += fmt::format("  suction up to {:g} {} over {:g} m\n", b.suction, by_length ? "N/m" : "N/m²",
                     b.suction_length);
}

void describe_supports(const Case& c, std::string& s) {
  if (c.supports.empty()) return;
  s += fmt::format("supports: {}\n", c.supports.size());
  for (const SupportBox& b : c.supports) {
    if (is_repeated(c, b.name)) continue;
    const Volume& roller = c.volumes[b.first];
    s += fmt::format(
        "  {}: {} of radius {:g} m, {}, {}, {}; axis of line {} at {}, {:.3g} deg below the horizontal\n",
        b.name, fmt::join(b.rollers, ", "), std::get<CylinderShape>(*roller.shape).radius,
        b.body.empty() ? std::string("fixed in space") : "on " + b.body, stiffness_text(roller),
        friction_text(roller.friction), b.line, point(b.at),
        std::atan2(-b.along.z(), std::hypot(b.along.x(), b.along.y())) * 180 / M_PI + 0.0);
  }
}

void describe_links(const Case& c, std::string& s) {
  if (c.links.empty()) return;
  const auto end = [](const LinkEnd& e) {
    if (!e.line.empty()) return fmt::format("line {} at {:g} m", e.line, e.arc);
    return e.body.empty() ? "fixed at " + point(e.at) : fmt::format("body {} at {}", e.body, point(e.at));
  };
  s += fmt::format("links: {}\n", c.links.size());
  for (const Link& l : c.links) {
    if (is_repeated(c, l.name)) continue;
    const std::string spring = l.law.spring          ? "a spring by a table"
                               : l.law.stiffness > 0 ? fmt::format("stiffness {:g} N/m", l.law.stiffness)
                                                     : "no spring";
    const std::string damper = l.law.damper        ? "a damper by a table"
                               : l.law.damping > 0 ? fmt::format("damping {:g} N s/m", l.law.damping)
                                                   : "no damper";
    s += fmt::format("  {}: from {} to {}, {}, {}, rest length {}{}\n", l.name, end(l.end_a), end(l.end_b),
                     spring, damper,
                     l.rest_given ? fmt::format("{:g} m", l.law.rest_length) : "as at the start",
                     l.law.tension_only ? ", tension only" : "");
  }
}

}  // namespace

std::string summary(const Case& c) {
  std::string s;
  long long nodes = 0, elements = 0, unknowns = 0;
  for (const Line& l : c.lines) {
    const LineSize z = size_of(c, l);
    nodes += z.nodes;
    elements += z.elements;
    unknowns += z.unknowns;
  }
  s += fmt::format("lines: {} ({}, {}, {})\n", c.lines.size(), count_of(elements, "element"),
                   count_of(nodes, "node"), count_of(unknowns, "unknown"));
  s += farm_text(c);
  s += lines_text(c);
  if (!c.line_types.empty()) s += line_type_table(c);
  s += fmt::format("bodies: {}\n", c.bodies.size());
  for (const Body& b : c.bodies) {
    if (is_repeated(c, b.name) || is_place(c, b.name)) continue;
    s += fmt::format("  {}: at {}, {}\n", b.name, point(b.position), motion_text(c, b));
    if (b.mass && b.mass->hydrodynamics) s += platform_text(c, b);
    if (b.mass && !b.mass->stiffness_matrix.isZero()) s += periods_on_matrix(b);
    if (b.mass) s += flow_text(c, b);
    if (b.mass && b.mass->positioning) s += positioning_text(b);
  }
  describe_links(c, s);
  describe_supports(c, s);
  const auto rollers =
      std::count_if(c.volumes.begin(), c.volumes.end(), [](const Volume& v) { return v.roller; });
  s += fmt::format("volumes: {}{}\n", c.volumes.size(),
                   rollers > 0 ? fmt::format(", of which {} rollers of supports", rollers) : "");
  for (const Volume& v : c.volumes) {
    if (v.roller || is_repeated(c, v.name)) continue;
    s += fmt::format("  {}: {}, {}, {}, {}{}\n", v.name, form_text(v),
                     v.body.empty() ? std::string("fixed in space") : "on " + v.body, stiffness_text(v),
                     friction_text(v.friction),
                     v.active_box            ? ", active in a box"
                     : v.active_part.empty() ? std::string()
                                             : ", active: " + v.active_part);
  }
  describe_sea(c, s);
  s += fmt::format("gravity: {:g} m/s²\n", c.environment.gravity);
  s += fmt::format("run: {}", c.statics.enabled ? "statics" : "no statics");
  if (c.dynamics.enabled)
    s += fmt::format(", dynamics of {:g} s in {}, rho_infinity {:g}", c.dynamics.duration, step_text(c),
                     c.dynamics.rho_infinity);
  s += "\n";
  if (!c.stages.empty()) s += fmt::format("stages of statics: {}\n", fmt::join(c.stages, ", "));
  for (const Event& e : c.events)
    s += fmt::format("event: {} is {} {}\n", e.action.subject(), e.action.participle(), e.cause.text());
  s += fmt::format("results: {}{}\n", c.output.file, c.output.xdmf ? " and .xdmf" : "");
  for (const std::string& n : c.change_notes) s += "note: " + n + "\n";
  for (const std::string& n : grouped_notes(c.notes)) s += "note: " + n + "\n";
  return s;
}

}  // namespace hawser::model
