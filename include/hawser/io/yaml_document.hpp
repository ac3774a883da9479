// Parser of YAML text into a model::Value tree with line numbers.
#pragma once

#include <string>

#include "hawser/model/value.hpp"

namespace hawser::io {

// `file` is only for messages. Throws InputError "file:line: ..." for syntax errors, duplicate or non-scalar
// keys, more than one document, nesting deeper than 40, or more than 10^6 nodes (aliases count at every use).
model::Value parse_yaml(const std::string& text, const std::string& file);

}  // namespace hawser::io
