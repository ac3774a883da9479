// A case as the program has read it, for the Python tools and other programs, which need not read YAML then.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::io {

// A JSON object of one line. Of a case without `tree` it has no `given` and `read`.
//   file, results   absolute paths of the case file and of its results file
//   inputs          absolute paths of all files that it reads
//   given           the keys that the file (and --set) gives, all values as texts as they are written there
//   read            all keys with their defaults: numbers in the unit of a bare number (angles in deg), true
//   and
//                   false, names and words as texts. A line type of the library has no defaults here.
//   platforms       of a farm: of each platform `file`, `places` by name ([x, y, heading], m and deg), and
//                   the keys of that file as `given` and `read`
//   line_types      by name what each is computed with, in SI units, whether given, of the library or a
//   default
std::string case_json(const model::Case& c);

}  // namespace hawser::io
