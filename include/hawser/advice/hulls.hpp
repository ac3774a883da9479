// Sentences about hulls that displace water by their volumes: what is refused, and the hydrostatics that
// `hawser check` prints.
#pragma once

#include <string>

#include "hawser/model/case.hpp"

namespace hawser::advice {

// A surface whose volume depends on the axis along which it is integrated [m³].
std::string hull_is_open(const Vec3& volumes);
// A body that its buoyancy cannot carry: kg of water that the hull displaces wholly wet, and of the body.
std::string hull_cannot_float(double displaced, double mass);

// A hull where the case puts it.
struct HullAtStart {
  std::string body;
  size_t triangles = 0;
  double displaced = 0, whole = 0;           // m³, of the wetted part and of all
  double buoyancy = 0, weight = 0;           // N
  double waterplane = 0;                     // m²
  double roll_height = 0, pitch_height = 0;  // m, metacentric; of no meaning without buoyancy
  double rise = 0;                           // m, to where buoyancy alone carries the weight
  std::string held_by = {};                  // "lines" or "springs"; empty: nothing holds it
};
// In lines. A warning where the body would float elsewhere and nothing holds it, a note where something does;
// a warning where a metacentric height is negative.
std::string hull_at_start(const HullAtStart& hull);

// Of a body that statics moves up by so much [m]: weight, buoyancy and the pull of lines do not balance where
// the case puts it. Empty: by 0.1 m at most.
std::string rests_elsewhere(const std::string& body, double rise);

}  // namespace hawser::advice
