// Shortened lists of names and notes.
#pragma once

#include <string>
#include <vector>

namespace hawser::model {

// "A, B and C", or "A ... Z (18 in all)" for more than four.
std::string names_text(const std::vector<std::string>& names);

// Joins notes "volume NAME: TEXT" (or with a key, "volumes.NAME: TEXT") of equal TEXT at the position of the
// first: "volumes A, B and C: TEXT", for more than four "volumes A ... Z (18 in all): TEXT". Other notes are
// unchanged.
std::vector<std::string> grouped_notes(const std::vector<std::string>& notes);

}  // namespace hawser::model
