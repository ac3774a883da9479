// Sentences about the start shapes of lines: ends against their direction, lines that cross, supports out of
// reach. Where a text is a refusal, the caller has its key.
#pragma once

#include <cstddef>
#include <string>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// An end whose direction the line would have to turn by `angle` [rad] to have.
std::string against_direction(const model::Line& line, bool at_b, double angle);
// both ends free, and nothing says where the line is
std::string no_start_shape(const std::string& line);

// Lines that cross at a place [m].
std::string undecided_crossing(const std::string& line, const std::string& other, const Vec3& at);
std::string cannot_be_over(const std::string& over, const std::string& under, const Vec3& at);
std::string starts_over_line(const std::string& over, const std::string& under, const Vec3& at);
std::string starts_over_volume(const std::string& line, const std::string& volume, const Vec3& at);
std::string more_start_over_lines(size_t lines);
std::string more_start_over_volumes(size_t lines);

// A link whose ends start at one point.
std::string link_without_length();

// m: of the line, and of its shortest way over its supports.
std::string too_short_for_supports(double length, double way);

}  // namespace hawser::advice
