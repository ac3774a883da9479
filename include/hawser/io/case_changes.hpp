// Changes of a case from the command line: --set KEY=VALUE.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/value.hpp"

namespace hawser::io {

// Applies the changes "KEY=VALUE" in order to a document that is parsed but not yet checked.
//   KEY: keys and names separated by '.', list indices in brackets from 0; entries of maps of names have
//     indices as well, in file order: lines.riser.sections[0].length, lines[0].end_a.anchor[2].
//   VALUE: YAML; null removes the key.
// Keys that the schema has but the file lacks are added; entries of lists and of maps of names (lines,
// bodies) must exist. New values have the line model::kBySet. Returns a note for each change. Throws
// InputError with one sentence that names the change and the nearest valid key.
std::vector<std::string> change_document(model::Value& root, const std::vector<std::string>& changes,
                                         const std::string& file);

}  // namespace hawser::io
