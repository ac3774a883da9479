// Findings of the checks of a time step or a static trial: kind, place and numbers. Terms and solvers return
// them; advice/steps.hpp turns them into clauses. place: on a line, "line hose, arc length 12.5 m"
// (Mesh::place).
#pragma once

#include <string>
#include <variant>

#include "hawser/model/contact_properties.hpp"

namespace hawser::advice {

// Newton's iteration does not converge: the largest residual, in N, or N m if `turns`.
struct Imbalance {
  std::string place;
  double value = 0, scale = 0;  // scale: applied forces or moments
  bool turns = false;
  bool finite = true;
};

struct TurnsTooFar {
  std::string place;
  double angle = 0;  // rad, in one step
};

// A beam element whose ends are rotated against each other by more than half a turn.
struct ElementTurnsOver {
  std::string place;
};

// An impact within the step that the step is too long to resolve.
struct ImpactNotResolved {};

struct ErrorTooLarge {
  double error = 0;  // m, local
};

// Lines move farther than the list of contact candidates covers.
struct BeyondContactSearch {};

struct LinePassesVolume {
  std::string place, volume;
};
struct BodyPassesBody {
  std::string volume, other;  // with their bodies
};

// A body past the middle of another one, from where contact pushes it out on the far side.
struct BodyPressedThrough {
  std::string volume, other;        // with their bodies
  double depth = 0, thickness = 0;  // m; of the other there
  model::StiffnessBasis basis = model::StiffnessBasis::per_area;
  double stiffness = 0, required = 0;  // by basis: current value, and one that would hold
  bool table = false;                  // law by force table
  bool both = false;                   // the lower stiffness of the two volumes counts
};

struct FeedsTooFast {
  std::string feeder;  // "end A of line mooring"
};

// Contact law of a volume in the case.
struct VolumeLaw {
  std::string volume;
  model::StiffnessBasis basis = model::StiffnessBasis::per_length;
  double stiffness = 0;    // by basis
  bool table = false;      // law by force table
  bool automatic = false;  // the program chooses and raises the stiffness
};

// A line deeper in a volume than the range of its contact law.
struct TooDeep {
  VolumeLaw law;
  std::string place;
  double depth = 0, radius = 0;  // m; radius of the line
  double time = 0;               // s
};

// A line would pass through a volume during the search for an equilibrium. too_soft: because of a stiffness
// given in the case.
struct PulledThrough {
  VolumeLaw law;
  std::string place;
  bool too_soft = false;
};

// Nearest points of two lines.
struct NearestPlaces {
  std::string one, other;         // lines
  double arc = 0, other_arc = 0;  // m
};
struct LinesPass {
  NearestPlaces at;
};
// The lines are closer at the start of the run than their radii allow.
struct LinesStartTooNear {
  NearestPlaces at;
};
struct PressedLines {
  NearestPlaces at;
  double depth = 0, radii = 0;         // m; sum of both radii
  double stiffness = 0, required = 0;  // N/m per m: current and required value; the latter is rounded up
  double energy = 0;                   // J, in the contact
  bool given = false;                  // the case gives a stiffness for this pair
};

// monostate: no finding, or another rank has it.
using StepFinding =
    std::variant<std::monostate, Imbalance, TurnsTooFar, ElementTurnsOver, ImpactNotResolved, ErrorTooLarge,
                 BeyondContactSearch, LinePassesVolume, BodyPassesBody, BodyPressedThrough, FeedsTooFast,
                 TooDeep, PulledThrough, LinesPass, LinesStartTooNear, PressedLines>;

}  // namespace hawser::advice
