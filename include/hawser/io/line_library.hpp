// The line types library (data/line-types.yaml, part of the program): chains and ropes by nominal diameter.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/case_reader_parts.hpp"
#include "hawser/model/case.hpp"

namespace hawser::io {

// Cable type from the keys `library`, `diameter` and `grade` of a line type `v`. Unknown names or grades,
// missing or superfluous keys, and diameters for which a formula is not positive are refused with one
// sentence.
model::LineType library_line_type(const model::Value& v);

std::vector<std::string> line_library_names();

// The page docs/user-guide/line-types.md.
std::string line_library_markdown();

}  // namespace hawser::io
