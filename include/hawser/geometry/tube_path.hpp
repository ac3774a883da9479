// Axis of a tube: straight legs joined by circular arcs that are tangent to both.
#pragma once

#include <optional>
#include <vector>

#include "hawser/geometry/primitive_shape.hpp"

namespace hawser {

// The bend at a corner of the path.
struct TubeBend {
  double turn = 0;     // rad, from the direction before the corner to that after it
  double radius = 0;   // m
  double tangent = 0;  // m, from the corner to either end of the arc: radius tan(turn / 2)
};
// One bend per inner point of the path. Needs one radius, or as many as there are inner points.
std::vector<TubeBend> tube_bends(const TubeShape& shape);

// A leg or an arc, m.
struct TubePiece {
  Vec3 from = Vec3::Zero(), direction = Vec3::UnitX();  // start, unit tangent there
  double length = 0;                                    // along the axis
  double radius = 0;                                    // of an arc; 0: a leg
  Vec3 inward = Vec3::Zero();                           // unit, from the start of an arc to its centre

  bool arc() const { return radius > 0; }
  Vec3 centre() const { return from + radius * inward; }
  Vec3 axis() const { return direction.cross(inward); }  // the arc turns about it by the right-hand rule
  double turn() const { return arc() ? length / radius : 0; }
  Vec3 point(double s) const;
  Vec3 tangent(double s) const;
};
// Throws std::invalid_argument with a message if points coincide, radii are missing, or a leg is shorter than
// its bends need.
std::vector<TubePiece> tube_pieces(const TubeShape& shape);

// Two places of the axis at which the outside of the tube touches itself: lengths along the axis and the
// distance, m.
struct TubeTouch {
  double first = 0, second = 0, distance = 0;
};
// The first found; none if the tube keeps clear of itself. See docs/theory/geometry.md.
std::optional<TubeTouch> tube_touches_itself(const TubeShape& shape);

}  // namespace hawser
