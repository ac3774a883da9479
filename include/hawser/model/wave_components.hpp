// The waves of a case as components.
#pragma once

#include "hawser/kernels/waves.hpp"
#include "hawser/model/case.hpp"

namespace hawser::model {

// Empty without waves. The same on every rank.
WaveField wave_field(const Environment& e);

}  // namespace hawser::model
