// Sentences about extremes of a run that are more than a line bears.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// Of an extreme, "t = 2.5 s", or "at rest" where the run begins with its static equilibrium.
std::string when_text(const model::Case& c, double time);

// Of a line, in SI units.
struct Extreme {
  std::string line;
  double value = 0, time = 0, arc = 0;
};
// An empty text where the extreme is none too many. A utilisation of more than 1: what the line then is, and
// the name of it.
std::string utilisation_warning(const model::Case& c, const Extreme& at, const std::string& exceeded,
                                const std::string& label);
// Compression, a tension below 0, under which it buckles.
std::string compression_warning(const model::Case& c, const Extreme& at);
// A curvature with which the steel of a line that is laid over supports yields.
std::string curvature_warning(const model::Case& c, const Extreme& at);
// A penetration of a volume.
std::string penetration_warning(const model::Case& c, const Extreme& at);
// Of the design tension of a pipe, of that at yield.
std::string beyond_pipe_formulas(double pulled);

}  // namespace hawser::advice
