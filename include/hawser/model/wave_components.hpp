// Wave field of a case.
#pragma once

#include "hawser/kernels/stokes_wave.hpp"
#include "hawser/model/case.hpp"

namespace hawser::model {

// Input of the Stokes wave of a case (WaveSystem::Kind::stokes).
StokesInput stokes_input(const Environment& e);

// Empty without waves; equal on all ranks. Throws std::invalid_argument for a Stokes wave that does not
// exist; the case reader refuses it before.
WaveField wave_field(const Environment& e);

}  // namespace hawser::model
