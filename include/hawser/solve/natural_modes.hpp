// Small vibrations about an equilibrium: K phi = omega² M phi, by SLEPc; where M depends on the frequency
// (platforms), that of the mode itself.
#pragma once

#include <vector>

#include "hawser/system/system.hpp"

namespace hawser {

struct NaturalMode {
  double squared = 0;  // rad²/s², omega²; below zero: the equilibrium is unstable in this direction
  // phi . C phi/(2 omega phi . M phi) with the linear damping at rest; 0 where no term depends on the
  // frequency.
  double damping_ratio = 0;
  // Of each local node (owned and ghosts): the translation, scaled so that the largest is 1, and the rotation
  // [rad] of beams and bodies with it. Of a mode that turns nodes in place (torsion, the yaw of a load) the
  // translations are zero and the largest rotation is 1.
  std::vector<Vec3> shape, rotation;
};

// |omega²| of a direction in which the system moves freely: a period of 10 000 s, far above rounding.
inline constexpr double kFreeMotion = 4e-7;  // rad²/s²

// The `count` modes nearest to rest (fewer where there are no more), ascending, about the state `at`, which
// is at rest; M holds the added mass of the terms, of those that depend on the frequency that of each mode
// (fixed point; of free and unstable ones that of time integration). Of tangents that are not symmetric
// (friction) the symmetric part counts. Collective. SolveError where the eigenvalues do not converge.
std::vector<NaturalMode> natural_modes(System& system, const Kinematics& at, int count);

}  // namespace hawser
