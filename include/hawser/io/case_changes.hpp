// Changes that the command line makes to a case: --set KEY=VALUE.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/value.hpp"

namespace hawser::io {

// Makes the changes "KEY=VALUE" in a document that is parsed but not yet checked, in their order.
//   KEY: keys and names with '.' between them, places in lists in brackets from 0, which entries of maps of
//   names
//     have as well, in file order: lines.riser.sections[0].length, lines[0].end_a.anchor[2].
//   VALUE: YAML; null removes the key.
// Keys that the file does not have are added where the schema has them; entries of lists and of maps of names
// (lines, bodies) must be there. What is put in has model::kBySet as its line.
// Returns a note for each. Throws InputError with one sentence that names the change and the nearest valid
// key.
std::vector<std::string> change_document(model::Value& root, const std::vector<std::string>& changes,
                                         const std::string& file);

}  // namespace hawser::io
