// What the checks of a step, or of a trial of statics, find: kind, place and numbers. Terms and solvers
// return them; advice/steps.hpp makes the clauses. place: of a line, "line hose, arc length 12.5 m"
// (Mesh::place).
#pragma once

#include <string>
#include <variant>

#include "hawser/model/contact_properties.hpp"

namespace hawser::advice {

// The largest residual, in N, or N m if it `turns`: Newton's iteration does not converge.
struct Imbalance {
  std::string place;
  double value = 0, scale = 0;  // scale: of the forces or moments that act
  bool turns = false;
  bool finite = true;
};

struct TurnsTooFar {
  std::string place;
  double angle = 0;  // rad, in the step
};

// A beam element whose ends turn against each other by more than half a turn.
struct ElementTurnsOver {
  std::string place;
};

// An impact that the start of the step did not show.
struct ImpactNotResolved {};

struct ErrorTooLarge {
  double error = 0;  // m, local
};

// Lines move farther than the list of candidates covers.
struct BeyondContactSearch {};

struct LinePassesVolume {};
struct BodyPassesBody {};

struct FeedsTooFast {
  std::string feeder;  // "end A of line mooring"
};

// The law of contact with a volume, as the case gives it.
struct VolumeLaw {
  std::string volume;
  model::StiffnessBasis basis = model::StiffnessBasis::per_length;
  double stiffness = 0;    // by basis
  bool table = false;      // of forces
  bool automatic = false;  // the program chooses and raises the stiffness
};

// A line that is deeper in a volume than its law is for.
struct TooDeep {
  VolumeLaw law;
  std::string place;
  double depth = 0, radius = 0;  // m; of the line
  double time = 0;               // s
};

// A line that would be drawn through a volume during the search for an equilibrium. too_soft: by a stiffness
// that the case gives.
struct DrawnThrough {
  VolumeLaw law;
  std::string place;
  bool too_soft = false;
};

// Where two lines are nearest.
struct NearestPlaces {
  std::string one, other;         // lines
  double arc = 0, other_arc = 0;  // m
};
struct LinesPass {
  NearestPlaces at;
};
// They are nearer to each other at the start of the run than their radii allow.
struct LinesStartTooNear {
  NearestPlaces at;
};
struct PressedLines {
  NearestPlaces at;
  double depth = 0, radii = 0;       // m; the sum of both
  double stiffness = 0, wanted = 0;  // N/m per m: it is; it should be, which is rounded up
  double energy = 0;                 // J, in the contact
  bool own_settings = false;         // the case has a stiffness for these two lines
};

// monostate: nothing, or another rank has the finding.
using StepFinding =
    std::variant<std::monostate, Imbalance, TurnsTooFar, ElementTurnsOver, ImpactNotResolved, ErrorTooLarge,
                 BeyondContactSearch, LinePassesVolume, BodyPassesBody, FeedsTooFast, TooDeep, DrawnThrough,
                 LinesPass, LinesStartTooNear, PressedLines>;

}  // namespace hawser::advice
