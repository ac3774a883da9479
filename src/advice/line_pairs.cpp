// Messages about contact between lines.
#include "hawser/advice/line_pairs.hpp"

#include <fmt/format.h>

#include "hawser/base/count_of.hpp"

namespace hawser::advice {

std::string chosen_pair_stiffness(double smallest, double largest, const std::string& only_line,
                                  bool themselves) {
  return fmt::format(
      "{}: a normal stiffness of {} N/m per m, chosen by weight and EA. "
      "contact.between_lines.normal_stiffness sets another value, and contact.between_lines: false switches "
      "this contact off",
      !only_line.empty() ? fmt::format("contact of line {} with itself", only_line)
      : themselves       ? "contact between lines and of lines with themselves"
                         : "contact between lines",
      largest > smallest * (1 + 1e-9) ? fmt::format("{:.3g} to {:.3g}", smallest, largest)
                                      : fmt::format("{:.3g}", largest));
}

std::string separate_near_place(const std::string& one, const std::string& other, double within, int more) {
  return fmt::format(
      "{} at one place, or at places nearer to each other than the contact radii: contact {} is excluded "
      "along the first {:.3g} m from there{}",
      one == other ? fmt::format("both ends of line {} are", one)
                   : fmt::format("lines {} and {} start", one, other),
      one == other ? "of its branches" : "between them", within,
      more > 0 ? fmt::format("; likewise of {}, along less", count_of(more, "more pair")) : "");
}

}  // namespace hawser::advice
