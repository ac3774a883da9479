// The place of one change of contact between a line and the bed, from the gaps of the nodes on both sides.
#pragma once

#include <array>

#include "hawser/state/kinematics.hpp"

namespace hawser::record {

// Of a node. value: of the axis above the height at which the bed's force begins, m. slope: of the gap by arc
// length, of a beam. x: of the node, m.
struct Gap {
  double value = 0, slope = 0;
  Vec3 x = Vec3::Zero();
};

inline bool lies(double gap) { return gap <= 0; }

// Arc length beyond the node that lies, m, where the straight line between two gaps is zero.
inline double zero_of_line(double lying, double hanging, double length) {
  return length * lying / (lying - hanging);
}

// The nodes beside a change of contact, in the direction from what lies to what hangs: two that lie, three
// that hang.
struct NodesAtChange {
  static constexpr int kNodes = 5;
  std::array<Gap, kNodes> gap;
  std::array<double, kNodes> arc;                     // m, growing in that direction
  std::array<bool, kNodes> exists, inner, two_sided;  // on the line; no end of it; of two types
};

// Arc length beyond the last node that lies, m (negative: before it), at which the line leaves the bed. beam:
// of its element there. Docs: theory/seabed.md, "Touchdown points".
double distance_to_touchdown(const NodesAtChange& n, bool beam);
// Place on the chords, m, at that distance.
Vec3 position_at(const NodesAtChange& n, double distance);

}  // namespace hawser::record
