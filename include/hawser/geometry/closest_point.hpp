// Closest points of simple shapes to a point, with the feature on which they lie.
//
// closest_point_on_triangle is accurate to a few units of rounding of max(|p - a|, edge lengths), also
// for needles, caps and triangles collapsed to a segment or a point; the nearest face/edge/vertex
// classification follows Ericson (2005), "Real-Time Collision Detection", section 5.1.5.
// Segment-segment is in segment_distance.hpp.
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

// Feature of a triangle (v0, v1, v2) on which a point lies. Edge i joins v_i and v_(i+1 mod 3).
enum class Feature : unsigned char { face, edge0, edge1, edge2, vertex0, vertex1, vertex2 };

inline bool is_edge(Feature f) { return f >= Feature::edge0 && f <= Feature::edge2; }
inline bool is_vertex(Feature f) { return f >= Feature::vertex0; }
// i of edge i or vertex i; 0 for the face.
inline int feature_index(Feature f) {
  const int i = static_cast<int>(f);
  return i == 0 ? 0 : (i - 1) % 3;
}
inline Feature edge_feature(int i) { return static_cast<Feature>(1 + i); }
inline Feature vertex_feature(int i) { return static_cast<Feature>(4 + i); }

struct ClosestPoint {
  Vec3 point = Vec3::Zero();    // m
  double squared_distance = 0;  // m²
  Feature feature = Feature::face;
};

// Nearest point of segment a-b to p; feature is vertex0, vertex1 or edge0. a = b is allowed.
ClosestPoint closest_point_on_segment(const Vec3& p, const Vec3& a, const Vec3& b);

// Nearest point of triangle a-b-c to p, robust; degenerate triangles are segments or points.
ClosestPoint closest_point_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

// Unit normal by the right-hand rule, to rounding also for very flat triangles; zero when the height
// over the longest edge is below 1e-12 of that edge.
Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace hawser
