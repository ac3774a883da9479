// Hydrostatics of a platform, groups of bodies that interact by radiation, and their radiation memory.
#include "hawser/model/platform.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "hawser/model/case.hpp"
#include "hawser/model/platform_memory.hpp"

namespace hawser::model {

namespace {

// Lever arms of buoyancy below this fraction of the cube root of the displaced volume are errors of the panel
// mesh.
constexpr double kMeshNoise = 1e-3;
// Entries of the damping matrix below this fraction of the diagonal entries count as zero.
constexpr double kNoEntry = 1e-6;

}  // namespace

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

PlatformHydrostatics hydrostatics(const BodyMass& m, double density, double gravity) {
  const BodyHydrodynamics& h = *m.hydrodynamics;
  const int first = 6 * (h.body - 1);
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

Vec3 restoring(const BodyMass& m, const PlatformHydrostatics& still, double gravity) {
  const double by_weight = m.mass * gravity * m.centre.z();
  return still.stiffness.diagonal() - Vec3(0, by_weight, by_weight);
}

std::vector<std::vector<int>> radiating_groups(const Case& c) {
  std::vector<std::vector<int>> groups;
  // Key: the files, and the number of earlier bodies with the same number in them.
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

PlatformMemory platform_memory(const Case& c, const std::vector<int>& bodies) {
  PlatformMemory out;
  for (const int body : bodies)
    for (int k = 0; k < 6; ++k) out.rows.push_back(6 * (c.bodies[body].mass->hydrodynamics->body - 1) + k);
  const HydrodynamicData& data = *c.bodies[bodies.front()].mass->hydrodynamics->data;
  const int n = static_cast<int>(out.rows.size());
  const auto most = [&](int i, int j) {
    double largest = 0;
    for (const Eigen::MatrixXd& B : data.damping)
      largest = std::max(largest, std::abs(B(out.rows[i], out.rows[j])));
    return largest;
  };
  for (int i = 0; i < n; ++i)
    for (int j = i; j < n; ++j)
      if (most(i, j) > kNoEntry * std::sqrt(most(i, i) * most(j, j))) out.entries.emplace_back(i, j);
  if (out.entries.empty()) return out;
  Eigen::MatrixXd damping(data.omega.size(), out.entries.size());
  for (Eigen::Index k = 0; k < damping.rows(); ++k)
    for (Eigen::Index e = 0; e < damping.cols(); ++e) {
      const auto [i, j] = out.entries[e];
      damping(k, e) = data.damping[k](out.rows[i], out.rows[j]);
    }
  out.memory = RadiationMemory(data.omega, damping);
  return out;
}

}  // namespace hawser::model
