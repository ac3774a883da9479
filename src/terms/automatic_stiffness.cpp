// Formulas for automatic contact stiffness of a line on a volume and between lines.
// run/contact_stiffness.cpp and run/line_pairs.cpp choose the initial values. During a run
// line_volume_automatic_stiffness.cpp requests more for volumes, contact_volumes_automatic_stiffness.cpp
// raises it.
#include "hawser/terms/automatic_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

namespace hawser {
namespace {

constexpr double kLeast = 1, kMost = 10;  // m, limits of the bending radius
// For lines on lines: a strain close to failure, and the fraction of the radius by which a line with this
// strain, bent to its own radius, penetrates.
constexpr double kBreaking = 0.01, kDeepest = 0.25;

// Penetration allowed with an automatic stiffness, m.
double allowed_penetration(const StiffnessDemand& d) {
  return d.allowed_penetration > 0 ? d.allowed_penetration : kAllowedPenetration * d.radius;
}

}  // namespace

// k δ = w + T/R, R >= 2 sqrt(EI/T)
AutomaticStiffness automatic_contact_stiffness(const StiffnessDemand& d) {
  using Bend = advice::StiffnessReason::Bend;
  const bool hangs = d.line_weight > 0;
  const double tension = hangs ? d.line_weight : 1e-4 * d.EA;
  const double shape = d.bend > 0 ? d.bend : std::max(d.radius, kLeast);
  const double over_edge = tension > 0 ? 2 * std::sqrt(d.EI / tension) : 0;
  AutomaticStiffness out;
  advice::StiffnessReason& why = out.reason;
  why.tension = tension;
  why.weight = d.weight;
  why.has_weight = hangs;
  why.radius = std::max(shape, over_edge);
  why.bend = over_edge > shape ? Bend::over_edge
             : d.bend >= kMost ? Bend::largest
             : d.bend > 0      ? Bend::of_shape
                               : Bend::unknown;
  why.penetration = allowed_penetration(d);
  why.penetration_given = d.allowed_penetration > 0;
  out.per_length = (d.weight + tension / why.radius) / why.penetration;
  return out;
}

double largest_stiffness(const StiffnessDemand& d) {
  return std::max(d.EA, d.line_weight) / (d.radius * allowed_penetration(d));
}

double largest_stiffness_end_on(double EA, double radius) { return EA / (4 * radius * radius); }

double stiffness_by_weight(double mass_per_length, double radius) {
  constexpr double kStandardGravity = 9.80665;  // m/s²; also used without gravity, where lines touch as well
  return mass_per_length * kStandardGravity / (kAllowedPenetration * radius);
}

// k₃ (r/4)³ = 0.01 EA/r
double cubic_stiffness(double EA, double radius) {
  return kBreaking * EA / (radius * std::pow(kDeepest * radius, 3));
}

double bending_radius(const model::Volume& v, double line_radius) {
  if (!v.shape) return 0;
  const double radius = std::visit(
      [](const auto& s) {
        using Shape = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<Shape, PlaneShape>)
          return kMost;
        else if constexpr (std::is_same_v<Shape, BoxShape>)
          return 0.0;
        else if constexpr (std::is_same_v<Shape, TorusShape>)
          return s.tube_radius;
        else if constexpr (std::is_same_v<Shape, TubeShape>)
          return s.outer_radius();
        else
          return s.radius;
      },
      *v.shape);
  return radius > 0 ? std::min(radius + line_radius, kMost) : 0;
}

double contact_period(double stiffness, double mass_per_length) {
  return 2 * M_PI * std::sqrt(mass_per_length / stiffness);
}

bool resolves_impact(double h, double period) {
  constexpr double kPeriods = 2;
  return h > 0 && h < kPeriods * period;
}

}  // namespace hawser
