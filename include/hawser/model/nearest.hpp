// Suggestions and quoted text for error messages.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::model {

// Optimal string alignment distance: insertions, deletions, substitutions and transpositions of neighbours. A
// change of letter case costs half, so 'ea' is nearer to 'EA' than to 'GA'.
double edit_distance(std::string_view a, std::string_view b);

// The candidate nearest to `word`; empty if more than about 40 % of its letters differ.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

// "; did you mean 'x'?" or empty.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

// "a blank is missing after the colon in 'key:value': write 'key: value'" if the text begins like this; else
// empty.
std::string missing_blank(std::string_view text);

// The text in quotes, on one line, at most 60 characters; control characters become '?'.
std::string quote(std::string_view text);

// "a, b or c", with `last` as the conjunction.
std::string enumerate(const std::vector<std::string>& words, std::string_view last = "or");

}  // namespace hawser::model
