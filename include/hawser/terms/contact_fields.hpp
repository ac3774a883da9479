// Output fields of contact at nodes, for all kinds of contact. The force at each contact point is divided
// among the nodes of its element.
#pragma once

#include <functional>

#include "hawser/kernels/contact_point.hpp"
#include "hawser/math/function_ref.hpp"
#include "hawser/system/field_registry.hpp"

namespace hawser {

// Receives a contact point for an owned node with the node's share of it. axes: rotation from the axes of the
// point to space axes; negative for the reaction on the touched line.
using ShowPoint = FunctionRef<void(int node, double weight, const Mat3& axes, const ContactPoint& p)>;
using EachPoint = std::function<void(const Kinematics& state, ShowPoint show)>;

// Descriptions of the output fields without their components; a field without a name is not output.
struct ContactFields {
  Field force = {}, normal_force = {}, friction = {}, penetration = {};
};

// Adds force and friction [N, space axes], the sum of the magnitudes of the normal forces [N], and the
// largest penetration of the points that are nearest to the node [m].
void add_contact_fields(FieldRegistry& registry, const ContactFields& shown, const EachPoint& each);

}  // namespace hawser
