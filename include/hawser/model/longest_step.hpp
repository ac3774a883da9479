// Default limit of automatic time steps, from the time scales of the case. The local error and the force
// terms reduce steps further.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::model {

struct LongestStep {
  double length = 0;   // s
  std::string reason;  // time scale that determines it, for messages
};

// The smallest of: 1/100 of the period of prescribed motions and rotations (for tables the mean period of the
// curve through the rows); 1/75 of the wave period (T01 of a spectrum, DNV-RP-C205 3.5.2.3; 1/90 of Tp); 1/4
// of the shortest gust period; 1/20 of a ramp; the output interval; 1/50 of the duration. Reduced further,
// but to no less than a tenth of that, to 1/20 of the slowest period of each line (and of the axial wave
// travel time if the run starts out of balance or a speed jumps) and 1/20 of the periods of bodies on
// springs, links and hydrostatic stiffness. Without periodic excitation it is 1/60 of these body periods,
// taut lines included. Reduced to no less than half by 1/10 of the time constant of drag.
LongestStep longest_step(const Case& c);

// Slowest natural period of a line [s], from its weight as a hanging chain (2.405/2 sqrt(g/L)), its bending
// stiffness (pi²/L² sqrt(EI/m)) and the tension of a start shorter than its chord (pi/L sqrt(T/m)); 0: none
// of these.
double slowest_period(const Case& c, const Line& line);

}  // namespace hawser::model
