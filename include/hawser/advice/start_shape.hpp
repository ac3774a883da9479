// Messages about start shapes of lines: ends against their direction, crossings, supports out of reach. The
// caller adds the key of a refusal.
#pragma once

#include <cstddef>
#include <string>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// A line would have to turn by `angle` [rad] to have the direction of its end.
std::string against_direction(const model::Line& line, LineEnd line_end, double angle);
// Both ends are free, so the position of the line is undefined.
std::string no_start_shape(const std::string& line);

// Lines that cross at a place [m].
std::string undecided_crossing(const std::string& line, const std::string& other, const Vec3& at);
std::string cannot_be_over(const std::string& upper, const std::string& lower, const Vec3& at);
std::string starts_over_line(const std::string& upper, const std::string& lower, const Vec3& at);
std::string starts_over_volume(const std::string& line, const std::string& volume, const Vec3& at);
std::string more_start_over_lines(size_t lines);
std::string more_start_over_volumes(size_t lines);

// Start shapes of another run, of a file of results; the latter with the lengths [m] here and there.
std::string not_in_other_run(const std::string& line, const std::string& file);
std::string other_length_in_run(const std::string& key, double length, double previous_length,
                                const std::string& file);

// A link whose ends start at the same point.
std::string link_without_length();

// m: length of the line, and of its shortest path over its supports.
std::string too_short_for_supports(double length, double path_length);

}  // namespace hawser::advice
