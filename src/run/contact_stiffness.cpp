// Choice of the automatic stiffness of a volume from the lines of the case.
#include "hawser/run/contact_stiffness.hpp"

#include <algorithm>

#include "hawser/advice/contact_stiffness.hpp"
#include "hawser/terms/automatic_stiffness.hpp"

namespace hawser::run {

void choose_stiffness(const model::Case& c, const Mesh& mesh, ContactVolume& volume,
                      std::vector<std::string>& notes) {
  model::Volume& v = volume.settings;
  AutomaticStiffness best;
  double mass = 0, radius = 0, largest = 0, largest_end_on = 0;
  const auto weight_of = [&](int type) {  // N/m
    return c.line_types[type].mass_per_length * c.environment.gravity;
  };
  std::vector<double> line_weight(mesh.lines.size(), 0);
  for (int i = 0; i < mesh.elements(); ++i) {
    const Element e = mesh.element(i);
    line_weight[e.line] += e.length * weight_of(e.type);
  }
  for (const EvenPart& e : mesh.parts()) {
    const auto& t = c.line_types[e.shape->type];
    StiffnessDemand d;
    d.radius = 0.5 * t.contact_diameter;
    d.weight = weight_of(e.shape->type);
    d.line_weight = line_weight[e.line];
    d.EA = t.EA;
    d.EI = t.smallest_bending_stiffness();
    d.bend = bending_radius(v, d.radius);
    d.allowed_penetration = v.allowed_penetration;
    const AutomaticStiffness s = automatic_contact_stiffness(d);
    largest = std::max(largest, largest_stiffness(d));
    largest_end_on = std::max(largest_end_on, largest_stiffness_end_on(d.EA, d.radius));
    if (s.per_length > best.per_length) {
      best = s;
      mass = t.mass_per_length;
      radius = d.radius;
    }
  }
  v.basis = model::StiffnessBasis::per_length;
  v.normal_stiffness = best.per_length;
  // Damping needs a long ramp, since steps of an impact do not resolve its work; statics needs a short one at
  // edges.
  if (!v.smoothing && !(v.relative_damping > 0)) v.smoothing = 2e-5 * radius;
  volume.automatic = true;
  volume.max_stiffness = std::max(largest, best.per_length);
  volume.max_stiffness_end_on = std::max(largest_end_on, best.per_length);
  const double bounce = 0.5 * contact_period(best.per_length, mass);
  const double step = c.dynamics.step;
  const bool too_short = c.dynamics.enabled && step > 0 && bounce < 1.5 * step;
  notes.push_back(
      advice::chosen_stiffness(v.name, best.per_length, best.reason, too_short ? bounce : 0, step));
}

}  // namespace hawser::run
