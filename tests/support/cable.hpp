// A single cable element: its force, and its tangents for comparison with finite differences.
#pragma once

#include "hawser/kernels/cable.hpp"

namespace hawser::test {

struct CableState {
  Vec3 x1, x2;                                // m
  Vec3 v1 = Vec3::Zero(), v2 = Vec3::Zero();  // m/s
  operator CableEnds() const { return {x1, x2, v1, v2}; }
};

using CableEndForces = Eigen::Matrix<double, 6, 1>;  // on (x1, x2)
using CableMatrix = Eigen::Matrix<double, 6, 6>;

inline CableEndForces cable_end_forces(const CableSection& s, const CableState& e) {
  const Vec3 pull = cable_force(s, e);
  CableEndForces f;
  f << -pull, pull;
  return f;
}

// Force, and its derivatives with respect to positions and velocities.
inline CableEndForces cable_tangent(const CableSection& s, const CableState& e, CableMatrix& K,
                                    CableMatrix& C) {
  CableForce o;
  cable_force(s, e, 0, o);
  K << o.k, -o.k, -o.k, o.k;
  C << o.c, -o.c, -o.c, o.c;
  CableEndForces f;
  f << -o.force, o.force;
  return f;
}

}  // namespace hawser::test
