// Small vibrations about an equilibrium: K phi = omega² M phi, by SLEPc. If M depends on the frequency
// (platforms), it is that at the frequency of the mode.
#pragma once

#include <vector>

#include "hawser/system/system.hpp"

namespace hawser {

struct NaturalMode {
  double squared = 0;  // rad²/s², omega²; below zero: the equilibrium is unstable in this direction
  // phi . C phi/(2 omega phi . M phi) with the linear damping at rest; 0 if no term depends on the frequency.
  double damping_ratio = 0;
  // For each local node (owned and ghosts): the translation, scaled so that the largest is 1, and the
  // rotation [rad] of beams and bodies with the same scale. In a mode that rotates nodes without translation
  // (torsion, yaw of a load) the translations are zero and the largest rotation is 1.
  std::vector<Vec3> shape, rotation;
};

// Largest |omega²| of a free mode: that of a period of 10 000 s, far above rounding.
inline constexpr double kFreeMotion = 4e-7;  // rad²/s²

// The `count` lowest modes (fewer if there are no more), ascending, about `state`, which is at rest. M
// includes the added mass of the terms. If it depends on the frequency, it is that of each mode (fixed
// point); free and unstable modes have that of time integration. Of unsymmetric tangents (friction) only the
// symmetric part counts, except in the unknowns of bodies. If K is not symmetric, the squares may
// be complex; their real part is given. Collective. Throws SolveError if the eigenvalues do not converge.
std::vector<NaturalMode> natural_modes(System& system, const Kinematics& state, int count);

}  // namespace hawser
