// The class LinesInWater: construction from the case.
#include <algorithm>
#include <cmath>

#include "hawser/model/case.hpp"
#include "hawser/terms/lines_in_water.hpp"
#include "hawser/terms/soil_resistance.hpp"

namespace hawser {

WaterSection water_section(const model::Case& c, int type, double length) {
  const model::LineType& t = c.line_types[static_cast<size_t>(type)];
  const double rho = c.environment.water.density;
  const double d = t.displaced();
  const double A = M_PI / 4 * d * d;
  WaterSection s;
  s.length = length;
  s.radius = d / 2;
  s.buoyancy = rho * c.environment.gravity * A;
  s.displaced_mass = rho * A;
  s.added_normal = t.Ca_normal * rho * A;
  s.added_axial = t.Ca_axial * rho * A;
  s.drag_normal = 0.5 * rho * t.Cd_normal * t.dragged();
  s.drag_axial = 0.5 * rho * t.Cd_axial * M_PI * t.dragged();
  return s;
}

namespace {

std::vector<LinesInWater::WetElement> pieces_of(const LocalMesh& mesh, const model::Case& c) {
  std::vector<LinesInWater::WetElement> out;
  out.reserve(mesh.elements.size());
  for (const LocalElement& e : mesh.elements) {
    const Element& g = mesh.element(e);
    LinesInWater::WetElement& p = out.emplace_back();
    p.element = e;
    p.beam = g.beam;
    p.section = water_section(c, g.type, g.length);
    const double from = mesh.mesh->node(static_cast<size_t>(g.first)).arc;
    const double bare =
        1 - buried_length(c.lines[static_cast<size_t>(g.line)], from, from + g.length) / g.length;
    // In the soil a line has no drag and no added mass, only buoyancy.
    WaterSection& w = p.section;
    for (double* coefficient :
         {&w.drag_normal, &w.drag_axial, &w.added_normal, &w.added_axial, &w.displaced_mass})
      *coefficient *= bare;
  }
  return out;
}

bool in_soil(const model::Line& line, double arc) {
  return std::any_of(line.buried.begin(), line.buried.end(),
                     [arc](const model::Buried& b) { return b.from <= arc && arc <= b.to; });
}

std::vector<LinesInWater::Ball> balls_of(const LocalMesh& mesh, const model::Case& c) {
  std::vector<LinesInWater::Ball> out;
  const double rho = c.environment.water.density;
  for (size_t l = 0; l < c.lines.size(); ++l)
    for (const model::PointMass& m : c.lines[l].masses) {
      if (!(m.volume > 0 || m.drag_area > 0)) continue;
      const int node = mesh.find(mesh.mesh->nearest_node(static_cast<int>(l), m.at));
      if (node < 0 || node >= mesh.owned) continue;
      WaterBall b;
      b.buoyancy = rho * c.environment.gravity * m.volume;
      if (!in_soil(c.lines[l], m.at)) {
        b.displaced_mass = rho * m.volume;
        b.added_mass = m.Ca * rho * m.volume;
        b.drag = 0.5 * rho * m.drag_area;
      }
      // A minimum radius, because without a volume the drag still needs a range in which it begins.
      b.radius = std::max(std::cbrt(3 * m.volume / (4 * M_PI)), 0.05);
      out.push_back({node, b});
    }
  return out;
}

}  // namespace

LinesInWater::LinesInWater(const LocalMesh& mesh, const model::Case& c)
    : LinesInWater(mesh, sea_of(c), pieces_of(mesh, c), balls_of(mesh, c)) {
  for (const model::LineType& t : c.line_types) {
    // Coatings, floats and marine growth transmit the pressure of the sea to the wall below them.
    const double wall = t.wall_diameter > 0 ? t.wall_diameter : t.outer_diameter;
    walls_.push_back({M_PI / 4 * t.inner_diameter * t.inner_diameter, M_PI / 4 * wall * wall,
                      t.contents_density, t.contents_pressure});
  }
}

}  // namespace hawser
