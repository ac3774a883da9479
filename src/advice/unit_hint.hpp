// In which other unit a number that was written without one would be plausible.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/model/units.hpp"

namespace hawser::advice {

// "; is it in kN? ('900 kN')" for the first unit that fits, by the SI value that the number then has. Empty:
// none does, or the number has its unit.
std::string unit_hint(const model::Value& v, model::Dimension d, const std::function<bool(double)>& fits);
// The same of the value at these keys, one below the other: {"line_types", "chain", "EA"}.
std::string unit_hint(const model::Case& c, const std::vector<std::string>& keys,
                      const std::function<bool(double)>& fits);

}  // namespace hawser::advice
