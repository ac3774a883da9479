// Node fields that are components of the section force: their indices and their values at one side of a node.
#pragma once

#include <array>
#include <span>

#include "hawser/record/end_forces.hpp"
#include "hawser/system/field.hpp"

namespace hawser::record {

struct SectionFields {
  // Indices among the fields of the results; -1: missing.
  int tension = -1, before = -1, after = -1;  // before, after: tensions on both sides of a node
  int wall = -1, declination = -1;
  int shear = -1, torsion = -1, moment = -1, moment_2 = -1, moment_3 = -1;  // of beams

  static SectionFields find(std::span<const Field> fields);
  std::array<int, 5> of_beams() const { return {shear, torsion, moment_2, moment_3, moment}; }
  // Value of one of of_beams(), N or N m, at a node whose rotation is q.
  double value(int field, const SectionForce& s, const Quat& q) const;
};

}  // namespace hawser::record
