// Place of a change of contact between a line and the bed, from the gaps of nearby nodes.
#pragma once

#include <array>

#include "hawser/state/kinematics.hpp"

namespace hawser::record {

// State of a node. value: height of the axis above that at which the bed force begins, m; slope: derivative
// of the gap by arc length, for beams; x: position, m.
struct Gap {
  double value = 0, slope = 0;
  Vec3 x = Vec3::Zero();
};

inline bool lies(double gap) { return gap <= 0; }

// Length on the bed beyond the node that lies, m: zero of the linear gap between two nodes.
inline double zero_of_line(double lying, double hanging, double length) {
  return length * lying / (lying - hanging);
}

// Nodes beside a change of contact, ordered from lying to hanging: two on the bed, three above it.
struct NodesAtChange {
  static constexpr int kNodes = 5;
  std::array<Gap, kNodes> gap;
  std::array<double, kNodes> arc;                     // m, increasing in that direction
  std::array<bool, kNodes> exists, inner, two_sided;  // on the line; not at its end; between two types
};

// Arc length beyond the last lying node, m (negative: before it), at which the line leaves the bed. beam:
// type of the element there. See docs/theory/seabed.md, "Touchdown points".
double distance_to_touchdown(const NodesAtChange& n, bool beam);
// Point on the chords at that distance, m.
Vec3 position_at(const NodesAtChange& n, double distance);

}  // namespace hawser::record
