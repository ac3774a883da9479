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
      "{} from one place, or from places nearer to each other than the contact radii, and {} only more than "
      "{:.3g} m along from there, beyond where they are first apart{}",
      one == other ? fmt::format("both ends of line {} go", one)
                   : fmt::format("lines {} and {} go", one, other),
      one == other ? "they touch each other" : "touch each other", within,
      more > 0 ? fmt::format("; likewise {}, over less", count_of(more, "more pair")) : "");
}

}  // namespace hawser::advice
