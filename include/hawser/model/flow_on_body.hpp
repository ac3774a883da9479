// Wind or current forces on a floating body from tables of coefficients.
#pragma once

#include <string>

#include "hawser/kernels/body_flow.hpp"

namespace hawser::model {

struct Body;
struct Case;

struct FlowOnBody {
  FlowCoefficients coefficients;
  int rows = 0;            // number of rows in the file
  bool mirrored = false;   // the other side is mirrored from the given one
  bool by_origin = false;  // file angles are where the flow comes from; the coefficients are converted
  double frontal = 0, lateral = 0;  // m²
  double length = 0, draught = 0;   // m; current: 0 if areas are given
  Vec3 at = Vec3::Zero();           // m, body frame: point of the forces and velocities
  double height = 10;               // m above the still water, reference height of wind coefficients
};

// Lines on loads, wind and current on a floating body that `hawser check` prints.
std::string flow_text(const Case& c, const Body& b);

}  // namespace hawser::model
