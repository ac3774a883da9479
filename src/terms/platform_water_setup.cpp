// What the class PlatformWater is made of: groups of bodies by their files, stiffness and buoyancy of each.
#include <utility>

#include "hawser/kernels/table_places.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/platform_memory.hpp"
#include "hawser/terms/platform_water.hpp"

namespace hawser {
PlatformWater::PlatformWater(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh)
    : comm_(comm), mesh_(mesh), sea_(sea_of(c)) {
  for (const std::vector<int>& bodies : model::radiating_groups(c)) add_group(c, bodies);
  update_ghosts();
}

PlatformWater::Platform PlatformWater::platform(const model::Case& c, int body) const {
  const model::Body& b = c.bodies[body];
  const model::BodyMass& m = *b.mass;
  const model::BodyHydrodynamics& h = *m.hydrodynamics;
  const double heading = model::hydrodynamic_heading(b);
  Platform p;
  p.node = mesh_.mesh->body_node(body);
  p.arm = -m.centre;
  p.file_origin = -h.in_file;
  p.body = body;
  p.potential.axes = p.axes = exp_so3(heading * Vec3::UnitZ()).toRotationMatrix();
  p.follow = h.follow;
  p.slow = SlowPose::at({b.position.x(), b.position.y(), heading});
  p.potential.place = h.place ? *h.place : Vec3(b.position.x(), b.position.y(), sea_.surface + h.in_file.z());
  p.potential.stiffness = h.stiffness;
  // A hull has its own (terms/hulls.hpp).
  if (!m.hull) p.hydrostatics = model::hydrostatics(m, sea_.density, sea_.gravity);
  p.hydrostatics.level = p.potential.place.z();
  p.damping = h.damping + model::wave_drift_damping(h, sea_.waves.components());
  p.quadratic = h.quadratic_damping;
  const auto of_body = [&h](const std::vector<WaveForceTable>& tables) {
    return tables.empty() ? WaveForceTable() : tables[static_cast<size_t>(h.body) - 1];
  };
  if (h.excitation && !sea_.waves.none())
    p.waves = PlatformWaves(sea_.waves.components(), heading, of_body(h.data->excitation),
                            of_body(h.data->drift), h.data->difference, h.second_order);
  return p;
}

void PlatformWater::add_group(const model::Case& c, const std::vector<int>& bodies) {
  Group g;
  for (const int body : bodies) g.platforms.push_back(platform(c, body));
  g.data = c.bodies[bodies.front()].mass->hydrodynamics->data;
  model::PlatformMemory waves = model::platform_memory(c, bodies);
  g.rows = std::move(waves.rows);
  g.entries = std::move(waves.entries);
  g.memory = std::move(waves.memory);
  g.added_mass = g.data->infinite(g.rows, g.rows);
  groups_.push_back(std::move(g));
}

void PlatformWater::oscillate(double omega) {
  for (Group& g : groups_) {
    const model::HydrodynamicData& data = *g.data;
    if (!(omega > 0)) {
      g.added_mass = data.infinite(g.rows, g.rows);
      g.harmonic_damping.resize(0, 0);
      continue;
    }
    const auto [low, high, share] = frequency_place(data.omega, omega);
    const auto between = [&, low = low, high = high, share = share](const std::vector<Eigen::MatrixXd>& of) {
      return Eigen::MatrixXd((1 - share) * of[low](g.rows, g.rows) + share * of[high](g.rows, g.rows));
    };
    g.added_mass = between(data.added_mass);
    g.harmonic_damping = between(data.damping);
    if (omega < data.omega.front()) g.harmonic_damping *= omega / data.omega.front();
    if (omega > data.omega.back()) g.harmonic_damping.setZero();
    for (size_t i = 0; i < g.platforms.size(); ++i)
      g.harmonic_damping.block<6, 6>(6 * i, 6 * i) += g.platforms[i].damping;
  }
}

}  // namespace hawser
