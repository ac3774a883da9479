// Messages about start shapes.
#include "hawser/advice/start_shape.hpp"

#include <fmt/format.h>

#include <cmath>

#include "point_text.hpp"

namespace hawser::advice {
std::string against_direction(const model::Line& line, LineEnd line_end, double angle) {
  const Vec3& d = *line.end(line_end).direction;
  return fmt::format(
      "lines.{}.{}.direction: the line would have to turn by {:.0f} degrees to have this direction at end "
      "{}: at both ends the direction is the tangent from end A to end B; is [{:.3g}, {:.3g}, {:.3g}] meant?",
      line.name, end_key(line_end), angle * 180 / M_PI, end_letter(line_end), 0 - d.x(), 0 - d.y(),
      0 - d.z());
}

std::string no_start_shape(const std::string& line) {
  return fmt::format("lines.{}: both ends are free and no start shape is given", line);
}

std::string undecided_crossing(const std::string& line, const std::string& other, const Vec3& at) {
  return fmt::format(
      "it crosses line '{}' at {}, and the case does not define which of the two is on top; define it with "
      "'contact: {{between_lines: {{over: [[{}, {}]]}}}}' (the upper one first)",
      other, point_text(at), line, other);
}

std::string cannot_be_over(const std::string& upper, const std::string& lower, const Vec3& at) {
  return fmt::format(
      "line '{}' is to lie over line '{}', and its start shape passes through it at {}; move the points of "
      "its 'start' over it",
      upper, lower, point_text(at));
}

std::string starts_over_line(const std::string& upper, const std::string& lower, const Vec3& at) {
  return fmt::format(
      "lines.{}: starts over line {}, which it crosses at {} ('contact: {{between_lines: {{over: [[{}, "
      "{}]]}}}}' would have it under it)",
      upper, lower, point_text(at), lower, upper);
}

std::string starts_over_volume(const std::string& line, const std::string& volume, const Vec3& at) {
  return fmt::format("lines.{}: starts over volume {} at {}, as there is no room under it", line, volume,
                     point_text(at));
}

std::string more_start_over_lines(size_t lines) {
  return fmt::format("and {} more lines start over others", lines);
}

std::string more_start_over_volumes(size_t lines) {
  return fmt::format("and {} more lines start over volumes", lines);
}

std::string not_in_other_run(const std::string& line, const std::string& file) {
  return fmt::format("lines.{}: is not in {}, and starts by itself", line, file);
}

std::string other_length_in_run(const std::string& key, double length, double previous_length,
                                const std::string& file) {
  return fmt::format(
      "{}: the line is {:g} m long and was {:g} m in {}; its shape is taken by share of the length", key,
      length, previous_length, file);
}

std::string link_without_length() {
  return "its ends start at the same point, so that its length is 0: give it a 'rest_length', which may be "
         "0, or move its ends apart";
}

std::string too_short_for_supports(double length, double path_length) {
  return fmt::format(
      "the line is {:.6g} m long, and the shortest path over its supports to its other end is {:.6g} m; make "
      "the line {:.3g} m longer, or move the end",
      length, path_length, path_length - length);
}

}  // namespace hawser::advice
