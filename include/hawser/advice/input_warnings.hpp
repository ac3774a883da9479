// What a case may be meant to say and more often is a slip of the pen: a wrong unit, a lost digit, a wrong
// sign. Nothing here stops a run.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// How much of the results what was found can change: all of them, as a wrong unit does; those of a part or of
// the start of a run; or how well they are resolved.
enum class Effect { all, part, resolution };

struct InputWarning {
  std::string key;    // dotted, as in the file
  std::string text;   // what was found there, and what is usual
  std::string group;  // only the first few of a group are reported
  Effect effect = Effect::all;
};

// Its group are the warnings of the same sentence.
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
// "file:line: key: text" each, those with the largest effect first; of many of one kind the first three, and
// how many more there are. Only those with an effect from the first to the second.
std::vector<std::string> input_notes(const model::Case& c, Effect from = Effect::all,
                                     Effect to = Effect::resolution);

// Its parts. Numbers outside of the range of what they can be, and angles that are written in radians.
void warn_of_ranges(const model::Case& c, std::vector<InputWarning>& out);
// Stiffnesses, diameters and strengths of a line type that do not fit each other.
void warn_of_proportions(const model::Case& c, std::vector<InputWarning>& out);
// Masses, loads, directions, stiffeners, feeders and targets of lines that cannot be meant.
void warn_of_line_loads(const model::Case& c, std::vector<InputWarning>& out);
// Mass, volume, inertia, springs and motions of bodies.
void warn_of_bodies(const model::Case& c, std::vector<InputWarning>& out);
// Water, bed, waves and the time of the run that do not fit each other.
void warn_of_surroundings(const model::Case& c, std::vector<InputWarning>& out);
// Weight, diameter and EA of each line type that do not fit each other, contents and coatings.
void warn_of_line_types(const model::Case& c, std::vector<InputWarning>& out);
// Strains and tensions that loads, weight and the distance of the ends mean, and lengths far beyond that
// distance.
void warn_of_lines(const model::Case& c, std::vector<InputWarning>& out);
// Supports that bend their line more than pipes bear, and elements too long to show what rollers do to it.
void warn_of_supports(const model::Case& c, std::vector<InputWarning>& out);
// Masses, loads, links and bodies that nodes have elsewhere than the case, masses that sink into the bed, and
// bend stiffeners of too few elements.
void warn_of_elements(const model::Case& c, std::vector<InputWarning>& out);
// Rotations about axes of space that are other axes of the body.
void warn_of_rotations(const model::Case& c, std::vector<InputWarning>& out);
// Of platforms: inertia that no body has, currents and waves that their coefficients do not contain, hulls
// without drag and added mass.
void warn_of_platforms(const model::Case& c, std::vector<InputWarning>& out);
// Depths of water and bed, soil that is none, ends far from the bed, and currents that push aside what lies
// on it or that would change the waves.
void warn_of_sea(const model::Case& c, std::vector<InputWarning>& out);
// Time steps, times between outputs, and motions that begin with a jump of velocity.
void warn_of_times(const model::Case& c, std::vector<InputWarning>& out);

// m/s with which the prescribed motion and the drift of each body begin at t = 0, where its lines are at
// rest; 0: no impact on them.
struct StartSpeeds {
  double motion = 0, drift = 0;
};
std::vector<StartSpeeds> start_speeds(const model::Case& c);

// Whether height and period of a sea are such as there are: what follows from others is not worth a note.
bool possible(const model::Waves& waves);
// z [m] below which no point of a line can be: hanging straight down, held at one end or both. -inf: nothing
// says where it is.
double lowest_reach(const model::Case& c, const model::Line& line);
// Of an inextensible chain of length L [m] without friction between a point of a level bed and one X m away
// and h m above it: tension where it lies over weight per length [m]. Negative: none of it lies.
double slack_tension(double L, double X, double h);
// kg/m of a type less the water that it displaces, at a height z [m] below the surface; above it all.
double mass_in_water(const model::Case& c, const model::LineType& type, double z);

}  // namespace hawser::advice
