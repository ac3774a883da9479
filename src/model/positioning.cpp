// Control loop of dynamic positioning: mass, periods and stability.
#include "hawser/model/positioning.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "hawser/math/freedoms.hpp"
#include "hawser/model/mass_matrix.hpp"

namespace hawser::model {
namespace {

// Largest real part of the roots sigma = s/c, c = 2 pi/filter period, of
//   m s² + (D s + P + I/s) c² (3 s + c)/(s + c)³ = 0
// times s (s + c)³; with d = D/(m c), p = P/(m c²), i = I/(m c³):
//   sigma⁶ + 3 sigma⁵ + 3 sigma⁴ + (1 + 3 d) sigma³ + (d + 3 p) sigma² + (p + 3 i) sigma + i
double largest_growth(double d, double p, double i) {
  const double polynomial[6] = {i, p + 3 * i, d + 3 * p, 1 + 3 * d, 3, 3};
  Eigen::Matrix<double, 6, 6> companion = Eigen::Matrix<double, 6, 6>::Zero();
  companion.diagonal(-1).setOnes();
  for (int k = 0; k < 6; ++k) companion(k, 5) = -polynomial[k];
  return companion.eigenvalues().real().maxCoeff();
}

}  // namespace

Vec3 positioned_mass(const Body& b) {
  const BodyMass& m = *b.mass;
  const Mat6 mass_about_origin = mass_matrix_about(m, Vec3::Zero());
  Vec3 mass;
  for (size_t k = 0; k < 3; ++k) mass[k] = mass_about_origin(kHorizontalFreedoms[k], kHorizontalFreedoms[k]);
  if (m.in_water) mass.head<2>() += m.in_water->added_mass.head<2>();
  if (!m.hydrodynamics || !m.hydrodynamics->data || m.hydrodynamics->data->added_mass.empty()) return mass;
  const Eigen::MatrixXd& A = m.hydrodynamics->data->added_mass.front();
  const Eigen::Index first = 6 * (static_cast<Eigen::Index>(m.hydrodynamics->body) - 1);
  for (size_t k = 0; k < 3; ++k) mass[k] += A(first + kHorizontalFreedoms[k], first + kHorizontalFreedoms[k]);
  return mass;
}

Vec3 loop_growth(const Body& b) {
  constexpr double kRounded = 1e-6;  // relative to c
  const DynamicPositioning& p = *b.mass->positioning;
  const double c = 2 * M_PI / p.filter;
  const Vec3 mass = positioned_mass(b);
  Vec3 out = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    const double m = mass[k] * c;
    const double growth =
        largest_growth(p.derivative[k] / m, p.proportional[k] / (m * c), p.integral[k] / (m * c * c));
    const bool controlled = p.proportional[k] > 0 || p.derivative[k] > 0;
    if (controlled && growth > kRounded) out[k] = c * growth;
  }
  return out;
}

std::string positioning_text(const Body& b) {
  const DynamicPositioning& p = *b.mass->positioning;
  const Vec3 mass = positioned_mass(b);
  std::string s = "    positioning:";
  for (int k = 0; k < 3; ++k) {
    if (!(p.proportional[k] > 0)) continue;
    const double omega = std::sqrt(p.proportional[k] / mass[k]);
    s += fmt::format(" {} with {:.4g} s and {:.2g} of critical damping,",
                     kFreedomNames[kHorizontalFreedoms[k]], 2 * M_PI / omega,
                     p.derivative[k] / (2 * omega * mass[k]));
  }
  s += fmt::format(" by motion slower than {:g} s", p.filter);
  if (std::isfinite(p.max_force.x())) s += fmt::format(", up to {:.4g} kN", p.max_force.x() / 1000);
  if (p.max_force.x() != p.max_force.y())
    s += fmt::format(" in surge and {:.4g} kN in sway", p.max_force.y() / 1000);
  if (std::isfinite(p.max_moment)) s += fmt::format(", up to {:.4g} kN m", p.max_moment / 1000);
  return s + "\n";
}

}  // namespace hawser::model
