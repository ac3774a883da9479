// Messages of `hawser responses`.
#include "hawser/advice/responses.hpp"

#include <fmt/format.h>

#include "hawser/model/nearest.hpp"

namespace hawser::advice {

std::string responses_need_statics(const model::Case& c) {
  return c.refusal("statics", "responses need the static equilibrium, and this case has 'statics: false'");
}

std::string no_wave_forces(const model::Case& c) {
  return c.path +
         ": no body has wave forces by coefficients ('hydrodynamics' with a file of wave forces), which "
         "responses need; for other bodies run the case in waves and use hawser rao";
}

std::string not_a_floating_body(const model::Case& c, const std::string& body,
                                const std::vector<std::string>& all) {
  return fmt::format("{}: there is no floating body {}, but {}", c.path, model::quote(body),
                     model::enumerate(all, "and"));
}

std::string no_common_periods(const model::Case& c) {
  return c.path + ": the coefficients of the bodies have no periods in common";
}

std::string period_without_coefficients(const model::Case& c, double period, double from, double to) {
  return fmt::format("{}: --periods: the coefficients are those of {:.4g} to {:.4g} s, not of {:.4g} s",
                     c.path, from, to, period);
}

std::string direction_without_wave_forces(const model::Case& c, const std::string& body, double direction,
                                          double from_bow) {
  return fmt::format(
      "{}: the files of body {} have no wave forces near {:.4g} deg as seen from its bow, for waves to "
      "{:.4g} deg from +x: give others with --directions, or add this direction to the files",
      c.path, body, from_bow, direction);
}

std::string no_filter_of_thrusters(const model::Case& c, const std::string& body) {
  return fmt::format(
      "{}: bodies.{}.floating.positioning: responses do not include the filter of thrusters; for responses "
      "without thrusters replace it by a soft 'stiffness', otherwise run the case in waves and use hawser "
      "rao",
      c.path, body);
}

std::string bodies_share_a_table(const model::Case& c) {
  return c.path +
         ": two bodies would have the same table, as their names differ by '/' and '-' only: choose one by "
         "--body";
}

std::string no_memory_for_responses() {
  return "responses: the factors of the equations do not fit into memory: use more hosts, or fewer elements";
}

std::string singular_response(double period) {
  return fmt::format(
      "responses: the equations are singular at {:.6g} s: the system resonates there without damping, or a "
      "part of it has no mass; give other --periods",
      period);
}

std::string waves_by_coefficients_only(const std::vector<std::string>& bodies) {
  return fmt::format(
      "responses have the wave forces of coefficients only, not those on members, hulls and lines: {} would "
      "respond otherwise in a run",
      model::enumerate(bodies, "and"));
}

std::string no_quadratic_damping(const std::vector<std::string>& subjects) {
  return fmt::format(
      "responses are those to low waves, without the quadratic damping and drag of {}: near natural periods, "
      "also those of lines (hawser modes), they are too large unless there is linear damping (such as "
      "'hydrodynamics.damping', six rows of six)",
      model::enumerate(subjects, "and"));
}

}  // namespace hawser::advice
