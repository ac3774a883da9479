// The struct SectionFields: names of the fields, and components of a section force.
#include "hawser/record/section_fields.hpp"

namespace hawser::record {

SectionFields SectionFields::find(std::span<const Field> fields) {
  const auto index = [fields](const char* name) { return find_field(fields, name); };
  return {.tension = index("effective_tension"),
          .before = index("effective_tension_before"),
          .after = index("effective_tension_after"),
          .wall = index("wall_tension"),
          .declination = index("declination"),
          .shear = index("shear_force"),
          .torsion = index("torsion_moment"),
          .moment = index("bending_moment"),
          .moment_2 = index("bending_moment_2"),
          .moment_3 = index("bending_moment_3")};
}

double SectionFields::value(int field, const SectionForce& s, const Quat& q) const {
  if (field == shear) return s.shear();
  if (field == torsion) return s.moment.dot(q * Vec3::UnitX());
  if (field == moment_2) return s.moment.dot(q * Vec3::UnitY());
  if (field == moment_3) return s.moment.dot(q * Vec3::UnitZ());
  return s.moment.cross(q * Vec3::UnitX()).norm();
}

}  // namespace hawser::record
