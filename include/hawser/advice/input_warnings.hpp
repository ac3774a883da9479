// Warnings of valid but implausible input: wrong units, lost digits, wrong signs. None of them stops a run.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// Results that the fault can affect: all, as by a wrong unit; a part or the start of a run; or only their
// resolution.
enum class Effect { all, part, resolution };

struct InputWarning {
  std::string key;    // dotted, as in the file
  std::string text;   // the value there, and the usual range
  std::string group;  // only the first few of a group are reported
  Effect effect = Effect::all;
};

// Warnings with the same text form a group.
template <class... Args>
void add_warning(std::vector<InputWarning>& out, std::string key, Effect effect,
                 fmt::format_string<Args...> sentence, Args&&... args) {
  const fmt::string_view raw = sentence;
  out.push_back(
      {std::move(key), fmt::format(sentence, std::forward<Args>(args)...), {raw.data(), raw.size()}, effect});
}

// Everything unusual of a case that model::check passes, in the order of the functions below. Empty for an
// ordinary case.
std::vector<InputWarning> input_warnings(const model::Case& c);
// "file:line: key: text" each, largest effect first; of each kind the first three and the number of the rest.
// Only effects from `from` to `to`.
std::vector<std::string> input_notes(const model::Case& c, Effect from = Effect::all,
                                     Effect to = Effect::resolution);

// Parts of input_warnings(). Numbers outside their plausible range, and angles given in radians.
void warn_of_ranges(const model::Case& c, std::vector<InputWarning>& out);
// Inconsistent stiffnesses, diameters and strengths of a line type.
void warn_of_proportions(const model::Case& c, std::vector<InputWarning>& out);
// Implausible masses, loads, directions, stiffeners, feeders and targets of lines.
void warn_of_line_loads(const model::Case& c, std::vector<InputWarning>& out);
// Mass, volume, inertia, springs and motions of bodies.
void warn_of_bodies(const model::Case& c, std::vector<InputWarning>& out);
// Inconsistent water, bed, waves and duration.
void warn_of_surroundings(const model::Case& c, std::vector<InputWarning>& out);
// Inconsistent weight, diameter and EA of line types; contents and coatings.
void warn_of_line_types(const model::Case& c, std::vector<InputWarning>& out);
// Strains and tensions implied by loads, weight and the distance of the ends; lengths far beyond that
// distance.
void warn_of_lines(const model::Case& c, std::vector<InputWarning>& out);
// Supports that bend their line beyond the capacity of pipes, and elements too long to resolve roller
// contact.
void warn_of_supports(const model::Case& c, std::vector<InputWarning>& out);
// Masses, loads, links and bodies whose node is elsewhere than in the case, masses that sink into the bed,
// and bend stiffeners with too few elements.
void warn_of_elements(const model::Case& c, std::vector<InputWarning>& out);
// Rotations about space axes where body axes are probably meant.
void warn_of_rotations(const model::Case& c, std::vector<InputWarning>& out);
// Platforms: impossible inertia, currents and waves not covered by the coefficients, hulls without drag and
// added mass.
void warn_of_platforms(const model::Case& c, std::vector<InputWarning>& out);
// A part of it: coefficients of a body that are implausible by themselves, for the body's size or by their
// limits in long waves; they detect other conventions and units.
void warn_of_hydrodynamics(const model::Case& c, const model::Body& b, std::vector<InputWarning>& out);
// Platforms of a farm that overlap.
void warn_of_farms(const model::Case& c, std::vector<InputWarning>& out);
// Water and bed depths, implausible soil, ends far from the bed, and currents that displace lines on the bed
// or would change the waves.
void warn_of_sea(const model::Case& c, std::vector<InputWarning>& out);
// Time steps, output intervals, and motions that begin with a velocity jump.
void warn_of_times(const model::Case& c, std::vector<InputWarning>& out);

// Speeds [m/s] of prescribed motion and drift of each body at t = 0, when its lines are at rest; 0: no
// impact.
struct StartSpeeds {
  double motion = 0, drift = 0;
};
std::vector<StartSpeeds> start_speeds(const model::Case& c);
// Key of the motion of the first body with such a speed; empty: none has one.
std::string initial_velocity_key(const model::Case& c);

// True if height and period of a sea are possible; otherwise consequences are not worth a note.
bool possible(const model::Waves& waves);
// Lower bound of the height z [m] of a line: hanging vertically from one or both ends. -inf: unknown
// position.
double lowest_reach(const model::Case& c, const model::Line& line);
// For an inextensible chain of length L [m] without friction between a point on a level bed and one X [m]
// away and h [m] above: horizontal tension over weight per length [m]. Negative: no part lies on the bed.
double slack_tension(double L, double X, double h);
// Mass per length of a type minus that of displaced water [kg/m], at height z [m] relative to the surface.
double mass_in_water(const model::Case& c, const model::LineType& type, double z);

}  // namespace hawser::advice
