// Small undamped vibrations about an equilibrium: K phi = omega² M phi, by SLEPc.
#pragma once

#include <vector>

#include "hawser/system/system.hpp"

namespace hawser {

struct NaturalMode {
  double squared = 0;  // rad²/s², omega²; below zero: the equilibrium is unstable in this direction
  // Of each local node (owned and ghosts): the translation, scaled so that the largest is 1, and the rotation
  // [rad] of beams and bodies with it. Of a mode that turns nodes in place (torsion, the yaw of a load) the
  // translations are zero and the largest rotation is 1.
  std::vector<Vec3> shape, rotation;
};

// |omega²| of a direction in which the system moves freely: a period of 10 000 s, far above rounding.
inline constexpr double kFreeMotion = 4e-7;  // rad²/s²

// The `count` modes nearest to rest (fewer where there are no more), ascending, about the state `at`, which
// is at rest; M holds the added mass of the terms. Of tangents that are not symmetric (friction) the
// symmetric part counts. Collective. SolveError where the eigenvalues do not converge.
std::vector<NaturalMode> natural_modes(System& system, const Kinematics& at, int count);

}  // namespace hawser
