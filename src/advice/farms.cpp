// Notes on farms.
#include "hawser/advice/farms.hpp"

#include <fmt/format.h>

#include "hawser/math/degree.hpp"
#include "hawser/model/nearest.hpp"

namespace hawser::advice {

std::string headings_in_radians(const std::string& file, int line, const std::string& key, double first) {
  return fmt::format(
      "{}:{}: {}: headings of places are in degrees, and all of these are small, the first is {:g} deg; if "
      "radians are meant, write {:.4g}",
      file, line, key, first, first / kDegree);
}

std::string platforms_at_one_place(const std::string& file, const model::FarmPlace& place,
                                   const std::string& other) {
  return fmt::format("{}: farm: {} is at the place of {}, ({:g}, {:g}); is it meant?", file, place.name,
                     other, place.x, place.y);
}

std::string platform_keys_not_used(const std::string& file, const std::vector<std::string>& keys) {
  std::vector<std::string> quoted;
  for (const std::string& key : keys) quoted.push_back("'" + key + "'");
  const bool one = keys.size() == 1;
  return fmt::format("{}: {} {} not used: a farm has {} own", file, model::enumerate(quoted, "and"),
                     one ? "is" : "are", one ? "its" : "their");
}

}  // namespace hawser::advice
