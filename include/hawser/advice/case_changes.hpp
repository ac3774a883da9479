// Notes on changes of the case by --set.
#pragma once

#include <string>

#include "hawser/model/value.hpp"

namespace hawser::advice {

// to: the new value as given; before: the former value, null if there was none.
std::string value_set(const std::string& key, const std::string& to, const model::Value* before);

}  // namespace hawser::advice
