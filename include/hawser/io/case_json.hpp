// The case as JSON, for the Python tools and other programs without a YAML reader.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::io {

// One-line JSON object with the members below; without `given` and `read` if the case has no `tree`.
//   file, results   absolute paths of the case file and of its results file
//   inputs          absolute paths of all files that the case reads
//   given           keys given by the file and by --set, with all values as text as written
//   read            all keys with their defaults: numbers in the base unit of the key (angles in deg), true
//                   and false, names and words as text; without defaults for line types of the library
//   platforms       of a farm: for each platform `file`, `places` by name ([x, y, heading], m and deg), and
//                   the keys of that file as `given` and `read`
//   line_types      by name, the properties used, in SI units: given, from the library or default
std::string case_json(const model::Case& c);

}  // namespace hawser::io
