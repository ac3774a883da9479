// Hints at the end of error messages, such as "; a list stands in brackets"; empty: no hint. Internal to
// model.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/schema.hpp"

namespace hawser::model {

// For text after a number that is no unit.
std::string misspelt_number(const std::string& unit);
// For a key and value without a colon, for a value that should be a list or a map, and for a list with too
// few entries. allowed: names of keys; k: the map.
std::string hint_of_no_colon(const std::string& text, const std::vector<std::string>& allowed);
std::string hint_of_no_list(const Value& v);
std::string hint_of_no_commas(const Value& v);
std::string hint_of_no_keys(const Value& v, const Key& k);
// For the i-th key of a map, which its schema k does not have; allowed: names it has.
std::string likely_key(const Value& v, std::size_t i, const Key& k, const std::vector<std::string>& allowed);

}  // namespace hawser::model
