// Output fields of contact, shared by all contact terms.
#include "hawser/terms/contact_fields.hpp"

#include <algorithm>
#include <utility>

namespace hawser {

void add_contact_fields(FieldRegistry& registry, const ContactFields& shown, const EachPoint& each) {
  const auto add = [&](Field field, int components, const auto& put) {
    if (field.name.empty()) return;
    field.components = components;
    registry.add({std::move(field), [each, put, components](const Kinematics& state, std::span<double> out) {
                    std::fill(out.begin(), out.end(), 0.0);
                    each(state, [&](int node, double weight, const Mat3& axes, const ContactPoint& p) {
                      put(out.data() + components * node, weight, axes, p);
                    });
                  }});
  };
  const auto vector = [](Vec3 ContactPoint::*value) {
    return [value](double* out, double weight, const Mat3& axes, const ContactPoint& p) {
      Eigen::Map<Vec3>(out, 3) += weight * p.weight * (axes * (p.*value));
    };
  };
  add(shown.force, 3, vector(&ContactPoint::force));
  add(shown.normal_force, 1, [](double* out, double weight, const Mat3&, const ContactPoint& p) {
    *out += weight * p.weight * p.normal_force;
  });
  add(shown.friction, 3, vector(&ContactPoint::friction));
  add(shown.penetration, 1, [](double* out, double weight, const Mat3&, const ContactPoint& p) {
    if (weight >= 0.5) *out = std::max(*out, -p.gap);
  });
}

}  // namespace hawser
