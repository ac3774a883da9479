// Messages about lines near volumes at the start, with remedies.
#include "hawser/advice/start_contact.hpp"

#include <fmt/format.h>

#include "point_text.hpp"

namespace hawser::advice {
namespace {

// Remedy: a longer stretch without contact at a held end if one is given but too short, else another start
// shape.
std::string remedy(const model::Line& line, const InsideVolume& s) {
  const double length = s.length;
  for (const LineEnd end : kLineEnds) {
    const bool at_b = end == LineEnd::B;
    const double within = line.end(end).no_contact_within.value_or(-1);
    if (within >= 0 && (at_b ? s.to >= length - within - 1e-9 * length : s.from <= within + 1e-9 * length))
      return fmt::format("'no_contact_within' of {} must be at least {:.3g} m to exclude that stretch",
                         end_key(end), at_b ? length - s.from : s.to);
  }
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
  const std::string what = through ? fmt::format("its start shape passes through volume {}", volume)
                                   : fmt::format("its start shape lies in volume {}", volume);
  return fmt::format("lines.{}: {} {}; {}", line.name, what, where_inside(s), remedy(line, s));
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
  const std::string but = p.own_a   ? "while its end A is above it"
                          : p.own_b ? "while its end B is above it"
                          : p.under ? "while the straight line between its ends passes over it"
                                    : "while the straight line between its ends passes under it";
  return fmt::format(
      "lines.{}: its start shape passes {} volume {}, {:.3g} m from it at {:.4g} m of arc length, {}, {}; if "
      "that is intended, confirm it with 'start: {{points: [[x, y, z], ...]}}'",
      line.name, p.under ? "under" : "over", volume, p.distance, p.arc, point_text(p.place), but);
}

}  // namespace hawser::advice
