// Hydrostatics of a platform, and which bodies of a case radiate on each other.
#include "hawser/model/platform.hpp"

#include <cmath>
#include <map>

#include "hawser/model/case.hpp"

namespace hawser::model {

namespace {

// Arms of buoyancy below this share of the side of a cube of the displaced volume are those of a mesh.
constexpr double kMeshNoise = 1e-3;

}  // namespace

Hydrostatics hydrostatics(const BodyMass& m, double density, double gravity) {
  const BodyHydrodynamics& h = *m.hydrodynamics;
  const int first = 6 * (h.body - 1);
  Mat6 C = h.data->hydrostatic.block<6, 6>(first, first);
  if (h.gravity_in_stiffness) {
    const Vec3 moment = m.mass * gravity * m.centre;
    C(3, 3) += moment.z();
    C(4, 4) += moment.z();
    C(3, 5) -= moment.x();
    C(4, 5) -= moment.y();
  }
  Hydrostatics out;
  out.buoyancy = h.volume > 0 ? density * gravity * h.volume : m.mass * gravity;
  const double noise = kMeshNoise * std::cbrt(out.buoyancy / (density * gravity));
  const auto arm = [&](double x) { return std::abs(x) < noise ? 0 : x; };
  out.arm_x = arm(-C(3, 5) / out.buoyancy);
  out.arm_y = arm(-C(4, 5) / out.buoyancy);
  const Mat3 upright = C.block<3, 3>(2, 2);
  out.stiffness.block<3, 3>(2, 2) = 0.5 * (upright + upright.transpose());
  return out;
}

std::vector<std::vector<int>> radiating_groups(const Case& c) {
  std::vector<std::vector<int>> groups;
  // By files and how many bodies with the same number there went before.
  std::map<std::pair<const HydrodynamicData*, int>, size_t> group_of;
  std::map<std::pair<const HydrodynamicData*, int>, int> count;
  for (size_t b = 0; b < c.bodies.size(); ++b) {
    if (!c.bodies[b].mass || !c.bodies[b].mass->hydrodynamics) continue;
    const BodyHydrodynamics& h = *c.bodies[b].mass->hydrodynamics;
    const int before = count[{h.data.get(), h.body}]++;
    const auto [at, added] = group_of.try_emplace({h.data.get(), before}, groups.size());
    if (added) groups.emplace_back();
    groups[at->second].push_back(static_cast<int>(b));
  }
  return groups;
}

}  // namespace hawser::model
