// Output of contact at nodes, for all kinds of contact: the force at each contact point is divided among the
// nodes of its element.
#pragma once

#include <functional>

#include "hawser/kernels/contact_point.hpp"
#include "hawser/system/field_registry.hpp"

namespace hawser {

// A point at an owned node, with its share of it. axes: from those of the point to space, and with the sign
// turned on what is touched.
using ShowPoint = std::function<void(int node, double share, const Mat3& axes, const ContactPoint& p)>;
using EachPoint = std::function<void(const Kinematics& at, const ShowPoint& show)>;

// The fields but for their components; one without a name is not shown.
struct ContactFields {
  Field force = {}, normal_force = {}, friction = {}, penetration = {};
};

// Adds force and friction [N, space axes], sum of the sizes of normal forces [N], and largest penetration of
// points that are nearer to the node than to others [m].
void add_contact_fields(FieldRegistry& registry, const ContactFields& shown, const EachPoint& each);

}  // namespace hawser
