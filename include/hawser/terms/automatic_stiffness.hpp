// A contact stiffness when the case gives none.
#pragma once

#include "hawser/advice/contact_stiffness.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// Of the radius: the penetration that an automatic stiffness aims at.
constexpr double kAllowedPenetration = 0.005;

struct StiffnessDemand {
  double radius = 0;               // m, half the contact diameter
  double weight = 0;               // N/m, of the element
  double line_weight = 0;          // N, of the whole line, all its sections
  double EA = 0, EI = 0;           // N, N m²
  double bend = 0;                 // m, smallest radius the axis is bent to; 0: not known
  double allowed_penetration = 0;  // m; 0: 0.5 % of the radius
};

struct AutomaticStiffness {
  double per_length = 0;  // N/m²
  advice::StiffnessReason reason;
};

// Lets the line's own weight and its hanging tension T, bent to the radius, press in by what is allowed.
// Where that radius is not known it is taken as the larger of 1 m and the line's. None is smaller than 2
// sqrt(EI/T), to which T bends the line over an edge. T of a line without weight is 1e-4 EA.
AutomaticStiffness automatic_contact_stiffness(const StiffnessDemand& d);

// N/m², beyond which an automatic stiffness is not raised: all of the line's EA, bent as sharply as its own
// radius, presses in by what is allowed. What is deeper then is held inside by something else.
double most_stiffness(const StiffnessDemand& d);

// Automatic stiffness between lines: a force F = k s + c s³ a metre at the penetration s. k [N/m²] is chosen
// so that the line's own weight, by standard gravity, penetrates by 0.5 % of its radius [m]; c [N/m⁴] so that
// 1 % of its EA [N], bent to its own radius, penetrates by a quarter of that radius.
double stiffness_by_weight(double mass_per_length, double radius);
double cubic_stiffness(double EA, double radius);

// m, radius to which a shape bends the axis of a line of this radius that lies on it, at most 10 m (no line
// is free of bends, on a plane neither); 0 for a mesh or a box: not known.
double bending_radius(const model::Volume& v, double line_radius);

// s, of a line that bounces on a spring of stiffness k [N/m²] with its mass per length [kg/m].
double contact_period(double stiffness, double mass_per_length);

}  // namespace hawser
