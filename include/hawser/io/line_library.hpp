// The line types library (data/line-types.yaml, part of the program): chains and ropes by nominal diameter.
#pragma once

#include <string>
#include <vector>

#include "hawser/io/case_reader_parts.hpp"
#include "hawser/model/case.hpp"

namespace hawser::io {

// A cable type from the keys `library`, `diameter` and `grade` of a line type `v`. A name
// or a grade that is not there, a key that is missing or superfluous and a diameter for which a formula gives
// nothing positive are refused with one sentence.
model::LineType library_line_type(const model::Value& v);

std::vector<std::string> line_library_names();

// The page docs/user-guide/line-types.md.
std::string line_library_markdown();

}  // namespace hawser::io
