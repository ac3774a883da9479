// Rotations of motions, which are about space axes, of bodies with another heading.
#include <fmt/format.h>

#include <algorithm>
#include <complex>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/math/heading.hpp"
#include "hawser/model/farm.hpp"

namespace hawser::advice {

using namespace model;

namespace {

constexpr double kTurned = 0.17;  // rad, about ten degrees

// Heading by which the place of a body in a farm turns the axes of the platform's file [rad].
double heading_of_place(const Case& c, const Body& b) {
  const FarmPlace* place = find_placed(c, b.name).place;
  return place ? place->heading : 0;
}

// Amplitudes of rotation in axes that `heading` turns to those of the motion.
Vec3 amplitude_before(const HarmonicMotion& m, double heading) {
  if (heading == 0) return m.rotation_amplitude;
  Eigen::Vector3cd a;
  for (int k = 0; k < 3; ++k) a[k] = m.rotation_amplitude[k] * std::polar(1.0, m.rotation_phase[k]);
  return (heading_axes(-heading) * a).cwiseAbs();
}

// about: rotation vector of a motion [rad], and turned: rotation of the body, in axes of its file.
void warn_of_rotation(const Body& b, const Vec3& about, const Quat& turned, const char* motion,
                      std::vector<InputWarning>& out) {
  const double size = about.norm();
  if (!(size > 0)) return;
  const Vec3 space = about / size;
  const Vec3 body_axes = turned.conjugate() * space;
  if ((body_axes - space).norm() < kTurned) return;
  const auto text = [](const Vec3& v) {
    const Vec3 r = ((100 * v).array().round() / 100 + 0.0).matrix();
    return fmt::format("({:g}, {:g}, {:g})", r.x(), r.y(), r.z());
  };
  add_warning(out, fmt::format("bodies.{}.motion.{}", b.name, motion), Effect::part,
              "turns the body about {} in space, and that is {} of its own axes by its "
              "'rotation_deg'; is it meant?",
              text(space), text(body_axes));
}

}  // namespace

void warn_of_rotations(const Case& c, std::vector<InputWarning>& out) {
  for (const Body& b : c.bodies) {
    const double heading = heading_of_place(c, b);
    const Quat turned = heading_rotation(-heading) * exp_so3(b.rotation);
    if (const auto* h = std::get_if<HarmonicMotion>(&b.motion))
      warn_of_rotation(b, amplitude_before(*h, heading), turned, "harmonic", out);
    const auto* t = std::get_if<TableMotion>(&b.motion);
    if (!t || t->of_waves || t->rotation.empty()) continue;
    const Vec3& largest = *std::max_element(t->rotation.begin(), t->rotation.end(),
                                            [](const Vec3& x, const Vec3& y) { return x.norm() < y.norm(); });
    warn_of_rotation(b, heading_rotation(-heading) * largest, turned, "table", out);
  }
}

}  // namespace hawser::advice
