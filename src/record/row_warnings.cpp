// The limits beyond which a row of the summary is reported, and the sentences.
#include "hawser/record/row_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/model/check.hpp"
#include "hawser/record/line_extremes.hpp"
#include "hawser/record/support_log.hpp"
#include "hawser/record/utilisation.hpp"

namespace hawser::record {
namespace {

constexpr double kPinnedFoot = 1.0188;  // minus the first zero of the derivative of Airy's function

// A beam of weight w that stands on a pinned foot and is pulled further up, EI theta'' = w (z - z0) theta
// with theta' = 0 at the foot, buckles there where the compression is that of the first zero of Ai', 1.019
// (EI w²)^(1/3). Then its shape carries what presses, and its moments grow with it. A short one is a strut,
// which its weight does not hold: Euler's pi² EI/L².
std::string compressed(const model::Case& c, const io::SummaryRow& r) {
  if (r.quantity != "min effective tension" || !(r.value < 0)) return {};
  const model::Line& line = c.line(r.line);
  double arc = 0;
  const model::LineType* type = &c.line_type(line.sections.back().type);
  for (const model::Section& s : line.sections)
    if (r.arc_length <= (arc += s.length)) {
      type = &c.line_type(s.type);
      break;
    }
  if (type->kind != model::LineKind::beam) return {};
  const double w = c.environment.gravity * std::abs(advice::mass_in_water(c, *type, -HUGE_VAL));
  const double EI = std::min(type->EI2, type->EI3);
  const double strut = M_PI * M_PI * EI / std::pow(model::length_of(line), 2);
  const double buckles = std::max(kPinnedFoot * std::cbrt(EI * w * w), strut);
  if (!(-r.value > buckles)) return {};
  return fmt::format(
      "line {} is under an effective compression of {:.3g} kN at arc length {:.6g} m, {}; on a pinned foot "
      "it "
      "buckles at about {:.2g} kN: does its upper end pull enough?",
      r.line, -r.value / 1000, r.arc_length, when_text(c, r.time), buckles / 1000);
}

std::string penetration(const model::Case& c, const io::SummaryRow& r) {
  if (r.quantity != "max penetration") return {};
  const double radius = 0.5 * model::contact_diameter_of(c, c.line(r.line));
  // What the case allows is none of its surprises.
  double allowed = 0;
  for (const model::Volume& v : c.volumes) allowed = std::max(allowed, v.allowed_penetration);
  if (!(r.value > std::max(c.contact.warned_penetration * radius, 1.1 * allowed))) return {};
  return fmt::format(
      "line {} is {:.3g} m inside a volume (its radius is {:.3g} m) at arc length {:.6g} m, {}: {}", r.line,
      r.value, radius, r.arc_length, when_text(c, r.time),
      r.value > radius ? "contact goes no deeper than the radius: it is trapped inside, or the volume is "
                         "too soft for a "
                         "line as thin as this, which then needs a larger 'contact_diameter'"
                       : "a normal_stiffness that is given can be raised; an automatic one is as high as "
                         "the line's EA "
                         "asks: is its tension more than it bears?");
}

}  // namespace

std::vector<std::string> row_warnings(const model::Case& c, const std::vector<Field>& fields,
                                      const io::SummaryRow& row) {
  std::vector<std::string> out = {overused(c, fields, row), compressed(c, row), overbent(c, row),
                                  penetration(c, row)};
  std::erase(out, "");
  return out;
}

}  // namespace hawser::record
