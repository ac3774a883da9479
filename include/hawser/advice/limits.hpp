// Messages about extremes of a run that exceed the capacity of a line.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// Time of an extreme: "t = 2.5 s", or "at rest" for the initial static equilibrium.
std::string when_text(const model::Case& c, double time);

// Extreme of a line, in SI units.
struct Extreme {
  std::string line;
  double value = 0, time = 0, arc = 0;
};
// The first three are empty if the extreme is acceptable. Utilisation above 1; exceeded: the consequence for
// the line; label: name of the utilisation.
std::string utilisation_warning(const model::Case& c, const Extreme& at, const std::string& exceeded,
                                const std::string& label);
// Compression (negative tension) beyond the buckling load.
std::string compression_warning(const model::Case& c, const Extreme& at);
// Curvature at which the steel of a line laid over supports yields.
std::string curvature_warning(const model::Case& c, const Extreme& at);
// Penetration [m] of a line into a volume that needs no warning: a fraction of the line's radius, or about
// twice the `allowed_penetration` of the volume.
double acceptable_penetration(const model::Case& c, const model::Line& line, const model::Volume& volume);
// Likewise in an impact on an automatic stiffness: about half the radius.
double acceptable_impact_penetration(const model::Case& c, const model::Line& line,
                                     const model::Volume& volume);
// A body whose centre of mass was `depth` [m] below the seabed.
std::string below_bed(const std::string& body, double depth);
// Automatic stiffness of a volume at the time of a penetration.
struct PenetratedStiffness {
  double per_length = 0;   // N/m per m
  bool in_impact = false;  // the time step resolves an impact
  bool highest = false;    // it has its largest value
};
// For a penetration of the volume above the acceptable one; stiffness: for an automatic one.
std::string penetration_warning(const model::Case& c, const Extreme& at, const model::Volume& volume,
                                const PenetratedStiffness& stiffness = {});
// `minimum_bend_radius` of a line type without bending.
std::string bend_radius_without_bending(const std::string& type);
// Design tension of a pipe over its yield tension.
std::string beyond_pipe_formulas(double pulled);

}  // namespace hawser::advice
