// Water forces on four fully wet cable elements at once: forces and derivatives of cable_water_force and
// cable_water_tangent (line_water.hpp), with constant buoyancy and closed-form integrals of quantities that
// are linear along the element. One vector lane per element.
#pragma once

#include <array>

#include "hawser/kernels/line_water.hpp"
#include "hawser/math/wide3.hpp"

namespace hawser {

// WaterSection of four elements.
struct WaterSections4 {
  wide::Lanes4 length, radius, buoyancy, displaced_mass, added_normal, added_axial, drag_normal, drag_axial;
  void set(int lane, const WaterSection& s);
};

// Components x, y, z; first and second nodes.
struct CablesInWater4 {
  wide::Lanes4 x[2][3], v[2][3], a[2][3];
  wide::Lanes4 velocity[2][3], by_height[2][3], acceleration[2][3], surface[2];  // of the water
};

// Elements that are fully wet, as bits. submerged_force() and submerged_tangent() are valid only for these;
// their results for an element do not depend on the other lanes.
unsigned submerged(const WaterSections4& s, const CablesInWater4& m);

// Residuals f by lane. moving: the water has velocities or accelerations; else these are not read.
void submerged_force(const WaterSections4& s, const CablesInWater4& m, bool moving, std::array<Vec6, 4>& f);
// Also J = wK K + wC C + wM M by lane.
void submerged_tangent(const WaterSections4& s, const CablesInWater4& m, bool moving, double wK, double wC,
                       double wM, std::array<Vec6, 4>& f, std::array<Mat6, 4>& J);

}  // namespace hawser
