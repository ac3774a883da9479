// Messages of `hawser modes`, `hawser stiffness` and `hawser check --radiation`.
#include "hawser/advice/modes.hpp"

#include <fmt/format.h>

#include "hawser/model/nearest.hpp"

namespace hawser::advice {

std::string modes_need_statics(const model::Case& c) {
  return c.path + ": statics: modes need the static equilibrium, and this case has 'statics: false'";
}

std::string stiffness_needs_statics(const model::Case& c) {
  return c.path + ": statics: the stiffness needs the static equilibrium, and this case has 'statics: false'";
}

std::string fewer_modes_converged(size_t count, size_t requested) {
  return fmt::format("modes: {} of {} eigenvalues have converged: request fewer", count, requested);
}

std::string modes_incomplete() {
  return "modes: there are more natural frequencies than were found: request another number";
}

std::string model_has_no_more_modes(size_t count) {
  return fmt::format("note: the model has no more than {} modes", count);
}

std::string faster_instabilities(long directions) {
  return fmt::format("and {} more directions in which the equilibrium is unstable, faster than these",
                     directions);
}

std::string no_line_tied_to_body(const model::Case& c) {
  return c.path + ": no line is attached to a body, so there is no stiffness to compute";
}

std::string lines_tied_to_bodies(const model::Case& c, const std::vector<std::string>& all) {
  return fmt::format("{}: lines are attached to {}: choose one of them by --body", c.path,
                     model::enumerate(all, "and"));
}

std::string lines_not_tied_to(const model::Case& c, const std::string& body,
                              const std::vector<std::string>& all) {
  return fmt::format("{}: no line is attached to a body {}; lines are attached to {}", c.path,
                     model::quote(body), model::enumerate(all, "and"));
}

std::string body_rides_on_line(const model::Case& c, const std::string& body) {
  return fmt::format("{}: body {} rides on a line", c.path, body);
}

std::string no_coefficients(const model::Case& c) {
  return c.path + ": no body has 'hydrodynamics', so there are no coefficients for the table";
}

}  // namespace hawser::advice
