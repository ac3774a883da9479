// Stiffness basis and friction of contact with volumes and the seabed.
#pragma once

#include "hawser/kernels/friction_law.hpp"

namespace hawser::model {

enum class StiffnessBasis { automatic, per_point, per_length, per_area };

struct Friction {
  double axial = 0, lateral = 0;           // Coulomb coefficients, static
  double mobilisation_length = 0;          // m, axial; 0: default of 1 % of the contact diameter
  double shear_stiffness = 0;              // same basis as the normal stiffness; 0: use mobilisation_length
  double lateral_mobilisation_length = 0;  // m; 0: equal to the axial one
  double axial_kinetic = 0, lateral_kinetic = 0;  // coefficients at high sliding speed
  double blend_speed = 0;                         // m/s; 0: always the static coefficients
  FrictionReturn return_rule = FrictionReturn::radial;
  FrictionSpring spring = FrictionSpring::elliptic;
};

}  // namespace hawser::model
