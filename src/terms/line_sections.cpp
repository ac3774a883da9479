// Sections of beams and cables.
#include "hawser/terms/line_sections.hpp"

#include "hawser/model/case.hpp"

namespace hawser {

BeamSection beam_section(const Mesh& mesh, const model::Case& c, const Element& e) {
  const auto& t = c.line_types[e.type];
  const auto& stiffeners = c.lines[e.line].bend_stiffeners;
  const double from = arc_at(mesh, e, 0);
  const double to = arc_at(mesh, e, 1);
  BeamSection s;
  s.length = e.length;
  s.EA = t.EA;
  s.GJ = t.GJ;
  s.GA = t.GA;
  s.beta = t.stiffness_damping;
  s.EI2 = model::stiffened_EI(stiffeners, from, to, t.EI2);
  s.EI3 = model::stiffened_EI(stiffeners, from, to, t.EI3);
  s.tension = t.tension_table.get();
  s.moment = t.moment_table.get();
  s.plastic = t.plastic_bending.get();
  return s;
}

CableSection cable_section(const model::Case& c, const Element& e) {
  const auto& t = c.line_types[e.type];
  return {e.length, t.EA, t.stiffness_damping, t.tension_table.get(), e.free_strain};
}

}  // namespace hawser
