// Wind or current on a floating body by a table of coefficients.
#pragma once

#include <string>

#include "hawser/kernels/body_flow.hpp"

namespace hawser::model {

struct Body;
struct Case;

struct FlowOnBody {
  FlowCoefficients coefficients;
  int rows = 0;            // that the file has
  bool mirrored = false;   // those of the other side are made of them
  bool by_origin = false;  // its angles are where the flow comes from; the coefficients have been turned
  double frontal = 0, lateral = 0;  // m²
  double length = 0, draught = 0;   // m; a current: 0, areas are given
  Vec3 at = Vec3::Zero();           // m, body frame: where the forces act and velocities count
  double height = 10;               // m above the still water, of the wind of the coefficients
};

// What `hawser check` says of loads, wind and current on a floating body, in lines.
std::string flow_text(const Case& c, const Body& b);

}  // namespace hawser::model
