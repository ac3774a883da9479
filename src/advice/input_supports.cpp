// Supports that bend their line beyond the capacity of pipes, and elements too long to resolve roller
// contact.
#include <fmt/format.h>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/model/check.hpp"

namespace hawser::advice {

using namespace model;

namespace {

constexpr double kStrain = 0.005;  // of the outer fibre; laying criteria of steel pipes are 0.2 to 0.35 %
constexpr double kCoarse = 0.5;    // of the distance of boxes; roller peaks are then 1.4 % too low

struct Here {
  double diameter = 0, element = 0;  // m; longest element of the section
};

// Section at arc length `from` [m] from the end before the supports.
Here section_at(const Case& c, const Line& line, LineEnd start, double from) {
  Here out;
  for (std::size_t i = 0; i < line.sections.size(); ++i) {
    const Section& s = line.sections[start == LineEnd::A ? i : line.sections.size() - 1 - i];
    if (from < 0) break;
    from -= s.length;
    out = {c.line_type(s.type).outer_diameter, s.length / s.elements};
  }
  return out;
}

void warn_of_line(const Case& c, const Line& line, std::vector<InputWarning>& out) {
  const SupportBox* before = nullptr;
  const End* end = nullptr;
  double arc = 0;
  for (const SupportBox& b : c.supports) {
    if (b.line != line.name) continue;
    const Vec3 at = support_point(c, b, b.at);
    if (!before) {
      end = end_before(c, line, b);
      if (!end) return;
      arc = (at - end_position(c, *end)).norm();
      before = &b;
      continue;
    }
    const Vec3 previous = support_point(c, *before, before->at);
    const double spacing = (at - previous).norm();
    const Here local = section_at(c, line, end == &line.end_a ? LineEnd::A : LineEnd::B, arc + 0.5 * spacing);
    arc += spacing;
    const Vec3 turn = support_point(c, b, b.at + b.along) - at -
                      support_point(c, *before, before->at + before->along) + previous;
    if (const double strain = 0.5 * local.diameter * turn.norm() / spacing; strain > kStrain)
      add_warning(out, b.key, Effect::all,
                  "between supports '{}' and '{}' line '{}' is bent to a radius of {:.4g} m, a strain of "
                  "{:.3g} %; usual in laying of steel pipes is less than 0.35 %",
                  before->name, b.name, line.name, spacing / turn.norm(), 100 * strain);
    else if (local.element > kCoarse * spacing)
      add_warning(out, "lines." + line.name + ".sections", Effect::resolution,
                  "its elements are {:.3g} m long between supports '{}' and '{}', which are {:.3g} m apart: "
                  "use elements of a quarter of that spacing to resolve bending moments on rollers",
                  local.element, before->name, b.name, spacing);
    before = &b;
  }
}

}  // namespace

void warn_of_supports(const Case& c, std::vector<InputWarning>& out) {
  for (const Line& line : c.lines) warn_of_line(c, line, out);
}

}  // namespace hawser::advice
