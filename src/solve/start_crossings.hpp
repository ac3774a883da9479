// Which of two lines that cross near the bed lies over the other, and lines over volumes on the bed: start
// shapes that find one line in another, or below what leaves no room on the bed, are laid over it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "start_line.hpp"

namespace hawser {

// A line as the case gives it, whole where it is cut later, with its mesh and its shape.
struct StartedLine {
  const model::Line* line = nullptr;
  const Mesh* mesh = nullptr;
  LineSpan span;
  LineStart shape;
};

// Lines that start by themselves are moved; notes say which. InputError where nothing says which of two lines
// lies over the other. See docs/theory/line-line.md.
void lay_over_each_other(const model::Case& c, std::vector<StartedLine>& lines,
                         std::vector<std::string>& notes);

// surfaces: of the volumes of the case; empty: nothing is known of them.
void lay_over_volumes(const model::Case& c, const Bodies& bodies,
                      const std::vector<std::shared_ptr<const Surface>>& surfaces,
                      std::vector<StartedLine>& lines, std::vector<std::string>& notes);

}  // namespace hawser
