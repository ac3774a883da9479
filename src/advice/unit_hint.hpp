// Hints of a unit in which a bare number would be plausible.
#pragma once

#include <string>
#include <vector>

#include "hawser/math/function_ref.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/units.hpp"

namespace hawser::advice {

// "; is it in kN? ('900 kN')" for the first unit whose SI value satisfies `fits`. Empty: none does, or the
// number has a unit.
std::string unit_hint(const model::Value& v, model::Dimension d, FunctionRef<bool(double)> fits);
// The same for the value at nested keys: {"line_types", "chain", "EA"}.
std::string unit_hint(const model::Case& c, const std::vector<std::string>& keys,
                      FunctionRef<bool(double)> fits);

}  // namespace hawser::advice
