// Messages of `hawser responses`.
#pragma once

#include <string>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// Refusals.
std::string responses_need_statics(const model::Case& c);
std::string no_wave_forces(const model::Case& c);
// all: names of the floating bodies.
std::string not_a_floating_body(const model::Case& c, const std::string& body,
                                const std::vector<std::string>& all);
std::string no_common_periods(const model::Case& c);
// s; from, to: of all coefficients.
std::string period_without_coefficients(const model::Case& c, double period, double from, double to);
// deg, from +x and relative to the bow.
std::string direction_without_wave_forces(const model::Case& c, const std::string& body, double direction,
                                          double from_bow);

// A body with dynamic positioning.
std::string no_filter_of_thrusters(const model::Case& c, const std::string& body);
// Names of two bodies that differ by "/" and "-" only.
std::string bodies_share_a_table(const model::Case& c);

std::string singular_response(double period);
std::string no_memory_for_responses();

// Note on bodies with wave loads that are not by coefficients.
std::string waves_by_coefficients_only(const std::vector<std::string>& bodies);
// subjects: "body NAME", "lines".
std::string no_quadratic_damping(const std::vector<std::string>& subjects);

}  // namespace hawser::advice
