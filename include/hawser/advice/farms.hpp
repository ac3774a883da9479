// Notes on farms: places of platforms, and what their files contain. file: of the case or of a platform.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/farm.hpp"

namespace hawser::advice {

// All headings of places are small. first: the first of them as written, deg.
std::string headings_in_radians(const std::string& file, int line, const std::string& key, double first);
std::string platforms_at_one_place(const std::string& file, const model::FarmPlace& place,
                                   const std::string& other);
// Keys of a platform file that the farm has itself.
std::string platform_keys_not_used(const std::string& file, const std::vector<std::string>& keys);

}  // namespace hawser::advice
