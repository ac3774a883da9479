// Default limit of automatic time steps, from the time scales of the case. The local error and the force
// terms reduce steps further.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::model {

// length = time/divisor of a time that the subject names ("the period of the waves").
struct LongestStep {
  double length = 0;  // s
  int divisor = 1;
  std::string subject;
};

// A hundredth of the period of prescribed motions and turns, of tables the mean period of the curve through
// their rows; a 75th of that of waves (mean period T01 of a spectrum, DNV-RP-C205 3.5.2.3; a ninetieth of the
// peak period); a twentieth of a ramp; a quarter of the shortest period of gusts; the time between outputs; a
// fiftieth of the duration. With a tenth of these as lower bound, a twentieth of the slowest period of each
// line (and of the travel time of a wave along it and back, if a run starts out of equilibrium or a speed
// jumps), and of the period of a body on its springs, on links and in the water surface; without periodic
// excitation a sixtieth, also of its period on taut lines. With half of these as lower bound, a tenth of the
// time constant of drag. Reasons: docs/theory/time-integration.md#step-length.
LongestStep longest_step(const Case& c);

// Slowest period of a line [s], from its weight as a hanging chain (2.405/2 sqrt(g/L)), its bending stiffness
// (pi²/L² sqrt(EI/m)) and the tension of a start that is shorter than its chord (pi/L sqrt(T/m)); 0: none of
// these (docs/theory/time-integration.md#slowest-period-of-a-line).
double slowest_period(const Case& c, const Line& line);

}  // namespace hawser::model
