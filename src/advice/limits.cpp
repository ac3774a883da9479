// Limits of extremes, and their messages.
#include "hawser/advice/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/kernels/pipe_codes.hpp"
#include "hawser/model/check.hpp"

namespace hawser::advice {
namespace {

constexpr double kPinnedFoot = 1.0188;  // minus the first zero of the derivative of Airy's function

// Length of elements over the half wave of a buckle that they represent.
constexpr double kPerBuckle = 0.25;

// True if both ends are held and the upper one carries the line: it is higher by a quarter of the length or
// more.
bool has_upper_end(const model::Case& c, const model::Line& line) {
  constexpr double kSteep = 0.25;
  if (!model::is_held(line.end_a) || !model::is_held(line.end_b)) return false;
  const double height = model::end_position(c, line.end_a).z() - model::end_position(c, line.end_b).z();
  return std::abs(height) >= kSteep * model::length_of(line);
}

}  // namespace

std::string when_text(const model::Case& c, double time) {
  return c.statics.enabled && time == 0 ? "at rest" : fmt::format("t = {:.6g} s", time);
}

std::string utilisation_warning(const model::Case& c, const Extreme& at, const std::string& exceeded,
                                const std::string& label) {
  if (!(at.value > 1)) return {};
  return fmt::format("line {} is {} at arc length {:.6g} m, {}: its {} is {:.3g}", at.line, exceeded, at.arc,
                     when_text(c, at.time), label, at.value);
}

// A beam of weight w on a pinned foot, pulled up at its top, EI theta'' = w (z - z0) theta with theta' = 0 at
// the foot, buckles if the compression at the foot exceeds that of the first zero of Ai', 1.019 (EI
// w²)^(1/3). A short line is a strut without stabilising weight: Euler's pi² EI/L². Under the compression F
// it buckles between supports at distances of more than L = pi √(EI/F).
std::string compression_warning(const model::Case& c, const Extreme& at) {
  if (!(at.value < 0)) return {};
  const model::Line& line = c.line(at.line);
  const model::Section& section = model::section_at(line, at.arc);
  const model::LineType& type = c.line_type(section.type);
  if (type.kind != model::LineKind::beam) return {};
  const double w = c.environment.gravity * std::abs(mass_in_water(c, type, -HUGE_VAL));
  const double EI = type.smallest_bending_stiffness();
  const double strut = M_PI * M_PI * EI / std::pow(model::length_of(line), 2);
  const double limit = std::max(kPinnedFoot * std::cbrt(EI * w * w), strut);
  if (!(-at.value > limit)) return {};
  std::string finding =
      fmt::format("line {} is under an effective compression of {:.3g} kN at arc length {:.6g} m, {}",
                  at.line, -at.value / 1000, at.arc, when_text(c, at.time));
  if (has_upper_end(c, line))
    return fmt::format(
        "{}; with a pinned lower end it buckles at about {:.2g} kN: is the tension at its upper end too low?",
        finding, limit / 1000);
  const double supported = M_PI * std::sqrt(EI / -at.value);
  // Shorter elements represent the buckles.
  if (section.length / section.elements <= kPerBuckle * supported) return {};
  return fmt::format(
      "{}; it may buckle between supports that are more than {:.2g} m apart, which elements of {:.2g} m or "
      "less represent",
      finding, supported, kPerBuckle * supported);
}

double acceptable_penetration(const model::Case& c, const model::Line& line, const model::Volume& volume) {
  const double radius = 0.5 * model::contact_diameter_of(c, line);
  // An automatic stiffness is raised in motion above twice the given penetration (theory/contact.md); a
  // tenth is a margin.
  constexpr double kInMotion = 2.2;
  return std::max(c.contact.warned_penetration * radius, kInMotion * volume.allowed_penetration);
}

double acceptable_impact_penetration(const model::Case& c, const model::Line& line,
                                     const model::Volume& volume) {
  // An automatic stiffness is raised for impacts that would penetrate by more than half the radius; the rest
  // is a margin.
  constexpr double kInImpacts = 0.6;
  const double radius = 0.5 * model::contact_diameter_of(c, line);
  return std::max(kInImpacts * radius, acceptable_penetration(c, line, volume));
}

// In an impact of speed u the depth is u √(m/k), so that k (d/d_a)² limits d to d_a.
std::string penetration_warning(const model::Case& c, const Extreme& at, const model::Volume& volume,
                                const PenetratedStiffness& stiffness) {
  const model::Line& line = c.line(at.line);
  const double radius = 0.5 * model::contact_diameter_of(c, line);
  const bool automatic = volume.basis == model::StiffnessBasis::automatic;
  const double limit = volume.depth_limit(radius, automatic);
  const double allowed = acceptable_penetration(c, line, volume);
  std::string advice = "raise its normal_stiffness";
  if (automatic && volume.roller)
    advice = "give this support a 'normal_stiffness'";
  else if (automatic && stiffness.in_impact)
    advice = fmt::format(
        "this is an impact, for which an automatic stiffness limits the penetration to about half the radius "
        "only; 'normal_stiffness: {{per_length: {:.2g}}}' limits this one to about {:.2g} m",
        stiffness.per_length * std::pow(at.value / allowed, 2), allowed);
  else if (automatic && stiffness.highest)
    advice =
        "the automatic stiffness is as high as the line's EA allows: is the tension above the breaking load?";
  else if (automatic)
    advice = fmt::format(
        "the automatic stiffness is not raised here, as next to held ends; 'normal_stiffness: {{per_length: "
        "{:.2g}}}' limits the penetration to about {:.2g} m",
        stiffness.per_length * at.value / allowed, allowed);
  if (at.value > limit)
    advice = fmt::format(
        "the contact law of the volume holds to a depth of {:.3g} m, {}: the line is trapped inside, or the "
        "volume is too soft for a line this thin, which then needs a larger 'contact_diameter'",
        limit, limit > radius ? "the last row of its table" : "the radius of the line");
  else if (volume.force_table)
    advice = "the table of its normal_stiffness allows this depth: are its forces those of this volume?";
  return fmt::format(
      "line {} is {:.3g} m inside volume {} (its radius is {:.3g} m) at arc length {:.6g} m, {}: {}", at.line,
      at.value, volume.name, radius, at.arc, when_text(c, at.time), advice);
}

std::string curvature_warning(const model::Case& c, const Extreme& at) {
  constexpr double kYielded =
      0.005;  // total strain at which the yield stress of pipe steel is defined (API 5L)
  const auto lies = [&](const model::SupportBox& b) { return b.line == at.line; };
  if (std::none_of(c.supports.begin(), c.supports.end(), lies)) return "";
  double diameter = 0;
  for (const model::Section& s : c.line(at.line).sections)
    if (const model::LineType& t = c.line_type(s.type); !t.plastic_bending)
      diameter = std::max(diameter, t.outer_diameter);
  const double strain = 0.5 * diameter * at.value;
  if (!(strain > kYielded)) return "";
  return fmt::format(
      "line {} is bent to a radius of {:.3g} m at arc length {:.6g} m, {}, {:.2g} % of strain: steel yields "
      "at a smaller strain, and this pipe is elastic; check the positions and directions of its ends and "
      "supports, or add 'plasticity'",
      at.line, 1 / at.value, at.arc, when_text(c, at.time), 100 * strain);
}

std::string bend_radius_without_bending(const std::string& type) {
  return "line_types." + type +
         ".minimum_bend_radius: a type with 'bending: false' has no curvature to compare it with";
}

std::string beyond_pipe_formulas(double pulled) {
  return fmt::format(
      "the design tension of a pipe is {:.2g} of its yield tension: DNV-ST-F101's formulas for combined "
      "loads apply up to {:g}",
      pulled, kMaxPulled);
}

std::string below_bed(const std::string& body, double depth) {
  return fmt::format(
      "body {} sank to {:.3g} m below the seabed, which carries lines only: add a volume with "
      "'shape: {{plane: {{point: ..., normal: ...}}}}' at the seabed, and a volume of the body with a "
      "stiffness",
      body, depth);
}

}  // namespace hawser::advice
