// Pairs of volumes for contact between bodies, and their stiffness.
#pragma once

#include <cstddef>
#include <vector>

#include "hawser/model/case.hpp"

namespace hawser::model {

// Volume `a` is the slave: its points, edges or faces (by the basis of its stiffness) are tested against the
// surface of `b`.
struct BodyPair {
  std::size_t a = 0, b = 0;
  double stiffness = 0;     // N/m, N/m² or N/m³ by the basis of `a`
  double force_factor = 1;  // of the force: 1/2 if both volumes are slaves with their faces
  Friction friction;        // isotropic
  // True if `b` can penetrate `a` undetected: between corners, edges or balls of `a`.
  bool needs_overlap_check = false;
};

// Pairs of volumes that take part in contact, on different bodies at least one of which has mass. The slave
// is a round volume (sphere, capsule, torus), else one with a stiffness per point, per length, per area, in
// this order. Two volumes of equal order are both slaves, except round volumes, where one is enough. Two
// volumes with the same basis use the lower stiffness. A pair without any stiffness has stiffness 0. Friction
// uses the lowest coefficients of both volumes, axial and lateral, at rest and sliding, and otherwise the law
// of `a`; its blend speed is that of `b` if only `b` has kinetic coefficients.
std::vector<BodyPair> body_pairs(const Case& c);

bool is_ball(const Volume& v);  // a sphere

// Contact of the volumes of a body with those of others; with_friction: friction acts in at least one pair.
enum class ContactOfBody { none, frictionless, with_friction };
ContactOfBody contact_of_body(const Case& c, const std::string& body);

}  // namespace hawser::model
