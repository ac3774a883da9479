// Input warnings of all subjects as notes with file lines; long lists of one kind are shortened.
#include "hawser/advice/input_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "hawser/model/farm.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::advice {

using namespace model;

double mass_in_water(const Case& c, const LineType& type, double z) {
  const Water& w = c.environment.water;
  if (!w.present || z > w.surface) return type.mass_per_length;
  return type.mass_per_length - w.density * M_PI / 4 * type.displaced() * type.displaced();
}

std::vector<InputWarning> input_warnings(const Case& c) {
  std::vector<InputWarning> out;
  warn_of_ranges(c, out);
  warn_of_surroundings(c, out);
  warn_of_line_types(c, out);
  warn_of_proportions(c, out);
  warn_of_lines(c, out);
  warn_of_line_loads(c, out);
  warn_of_supports(c, out);
  warn_of_elements(c, out);
  warn_of_rotations(c, out);
  warn_of_bodies(c, out);
  warn_of_platforms(c, out);
  warn_of_farms(c, out);
  warn_of_sea(c, out);
  warn_of_times(c, out);
  return out;
}

std::vector<std::string> input_notes(const Case& c, Effect from, Effect to) {
  constexpr int kReported = 3;  // per kind
  std::vector<InputWarning> all = input_warnings(c);
  std::stable_sort(all.begin(), all.end(),
                   [](const InputWarning& a, const InputWarning& b) { return a.effect < b.effect; });
  std::erase_if(all, [&](const InputWarning& w) { return w.effect < from || w.effect > to; });
  std::vector<std::string> texts;
  for (const InputWarning& w : all) texts.push_back(w.key + ": " + w.text);
  std::vector<InputWarning> joined;  // joined over the places of a farm
  for (const NoteOfPlaces& n : join_places(c, texts)) {
    joined.push_back(std::move(all[n.first]));
    joined.back().text += n.also;
  }
  all = std::move(joined);
  std::map<std::string, int> count, reported;
  for (const InputWarning& w : all) ++count[w.group];
  std::vector<std::string> notes;
  for (const InputWarning& w : all) {
    if (++reported[w.group] > kReported) continue;
    const auto& [file, line] = place_of(c, w.key);
    std::string where = file;
    if (line > 0) where += fmt::format(":{}", line);
    if (line == kBySet) where += " with --set";
    const int more = count[w.group] - kReported;
    notes.push_back(fmt::format(
        "{}: {}: {}{}", where, w.key, w.text,
        reported[w.group] == kReported && more > 0 ? fmt::format(" (and {} more like it)", more) : ""));
  }
  return notes;
}

}  // namespace hawser::advice
