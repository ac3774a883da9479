// Formulas for automatic contact stiffness, of a line on a volume and of lines that cross, and the sentences
// that tell the user which stiffness was chosen, raised or too low. Chosen for volumes at the start in
// run/simulation.cpp (choose_stiffness), for pairs of lines in run/line_pairs.cpp; raised during a run:
// line_volume_automatic_stiffness.cpp asks, contact_volumes_automatic_stiffness.cpp raises.
#include "hawser/terms/automatic_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>
#include <variant>

namespace hawser {
namespace {

constexpr double kLeast = 1, kMost = 10;  // m, of the radius of bending
// Of lines on lines: a strain that few survive, and the part of the radius that a line which is stretched by
// it and bent to its own radius is pressed in by.
constexpr double kBreaking = 0.01, kDeepest = 0.25;
constexpr double kHeldOut = 0.05;  // of the radius: penetration of the stiffness that is proposed

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", v);
  return text;
}

}  // namespace

AutomaticStiffness automatic_contact_stiffness(const StiffnessDemand& d) {
  const bool hangs = d.weight > 0;
  const double tension = hangs ? d.weight * d.length : 1e-4 * d.EA;
  const double shape = d.bend > 0 ? d.bend : std::max(d.radius, kLeast),
               stiff = tension > 0 ? 2 * std::sqrt(d.EI / tension) : 0, bend = std::max(shape, stiff);
  const double allowed = d.allowed_penetration > 0 ? d.allowed_penetration : kAllowedPenetration * d.radius;
  const double pressure = d.weight + tension / bend;
  return {pressure / allowed,
          "a tension of " + number(tension) + " N (" +
              (hangs ? "the line's weight" : "1e-4 of its EA, as it has no weight") +
              ") bent to a radius of " + number(bend) + " m (" +
              (stiff > shape     ? "the smallest to which it bends the line's EI over an edge"
               : d.bend >= kMost ? "no larger one is trusted"
               : d.bend > 0      ? "that of the shape"
                                 : "as that of the volume is not known") +
              ") and the line's weight of " + number(d.weight) + " N/m press in by " +
              (d.allowed_penetration > 0 ? "the allowed " : "0.5 % of the line's radius, ") +
              number(allowed) + " m"};
}

double most_stiffness(const StiffnessDemand& d) {
  const double allowed = d.allowed_penetration > 0 ? d.allowed_penetration : kAllowedPenetration * d.radius;
  return std::max(d.EA, d.weight * d.length) / (d.radius * allowed);
}

std::string raised_note(const std::string& volume, double from, double to, const std::string& when) {
  return "volume " + volume + ": normal stiffness raised from " + number(from) + " to " + number(to) +
         " N/m per m " + when +
         ", so that the line pressed on it by its tension times the curvature and by impacts penetrates no "
         "deeper than is allowed";
}

std::string too_soft_for_line(const std::string& place, const model::Volume& v, bool automatic, double depth,
                              double radius, double time) {
  const bool table = v.force_table != nullptr;
  std::string text = place + ", is " + number(depth) + " m deep in volume " + v.name +
                     " at t = " + number(time) + " s, deeper than " +
                     (table ? "its radius of " + number(radius) + " m and than the table of forces tells"
                            : "its radius of " + number(radius) + " m");
  if (automatic)
    return text + ", at a stiffness of " + number(v.normal_stiffness) +
           " N/m per m, which the program has raised as far as that helps: it starts inside the volume or is "
           "drawn into it by its ends; move it or the volume, or take that volume out of the line's contact";
  if (table)
    return text + ": give the table rows up to the forces that are met, or leave the stiffness to 'auto'";
  const std::string key = v.basis == model::StiffnessBasis::per_point    ? "per_point"
                          : v.basis == model::StiffnessBasis::per_length ? "per_length"
                                                                         : "per_area";
  return text + ", as far as contact goes: a stiffness of {" + key + ": " +
         number(v.normal_stiffness * depth / (kHeldOut * radius)) +
         "} would hold it to about 5 % of the radius ('auto' finds that by itself), and a line that is to "
         "sink "
         "in deeper needs a larger 'contact_diameter'";
}

std::string volume_blocks_path(const std::string& place, const model::Volume& v, bool too_soft) {
  const std::string text = place + ", would be drawn through volume " + v.name;
  if (!too_soft) return text + "; say on which side it lies with 'start: {points: [[x, y, z], ...]}'";
  return text + (v.force_table
                     ? ": give its table rows up to the forces that are met, or leave the stiffness to 'auto'"
                     : ": its normal_stiffness is too small for what presses, 'auto' finds one by itself");
}

double stiffness_by_weight(double mass_per_length, double radius) {
  constexpr double kStandardGravity = 9.80665;  // m/s²; where there is none lines touch as well
  return mass_per_length * kStandardGravity / (kAllowedPenetration * radius);
}

// c (r/4)³ = 0.01 EA/r
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
        else
          return s.radius;
      },
      *v.shape);
  return radius > 0 ? std::min(radius + line_radius, kMost) : 0;
}

double contact_period(double stiffness, double mass_per_length) {
  return 2 * M_PI * std::sqrt(mass_per_length / stiffness);
}

}  // namespace hawser
