// Rotations of motions, which are about space axes, of bodies with another heading.
#include <fmt/format.h>

#include <algorithm>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/math/so3.hpp"

namespace hawser::advice {

using namespace model;

namespace {

constexpr double kTurned = 0.17;  // rad, about ten degrees

// about: rotation vector of a motion [rad].
void warn_of_rotation(const Body& b, const Vec3& about, const char* motion, std::vector<InputWarning>& out) {
  const double size = about.norm();
  if (!(size > 0)) return;
  const Vec3 space = about / size;
  const Vec3 body_axes = exp_so3(b.rotation).conjugate() * space;
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
    if (const auto* h = std::get_if<HarmonicMotion>(&b.motion))
      warn_of_rotation(b, h->rotation_amplitude, "harmonic", out);
    const auto* t = std::get_if<TableMotion>(&b.motion);
    if (t && !t->of_waves && !t->rotation.empty())
      warn_of_rotation(b,
                       *std::max_element(t->rotation.begin(), t->rotation.end(),
                                         [](const Vec3& x, const Vec3& y) { return x.norm() < y.norm(); }),
                       "table", out);
  }
}

}  // namespace hawser::advice
