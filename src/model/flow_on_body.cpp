// Summary of forces, wind and current on a body for `hawser check`.
#include "hawser/model/flow_on_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/math/broken_line.hpp"
#include "hawser/model/case.hpp"

namespace hawser::model {
namespace {

// Largest forces in a flow of this speed over all directions.
std::string line(const char* medium, const FlowOnBody& f, double density, double speed,
                 const std::string& remark) {
  Vec3 largest = Vec3::Zero();
  for (int k = 0; k < 360; ++k) {
    Vec3 C, slope;
    f.coefficients.at(k * M_PI / 180, C, slope);
    largest = largest.cwiseMax(C.cwiseAbs());
  }
  const double pressure = 0.5 * density * speed * speed;
  return fmt::format(
      "    {} by {} rows{}{}: at {:.4g} m/s{} it has at most {:.4g} kN along, {:.4g} kN across and "
      "{:.4g} kN m of yaw\n",
      medium, f.rows, f.by_origin ? ", by where it comes from" : ", by where it goes to",
      f.mirrored ? ", mirrored" : "", speed, remark, pressure * f.frontal * largest.x() / 1000,
      pressure * f.lateral * largest.y() / 1000, pressure * f.lateral * f.length * largest.z() / 1000);
}

}  // namespace

std::string flow_text(const Case& c, const Body& b) {
  std::string s;
  const Wind& w = c.environment.wind;
  const BodyMass& m = *b.mass;
  if (!m.loads.empty()) {
    const auto varies =
        std::count_if(m.loads.begin(), m.loads.end(), [](const BodyLoad& l) { return !l.table.empty(); });
    Vec3 sum = Vec3::Zero();
    for (const BodyLoad& l : m.loads) {
      sum += l.force;
      if (!l.table.empty()) sum += on_broken_line(l.table, 0).head<3>();
    }
    s += fmt::format("    loads: {}{}; at t = 0 their forces are ({:.4g}, {:.4g}, {:.4g}) kN\n",
                     m.loads.size(), varies > 0 ? fmt::format(", of which {} by tables", varies) : "",
                     sum.x() / 1000, sum.y() / 1000, sum.z() / 1000);
  }
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
