// Degrees of freedom that one of the files of a platform has and the other lacks.
#pragma once

#include <optional>
#include <string>

#include "hawser/model/case.hpp"

namespace hawser::model {

// A degree of freedom, from 0, with wave forces but without added mass and damping (in_radiation), or with
// added mass but without wave forces.
struct MissingFreedom {
  int freedom = 0;
  bool in_radiation = false;
  // Without a force in surge, sway or heave the files are certainly wrong: a wave accelerates the water.
  bool is_refused() const { return !in_radiation && freedom < 3; }
};
// The first of a body with wave forces; refused ones precede others.
std::optional<MissingFreedom> missing_freedom(const Case& c, const Body& b);
// A sentence about it.
std::string text_of(const MissingFreedom& missing, const BodyHydrodynamics& h);

}  // namespace hawser::model
