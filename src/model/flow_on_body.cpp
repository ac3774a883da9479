// What `hawser check` says of wind and current on a body.
#include "hawser/model/flow_on_body.hpp"

#include <fmt/format.h>

#include "hawser/model/case.hpp"

namespace hawser::model {
namespace {

// The largest forces in a flow of this speed over all directions.
std::string line(const char* what, const FlowOnBody& f, double density, double speed, const std::string& of) {
  Vec3 most = Vec3::Zero();
  for (int k = 0; k < 360; ++k) {
    Vec3 C, slope;
    f.coefficients.at(k * M_PI / 180, C, slope);
    most = most.cwiseMax(C.cwiseAbs());
  }
  const double pressure = 0.5 * density * speed * speed;
  return fmt::format(
      "    {} by {} rows{}{}: at {:.4g} m/s{} it has at most {:.4g} kN along, {:.4g} kN across and {:.4g} kN "
      "m of "
      "yaw\n",
      what, f.rows, f.by_origin ? ", by where it comes from" : ", by where it goes to",
      f.mirrored ? ", mirrored" : "", speed, of, pressure * f.frontal * most.x() / 1000,
      pressure * f.lateral * most.y() / 1000, pressure * f.lateral * f.length * most.z() / 1000);
}

}  // namespace

std::string flow_text(const Case& c, const Body& b) {
  std::string s;
  const Wind& w = c.environment.wind;
  const BodyMass& m = *b.mass;
  if (m.wind)
    s += line("wind", *m.wind, w.density, w.speed * std::pow(m.wind->height / w.height, w.exponent),
              m.wind->height == w.height ? "" : fmt::format(" ({:g} m above the sea)", m.wind->height));
  if (m.current) {
    const auto& rows = c.environment.water.current.profile;
    const double speed = rows.empty() ? 1 : rows.front().speed;
    s += line("current", *m.current, c.environment.water.density, speed,
              rows.empty() ? " (there is none)" : "");
  }
  return s;
}

}  // namespace hawser::model
