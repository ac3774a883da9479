// Springs and dampers with full matrices: residual, exact derivatives, energy and powers.
#include "hawser/kernels/spring_matrices.hpp"

#include "hawser/kernels/platform_frame.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {

// The support has another velocity at the moved point: dv0 = W0 x dp, and H' dp are the first rows of G. The
// force on the support is opposite and acts at the same point, with the power
//   -(f . v0(x) + R m . W0),   (f, m) the force and the moment about the centre of mass x.
SpringMatrixForces spring_matrix_forces(const SpringMatrices& m, const RigidBodyState& s,
                                        const RigidPose& support) {
  if (m.none()) return {};
  const Mat3 H = support.rotation.toRotationMatrix();
  const PotentialGradient spring = platform_gradient({H, support.to_space(m.arm), m.stiffness}, m.arm, s);
  const PlatformMotion motion = platform_motion(H, m.arm, s);
  const Vec3 W = H.transpose() * support.angular_velocity;
  Vec6 rate = motion.rate;
  rate.head<3>() -= H.transpose() * support.velocity_at(s.x + s.q * m.arm);
  rate.tail<3>() -= W;
  Mat6 rate_by_place = motion.rate_by_place;
  rate_by_place.topRows<3>() -= hat(W) * motion.G.topRows<3>();
  const Vec6 damper = m.damping * rate;
  const Mat6 GtB = motion.G.transpose() * m.damping;
  SpringMatrixForces out;
  out.f = spring.f + motion.G.transpose() * damper;
  out.K = spring.K + GtB * rate_by_place + platform_force_slope(motion, m.arm, damper);
  out.C = GtB * motion.G;
  out.potential = spring.potential;
  out.dissipated = rate.dot(damper);
  out.supplied =
      -out.f.head<3>().dot(support.velocity_at(s.x)) - (s.q * out.f.tail<3>()).dot(support.angular_velocity);
  return out;
}

}  // namespace hawser
