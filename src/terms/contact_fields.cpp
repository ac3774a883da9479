// The output fields of contact, for all terms that have some.
#include "hawser/terms/contact_fields.hpp"

#include <algorithm>

namespace hawser {

void add_contact_fields(FieldRegistry& registry, const ContactFields& names, const EachPoint& each) {
  const auto add = [&](const std::string& name, const char* unit, int components, const auto& put) {
    if (name.empty()) return;
    registry.add(
        {name, unit, components, [each, put, components](const Kinematics& at, std::span<double> out) {
           std::fill(out.begin(), out.end(), 0.0);
           each(at, [&](int node, double share, const Mat3& axes, const ContactPoint& p) {
             put(out.data() + components * node, share, axes, p);
           });
         }});
  };
  const auto vector = [](Vec3 ContactPoint::*value) {
    return [value](double* out, double share, const Mat3& axes, const ContactPoint& p) {
      Eigen::Map<Vec3>(out, 3) += share * p.weight * (axes * (p.*value));
    };
  };
  add(names.force, "N", 3, vector(&ContactPoint::force));
  add(names.normal_force, "N", 1, [](double* out, double share, const Mat3&, const ContactPoint& p) {
    *out += share * p.weight * p.normal_force;
  });
  add(names.friction, "N", 3, vector(&ContactPoint::friction));
  add(names.penetration, "m", 1, [](double* out, double share, const Mat3&, const ContactPoint& p) {
    if (share >= 0.5) *out = std::max(*out, -p.gap);
  });
}

}  // namespace hawser
