// Notes of a case made shorter.
#pragma once

#include <string>
#include <vector>

namespace hawser::model {

// "A, B and C", or "A ... Z (18 in all)" of more than four.
std::string names_text(const std::vector<std::string>& names);

// Notes "volume NAME: TEXT" (or of a key, "volumes.NAME: TEXT") whose TEXT is the same become one, in the
// place of the first: "volumes A, B and C: TEXT", of more than four "volumes A ... Z (18 in all): TEXT".
// Others stay.
std::vector<std::string> grouped_notes(const std::vector<std::string>& notes);

}  // namespace hawser::model
