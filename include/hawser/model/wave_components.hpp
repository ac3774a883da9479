// The waves of a case as components.
#pragma once

#include "hawser/kernels/stokes_wave.hpp"
#include "hawser/model/case.hpp"

namespace hawser::model {

// What Stokes' wave of a case is made from (Waves::Kind::stokes).
StokesInput stokes_input(const Environment& e);

// Empty without waves. The same on every rank. std::invalid_argument for a Stokes' wave that cannot be, which
// the case reader has refused before.
WaveField wave_field(const Environment& e);

}  // namespace hawser::model
