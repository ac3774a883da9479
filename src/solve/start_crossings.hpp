// Start shapes at crossings: determines which of two lines that cross near the bed is the upper one, and
// raises lines whose start shape passes through another line or through a volume on the bed without room
// below it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "start_line.hpp"

namespace hawser {

// A line of the case with its mesh and its shape; for a line that is cut later, the uncut line.
struct StartedLine {
  const model::Line* line = nullptr;
  const Mesh* mesh = nullptr;
  LineSpan span;
  LineStart shape;
};

// Moves lines with automatic start shapes; notes name them. Throws InputError if nothing decides which of two
// lines lies over the other. See docs/theory/line-line.md.
void lay_over_each_other(const model::Case& c, std::vector<StartedLine>& lines,
                         std::vector<std::string>& notes);

// surfaces: of the volumes of the case; empty: volumes are ignored.
void lay_over_volumes(const model::Case& c, const Bodies& bodies,
                      const std::vector<std::shared_ptr<const Surface>>& surfaces,
                      std::vector<StartedLine>& lines, std::vector<std::string>& notes);

}  // namespace hawser
