// Ends of sentences on what a user probably meant, "; a list stands in brackets" and the like; empty: nothing
// to say. Inside model only.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/schema.hpp"

namespace hawser::model {

// Of what stands after a number and is no unit.
std::string misspelt_number(const std::string& unit);
// Of a key and its value in one word, of what stands where a list or a map should be, and of a list with too
// few entries. allowed: the names of keys; k: the map.
std::string hint_of_no_colon(const std::string& text, const std::vector<std::string>& allowed);
std::string hint_of_no_list(const Value& v);
std::string hint_of_no_commas(const Value& v);
std::string hint_of_no_keys(const Value& v, const Key& k);
// Of the i-th key of a map, which its schema k does not have; allowed: the names it has.
std::string likely_key(const Value& v, std::size_t i, const Key& k, const std::vector<std::string>& allowed);

}  // namespace hawser::model
