// Hydrostatics of a platform, and groups of bodies that interact by radiation.
#include "hawser/model/platform.hpp"

#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "hawser/model/case.hpp"
#include "hawser/model/waterplane.hpp"

namespace hawser::model {

namespace {

// Lever arms of buoyancy below this fraction of the cube root of the displaced volume are errors of the panel
// mesh.
constexpr double kMeshNoise = 1e-3;

}  // namespace

const WaveForceTable* BodyHydrodynamics::wave_forces() const {
  return excitation && !data->excitation.empty() ? &data->excitation[static_cast<size_t>(body) - 1] : nullptr;
}

const char* BodyHydrodynamics::key() const {
  switch (format) {
    case Format::capytaine:
      return "capytaine";
    case Format::bemio:
      return "bemio";
    case Format::wamit:
      break;
  }
  return "wamit";
}

double displaced_volume(const BodyMass& m, double density) {
  const double given = m.hydrodynamics->volume;
  return given > 0 ? given : m.mass / density;
}

PlatformHydrostatics hydrostatics(const BodyMass& m, double density, double gravity) {
  const BodyHydrodynamics& h = *m.hydrodynamics;
  const Eigen::Index first = h.first_row();
  Mat6 C = h.data->hydrostatic.block<6, 6>(first, first);
  if (h.gravity_in_stiffness) {
    const auto body = static_cast<size_t>(h.body) - 1;
    const bool known = body < h.data->weight.size() && h.data->weight[body];
    const Vec3 moment = known ? *h.data->weight[body] : Vec3(m.mass * gravity * m.centre);
    C(3, 3) += moment.z();
    C(4, 4) += moment.z();
    C(3, 5) -= moment.x();
    C(4, 5) -= moment.y();
  }
  PlatformHydrostatics out;
  out.buoyancy = h.volume > 0 ? density * gravity * h.volume : m.mass * gravity;
  const double noise = kMeshNoise * std::cbrt(out.buoyancy / (density * gravity));
  const auto arm = [&](double x) { return std::abs(x) < noise ? 0 : x; };
  out.arm_x = arm(-C(3, 5) / out.buoyancy);
  out.arm_y = arm(-C(4, 5) / out.buoyancy);
  const Mat3 upright = C.block<3, 3>(2, 2);
  out.stiffness = 0.5 * (upright + upright.transpose());
  return out;
}

Mat3 restoring(const BodyMass& m, const PlatformHydrostatics& hydrostatics, double gravity) {
  const double by_weight = m.mass * gravity * m.centre.z();
  Mat3 C = hydrostatics.stiffness;
  C.diagonal() -= Vec3(0, by_weight, by_weight);
  return C;
}

Eigen::Vector2d metacentric_heights(const Mat3& C, double weight) {
  return about_waterplane_centre(C).diagonal().tail<2>() / weight;
}

std::vector<std::vector<int>> radiating_groups(const Case& c) {
  std::vector<std::vector<int>> groups;
  // Key: the file, its length scale, and the number of earlier bodies with the same number in it.
  std::map<std::tuple<std::string, double, int>, size_t> group_of;
  std::map<std::tuple<std::string, double, int>, int> count;
  for (size_t b = 0; b < c.bodies.size(); ++b) {
    if (!c.bodies[b].mass || !c.bodies[b].mass->hydrodynamics) continue;
    const BodyHydrodynamics& h = *c.bodies[b].mass->hydrodynamics;
    const int before = count[{h.data->radiation_file, h.length, h.body}]++;
    const auto [at, added] = group_of.try_emplace({h.data->radiation_file, h.length, before}, groups.size());
    if (added) groups.emplace_back();
    groups[at->second].push_back(static_cast<int>(b));
  }
  return groups;
}

}  // namespace hawser::model
