// Notes on grids and meshes of the seabed.
#include "hawser/advice/bed_files.hpp"

#include <fmt/format.h>

namespace hawser::advice {
namespace {

std::string isolated_height(const Vec3& row, size_t more, double gap) {
  return fmt::format("{:g} m at x {:g}, y {:g}{} is {:.3g} m from all other heights", row.z(), row.x(),
                     row.y(), more > 0 ? fmt::format(" and in {} more places", more) : "", gap);
}

}  // namespace

std::string no_data_value(const Vec3& row, size_t more, double gap) {
  return isolated_height(row, more, gap) + ": it is a no-data value; replace it by the height around it";
}

std::string possible_no_data_value(const std::string& key, const std::string& file, int line, const Vec3& row,
                                   size_t more, double gap) {
  return fmt::format("{}: {}:{}: {}: is it a no-data value?", key, file, line,
                     isolated_height(row, more, gap));
}

std::string surface_beyond_heights(const std::string& file, const HeightGrid::Overshoot& at) {
  return fmt::format(
      "environment.seabed.grid: the smooth surface through the heights of {} goes {:.2g} m {} them at x "
      "{:.4g}, y {:.4g}, beside a step or a bend, and less elsewhere; if lines come there, give more heights "
      "across the step, or a mesh",
      file, at.height, at.above ? "above" : "below", at.at.x(), at.at.y());
}

std::string end_beyond_bed(const std::string& key, const std::string& file, bool extrapolated) {
  return fmt::format("{}: lies beyond the edge of the bed of {}, {}", key, file,
                     extrapolated ? "which is extrapolated there" : "where there is none");
}

std::string bed_lowered_at_end(const std::string& key, double depth, double length) {
  return fmt::format(
      "{}: is {:.3g} m below the seabed, so the program lowers the seabed there along {:.3g} m of the line; "
      "move the end to the seabed, or give the length that is 'buried'",
      key, depth, length);
}

}  // namespace hawser::advice
