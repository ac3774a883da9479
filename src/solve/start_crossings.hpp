// Start shapes at crossings: determines which of two lines that cross near the bed is the upper one, and
// raises lines whose start shape passes through another line or through a volume on the bed without room
// below it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "start_line.hpp"
#include "start_share.hpp"

namespace hawser {

// A line of the case with its mesh and its shape; for a line that is cut later, the line as given.
struct StartedLine {
  const model::Line* line = nullptr;
  const Mesh* mesh = nullptr;
  LineSpan span;
  LineStart shape;
  int number = 0;        // in Case::lines, of its first part
  bool counted = false;  // this rank has its notes
};

// Moves lines with automatic start shapes; a note for each pair, of the rank that counts the first of them.
// Throws InputError if the upper line of two is not determined. See docs/theory/line-line.md.
std::vector<StartNote> lay_over_each_other(const model::Case& c, std::vector<StartedLine>& lines);

// surfaces: of the volumes of the case; empty: volumes are ignored.
std::vector<StartNote> lay_over_volumes(const model::Case& c, const Bodies& bodies,
                                        const std::vector<std::shared_ptr<const Surface>>& surfaces,
                                        std::vector<StartedLine>& lines);

}  // namespace hawser
