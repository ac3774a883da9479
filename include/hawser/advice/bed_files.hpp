// Notes on grids and meshes of the seabed, and on line ends beside or below them.
#pragma once

#include <cstddef>
#include <string>

#include "hawser/geometry/height_grid.hpp"
#include "hawser/math/types.hpp"

namespace hawser::advice {

// Row of a grid whose height is `gap` [m] from all other heights, as are those of `more` rows. row: as in the
// file. The refusal of a height that is certainly a no-data value, without the place in the file, and the
// note on another one.
std::string no_data_value(const Vec3& row, size_t more, double gap);
std::string possible_no_data_value(const std::string& key, const std::string& file, int line, const Vec3& row,
                                   size_t more, double gap);
// The smooth surface through the heights of a file.
std::string surface_beyond_heights(const std::string& file, const HeightGrid::Overshoot& at);

// A line end beyond the bed of a file. extrapolated: the bed continues there.
std::string end_beyond_bed(const std::string& key, const std::string& file, bool extrapolated);
// A line end `depth` [m] below the bed, which is lowered along this length of the line [m].
std::string bed_lowered_at_end(const std::string& key, double depth, double length);

}  // namespace hawser::advice
