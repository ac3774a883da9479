// Contact stiffness for cases that specify none.
#pragma once

#include "hawser/advice/contact_stiffness.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

// Penetration at which an automatic stiffness aims, as a fraction of the line's radius.
constexpr double kAllowedPenetration = 0.005;

struct StiffnessDemand {
  double radius = 0;               // m, half the contact diameter
  double weight = 0;               // N/m, weight of the element per length
  double line_weight = 0;          // N, weight of the whole line with all its sections
  double EA = 0, EI = 0;           // N, N m²
  double bend = 0;                 // m, smallest radius of curvature of the axis; 0: unknown
  double allowed_penetration = 0;  // m; 0: kAllowedPenetration times the radius
};

struct AutomaticStiffness {
  double per_length = 0;  // N/m²
  advice::StiffnessReason reason;
};

// Chooses the stiffness k so that the line's own weight w and its tension T, bent to the radius R, penetrate
// by the allowed depth d: k d = w + T/R. T is the weight of the whole line, or 1e-4 EA for a line without
// weight. If the radius is unknown, R is the larger of 1 m and the line's radius. R is at least 2 sqrt(EI/T),
// the radius to which T bends the line over an edge.
AutomaticStiffness automatic_contact_stiffness(const StiffnessDemand& d);

// Upper limit of an automatic stiffness, N/m²: with it the larger of EA and the whole line's weight, bent to
// the line's own radius, penetrates by the allowed depth. A line that is deeper is held inside by something
// other than its tension.
double largest_stiffness(const StiffnessDemand& d);

// Upper limit of the stiffness that an element which meets a surface end-on may request, N/m². The contact of
// one diameter is then as stiff as the line along itself over one diameter, k 2r = EA/2r.
double largest_stiffness_end_on(double EA, double radius);

// Automatic stiffness between lines: force per length F = k s + c s³ at the penetration s. With k [N/m²] the
// line's own weight, by standard gravity, penetrates by 0.5 % of its radius [m]; with c [N/m⁴] 1 % of its EA
// [N], bent to its own radius, penetrates by a quarter of that radius.
double stiffness_by_weight(double mass_per_length, double radius);
double cubic_stiffness(double EA, double radius);

// Radius of curvature [m] of the axis of a line of radius `line_radius` [m] that lies on the shape, at most
// 10 m, because no line is free of bends even on a plane. 0 for a mesh or a box: unknown.
double bending_radius(const model::Volume& v, double line_radius);

// Period [s] of a line that oscillates on a contact stiffness k [N/m²] with its mass per length [kg/m].
double contact_period(double stiffness, double mass_per_length);

// True if a step of h [s], 0 at rest, is as short as those that resolve an impact: shorter than two periods
// [s] of the mass on its contact spring. Penetration in such a step may be due to the impact.
bool resolves_impact(double h, double period);

}  // namespace hawser
