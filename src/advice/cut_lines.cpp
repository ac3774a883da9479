// Notes on lines that events cut.
#include "hawser/advice/cut_lines.hpp"

#include <fmt/format.h>

namespace hawser::advice {

std::vector<std::string> parts_of_cut_lines(const model::Case& c) {
  std::vector<std::string> notes;
  for (const model::Line& part : c.lines)
    if (part.given && part.from > 0)
      notes.push_back(fmt::format(
          "lines.{}: what is beyond its cut at {:g} m is '{}' in results, with arc lengths from there",
          part.given->name, part.from, part.name));
  return notes;
}

}  // namespace hawser::advice
