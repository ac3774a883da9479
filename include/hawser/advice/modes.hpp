// Messages of `hawser modes`, `hawser stiffness` and `hawser check --radiation`: refusals and results.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// Refusals of a case without statics.
std::string modes_need_statics(const model::Case& c);
std::string stiffness_needs_statics(const model::Case& c);

std::string fewer_modes_converged(size_t count, size_t requested);
std::string modes_incomplete();
std::string model_has_no_more_modes(size_t count);
std::string faster_instabilities(long directions);

// Refusals of the body of `hawser stiffness`; all: names of the bodies with attached lines.
std::string no_line_tied_to_body(const model::Case& c);
std::string lines_tied_to_bodies(const model::Case& c, const std::vector<std::string>& all);
std::string lines_not_tied_to(const model::Case& c, const std::string& body,
                              const std::vector<std::string>& all);
std::string body_rides_on_line(const model::Case& c, const std::string& body);

// For `hawser check --radiation` without coefficients.
std::string no_coefficients(const model::Case& c);

}  // namespace hawser::advice
