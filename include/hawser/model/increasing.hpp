// The rule that rows of a table increase, with the text of its refusal.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace hawser::model {

// Empty if the value `now` of a row is more than `tolerance` above that of the row before it; otherwise the
// reason for a refusal. quantities: in plural, such as "depths"; unit: may be empty.
inline std::string increase_fault(std::string_view quantities, std::string_view unit, double before,
                                  double now, double tolerance = 0) {
  if (now > before + tolerance) return {};
  const std::string_view space = unit.empty() ? "" : " ";
  return fmt::format("{} must increase from row to row, but {:.10g}{}{} follows {:.10g}{}{}", quantities, now,
                     space, unit, before, space, unit);
}

}  // namespace hawser::model
