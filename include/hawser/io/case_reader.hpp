// From a case file to checked data.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::io {

// Read and check a case file: form, units, references, sense, and the meshes it names.
// Deterministic and without MPI: every rank may call it.
// Throws InputError; what() is one sentence "file:line: dotted.key: what is wrong".
model::Case read_case(const std::string& path);

// The same for text already read; `path` names the file and gives the directory of relative paths.
model::Case read_case_text(const std::string& text, const std::string& path);

}  // namespace hawser::io
