// The doubts of all subjects as notes with the line of the file, many of one kind cut short.
#include "hawser/model/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "hawser/model/schema.hpp"

namespace hawser::model {

double mass_in_water(const Case& c, const LineType& type, double z) {
  const Water& w = c.environment.water;
  if (!w.present || z > w.surface) return type.mass_per_length;
  return type.mass_per_length - w.density * M_PI / 4 * type.displaced() * type.displaced();
}

std::vector<Doubt> doubts(const Case& c) {
  std::vector<Doubt> out;
  warn_of_ranges(c, out);
  warn_of_surroundings(c, out);
  doubt_line_types(c, out);
  warn_of_proportions(c, out);
  doubt_lines(c, out);
  warn_of_line_loads(c, out);
  doubt_supports(c, out);
  doubt_elements(c, out);
  doubt_bodies(c, out);
  warn_of_bodies(c, out);
  doubt_platforms(c, out);
  doubt_sea(c, out);
  doubt_times(c, out);
  return out;
}

std::vector<std::string> doubt_notes(const Case& c, Effect from, Effect to) {
  constexpr int kTold = 3;  // of a kind
  std::vector<Doubt> all = doubts(c);
  std::stable_sort(all.begin(), all.end(),
                   [](const Doubt& a, const Doubt& b) { return a.effect < b.effect; });
  std::erase_if(all, [&](const Doubt& d) { return d.effect < from || d.effect > to; });
  std::map<int, int> count, told;
  for (const Doubt& d : all) ++count[d.kind];
  std::vector<std::string> notes;
  for (const Doubt& d : all) {
    if (++told[d.kind] > kTold) continue;
    const int line = c.tree ? c.tree->line_of(d.key) : 0;
    std::string where = c.file;
    if (line > 0) where += fmt::format(":{}", line);
    if (line == kBySet) where += " with --set";
    const int more = count[d.kind] - kTold;
    notes.push_back(
        fmt::format("{}: {}: {}{}", where, d.key, d.text,
                    told[d.kind] == kTold && more > 0 ? fmt::format(" (and {} more like it)", more) : ""));
  }
  return notes;
}

}  // namespace hawser::model
