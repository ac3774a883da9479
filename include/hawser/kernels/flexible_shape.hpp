// Rest shape of a perfectly flexible line of any composition on a bed and through the water surface, as the
// start of statics: touchdown in the middle, wave configurations, buoys, floating ends.
//
// Tension-only elements under dead loads, a bed that only pushes and buoyancy that decreases only upwards
// have a potential energy that is convex in the node positions. The minimum is therefore unique, and Newton's
// method with a line search reaches it from any start, without false equilibria or trapped loops.
#pragma once

#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct FlexibleLine {
  struct Segment {             // between two nodes
    double length = 0;         // m, unstretched
    double EA = 0;             // N
    Vec3 load = Vec3::Zero();  // N/m, weight and other dead loads
    double buoyancy = 0;       // N/m, when under water
    double radius = 0;         // m
  };
  struct Point {               // at a node
    Vec3 load = Vec3::Zero();  // N
    double buoyancy = 0;       // N, when under water
  };
  std::vector<Segment> pieces;
  std::vector<Point> points;  // one more than pieces
  bool held_a = true, held_b = true;
  bool bed = false;
  Vec3 bed_point = Vec3::Zero(), bed_normal = Vec3::UnitZ();
  double bed_stiffness = 0;  // N/m², per length of line
  bool water = false;
  double surface = 0;  // m
};

// Node positions, m; `start` has one per node, and held ends remain there. The line may be more elastic and
// the bed softer than given, where the effect on the shape is irrelevant for a start shape.
std::vector<Vec3> flexible_shape(const FlexibleLine& line, std::vector<Vec3> start);

// Interpolates positions x at increasing arc lengths s: Hermite's cubic between neighbours, with the slopes
// of the chords.
Vec3 interpolated(const std::vector<double>& s, const std::vector<Vec3>& x, double at);

}  // namespace hawser
