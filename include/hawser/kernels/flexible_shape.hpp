// Rest shape of a perfectly flexible line of any make-up on a bed and through the water's surface, to start
// statics from: touchdown in the middle, waves in the line, buoys, floating ends.
//
// Tension-only elements under dead loads, a bed that only presses and buoyancy that only fades upwards make a
// potential energy that is convex in the nodes' places. So there is one least energy, and Newton with a line
// search comes to it from any start: no false equilibria, no loops that are caught.
#pragma once

#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct FlexibleLine {
  struct Piece {               // between two nodes
    double length = 0;         // m, unstretched
    double EA = 0;             // N
    Vec3 load = Vec3::Zero();  // N/m, weight and what else is dead
    double buoyancy = 0;       // N/m, when it is under water
    double radius = 0;         // m
  };
  struct Point {               // at a node
    Vec3 load = Vec3::Zero();  // N
    double buoyancy = 0;       // N, when it is under water
  };
  std::vector<Piece> pieces;
  std::vector<Point> points;  // one more than pieces
  bool held_a = true, held_b = true;
  bool bed = false;
  Vec3 bed_point = Vec3::Zero(), bed_normal = Vec3::UnitZ();
  double bed_stiffness = 0;  // N/m², per length of line
  bool water = false;
  double surface = 0;  // m
};

// Places of the nodes, m; `start` has one a node, and held ends stay where it has them. The line may be more
// elastic and the bed softer than asked for, where that moves it by less than a start shape matters.
std::vector<Vec3> flexible_shape(const FlexibleLine& line, std::vector<Vec3> start);

// x(s) of places at increasing arc lengths: Hermite's cubic between neighbours, with the slopes of the
// chords.
Vec3 interpolated(const std::vector<double>& s, const std::vector<Vec3>& x, double at);

}  // namespace hawser
