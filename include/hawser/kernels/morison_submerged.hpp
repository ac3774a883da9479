// What water does to four elements of cables at once that are wholly wet: the forces and derivatives of
// cable_water_force and cable_water_tangent (line_water.hpp), where buoyancy is constant and what is
// linear along the element is integrated in closed form. One vector lane an element.
#pragma once

#include <array>

#include "hawser/kernels/line_water.hpp"
#include "hawser/math/wide3.hpp"

namespace hawser {

// Of four elements, as in WaterSection.
struct WaterSections4 {
  wide::Row length, radius, buoyancy, displaced_mass, added_normal, added_axial, drag_normal, drag_axial;
  void set(int lane, const WaterSection& s);
};

// Components x, y, z; first and second nodes.
struct CablesInWater4 {
  wide::Row x[2][3], v[2][3], a[2][3];
  wide::Row velocity[2][3], by_height[2][3], acceleration[2][3], surface[2];  // of the water
};

// Which of the elements lie so far below the surface that all of them is wet, as bits. The others are no
// matter of submerged_force() and submerged_tangent(), whose answers for an element do not depend on the
// rest.
unsigned submerged(const WaterSections4& s, const CablesInWater4& m);

// Residuals f by lane. moving: the water has a velocity, or accelerations; else those of it are not read.
void submerged_force(const WaterSections4& s, const CablesInWater4& m, bool moving, std::array<Vec6, 4>& f);
// And J = wK K + wC C + wM M by lane.
void submerged_tangent(const WaterSections4& s, const CablesInWater4& m, bool moving, double wK, double wC,
                       double wM, std::array<Vec6, 4>& f, std::array<Mat6, 4>& J);

}  // namespace hawser
