// The class PlatformWater: forces on a body by component.
#include "hawser/math/heading.hpp"
#include "hawser/terms/platform_water.hpp"
#include "hawser/terms/rigid_bodies.hpp"

namespace hawser {

Vec6 PlatformWater::mean_force(const Platform& p, const RigidBodyState& s) {
  if (p.waves.none()) return Vec6::Zero();
  const double heading = heading_of(s.q).angle;
  const Mat3 J = heading_axes(heading);
  const Mat3& H = p.follow_period > 0 ? J : p.axes;
  const Vec6 F = p.follow_period > 0 ? p.waves.mean_drift(heading).force : p.waves.mean_drift();
  Vec6 out;
  out << H * F.head<3>(), J * F.tail<3>();
  return out;
}

double PlatformWater::mean_work(const Platform& p, const RigidBodyState& s) {
  if (p.waves.none()) return 0;
  const Vec6 mean = 0.5 * (mean_force(p, p.last_iterate) + mean_force(p, s));
  const Vec3 displacement = s.x + s.q * p.arm - p.last_iterate.x - p.last_iterate.q * p.arm;
  return mean.head<3>().dot(displacement) + mean.tail<3>().dot(log_so3(s.q * p.last_iterate.q.conjugate()));
}

std::vector<std::string> PlatformWater::load_components(int body) const {
  if (!on_body_[static_cast<size_t>(body)]) return {};
  return {"hydrostatic", "radiation", "added", "wave", "drift"};
}

// Radiation: added mass, with its reduction due to the step, and memory, or the damping of the files in
// harmonic motion. Added: the stiffness and damping matrices of the case.
std::vector<BodyForce> PlatformWater::forces_on(int body, const Kinematics& state) const {
  for (const Group& g : groups_) {
    if (!g.is_complete) continue;
    for (size_t i = 0; i < g.platforms.size(); ++i) {
      const Platform& p = g.platforms[i];
      if (p.body != body) continue;
      const auto first = 6 * static_cast<Eigen::Index>(i);
      const RigidBodyState s = floating_state(state, p.local);
      const PlatformMotion m = platform_motion_by_heading(p.axes, p.arm, s);
      const auto of_unknowns = [&s](const Vec6& f) { return BodyForce{-f.head<3>(), -(s.q * f.tail<3>())}; };
      const auto by_rate = [&](const Vec6& F) { return of_unknowns(m.G.transpose() * F); };
      const Vec6 hydrostatic = hydrostatic_gradient(p.hydrostatics, p.arm, s).f;
      const Vec6 by_stiffness = platform_gradient(p.potential, p.arm, s).f;
      if (!state.moves()) {
        const Vec6 mean = mean_force(p, s);
        const BodyForce drift{mean.head<3>(), mean.tail<3>() + (s.q * p.arm).cross(mean.head<3>())};
        return {of_unknowns(hydrostatic), {}, of_unknowns(by_stiffness), {}, drift};
      }
      const Eigen::VectorXd rate = rates(g, state);
      Eigen::VectorXd acceleration(rate.size());
      Eigen::VectorXd force;
      for (size_t j = 0; j < g.platforms.size(); ++j) {
        const Platform& other = g.platforms[j];
        acceleration.segment<6>(6 * static_cast<Eigen::Index>(j)) =
            platform_motion_by_heading(other.axes, other.arm, floating_state(state, other.local))
                .acceleration;
      }
      const KnownForces& now = known_forces(g, state.time);
      damping_and_memory(g, now, rate, force, nullptr);
      const Vec6 body_rate = rate.segment<6>(first);
      const Vec6 dampers = p.added_damping * body_rate +
                           p.added_quadratic_damping * body_rate.cwiseAbs().cwiseProduct(body_rate);
      const Eigen::MatrixXd mass = g.added_mass + period_mass(g, state.step);
      const Vec6 radiation = force.segment<6>(first) - dampers + (mass * acceleration).segment<6>(first);
      return {of_unknowns(hydrostatic), by_rate(radiation),
              of_unknowns(by_stiffness + m.G.transpose() * dampers),
              by_rate(-now.first_order.segment<6>(first)), by_rate(-now.second_order.segment<6>(first))};
    }
  }
  return {};
}

}  // namespace hawser
