// Messages about lines near volumes at the start, with remedies.
#include "hawser/advice/start_contact.hpp"

#include <fmt/format.h>

#include "point_text.hpp"

namespace hawser::advice {
namespace {

// Remedy: a longer stretch without contact at a held end if one is given but too short, shorter elements if
// they alone are inside, else another start shape.
std::string remedy(const model::Line& line, const InsideVolume& s) {
  const double length = s.length;
  for (const LineEnd end : kLineEnds) {
    const bool at_b = end == LineEnd::B;
    const double within = line.end(end).no_contact_within.value_or(-1);
    if (within >= 0 && (at_b ? s.to >= length - within - 1e-9 * length : s.from <= within + 1e-9 * length))
      return fmt::format("'no_contact_within' of {} must be at least {:.3g} m to exclude that stretch",
                         end_key(end), at_b ? length - s.from : s.to);
  }
  if (s.outside_with > 0)
    return fmt::format(
        "the points of its 'start' are outside, but straight elements between them cut the volume: give it "
        "elements of at most {:.2g} m there",
        s.outside_with);
  if (line.start == model::Start::points) return "move the points of its 'start' out of it";
  return "give a shape outside the volume with 'start: {points: [[x, y, z], ...]}'";
}

std::string where_inside(const InsideVolume& s) {
  return fmt::format("from {:.4g} m to {:.4g} m of arc length, deepest at {:.4g} m, {:.3g} m inside at {}",
                     s.from, s.to, s.at, s.depth, point_text(s.place));
}

}  // namespace

std::string line_inside(const std::string& line, const InsideVolume& s) {
  return fmt::format("line {} is inside it {}", line, where_inside(s));
}

std::string more_stretches_inside(size_t stretches) {
  return fmt::format("and {} more stretches of lines lie inside volumes", stretches);
}

std::string more_ends_excluded(size_t ends) {
  return fmt::format("and {} more ends of lines start like these", ends);
}

std::string more_lines_on_wrong_side(size_t lines) {
  return fmt::format("and {} more lines start like these", lines);
}

std::string starts_inside(const model::Line& line, const std::string& volume, const InsideVolume& s) {
  const bool through = s.from > 0 && s.to < s.length;
  const std::string finding = through ? fmt::format("its start shape passes through volume {}", volume)
                                      : fmt::format("its start shape lies in volume {}", volume);
  return fmt::format("lines.{}: {} {}; {}", line.name, finding, where_inside(s), remedy(line, s));
}

std::string stays_inside(const model::Line& line, const std::string& volume, const InsideVolume& s,
                         bool statics) {
  const std::string stays =
      statics ? fmt::format("starts inside volume {}, and statics leaves it there,", volume)
              : fmt::format("starts inside volume {}, and there are no statics to move it out:", volume);
  return fmt::format("lines.{}: {} {}; {}", line.name, stays, where_inside(s), remedy(line, s));
}

std::string excluded_at_end(const model::Line& line, LineEnd line_end, const std::string& volume,
                            double depth, double without) {
  const std::string starts = depth > 0 ? fmt::format("starts up to {:.3g} m inside volume {}", depth, volume)
                                       : fmt::format("starts at the surface of volume {}", volume);
  return fmt::format(
      "lines.{}.{}: {}; the {:.3g} m of line up to where it is clear of it have no contact with it "
      "('no_contact_within' sets another length)",
      line.name, end_key(line_end), starts, without);
}

std::string passes_volume(const model::Line& line, const std::string& volume, const Passes& p) {
  const std::string where =
      fmt::format("{:.3g} m from it at {:.4g} m of arc length, {}", p.distance, p.arc, point_text(p.place));
  const std::string confirm = "confirm it with 'start: {points: [[x, y, z], ...]}'";
  if (p.carries_a || p.carries_b)
    return fmt::format(
        "lines.{}: its start shape passes under volume {}, {}, while its end {} is above it; if that is "
        "intended, {}",
        line.name, volume, where, p.carries_a ? "A" : "B", confirm);
  // True of a line on the wrong side of a volume and of one in the bore of a tube.
  const std::string side = p.under ? "below" : "above";
  return fmt::format(
      "lines.{}: volume {} is between its start shape and the straight line between its ends: the start "
      "shape is {} that part of the volume, {}; if the line is intended to be there, or in a bore of the "
      "volume, {}",
      line.name, volume, side, where, confirm);
}

std::string driven_apart(const std::string& volume, const std::string& other, const std::string& body,
                         double energy, double out) {
  return fmt::format(
      "volumes {} and {} start in contact with {:.3g} J of elastic energy, which drives them apart; give "
      "bodies.{}.position {:.2g} m further away",
      volume, other, energy, body, out);
}

}  // namespace hawser::advice
