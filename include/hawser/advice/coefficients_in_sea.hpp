// Notes on coefficients of a floating body that do not cover the sea of the case, and the refusals of a sea
// that is mostly beyond them. The caller adds the key of a refusal; key: of the body's `hydrodynamics`.
#pragma once

#include <string>

#include "hawser/advice/beyond_periods.hpp"
#include "hawser/kernels/platform_waves.hpp"
#include "hawser/model/platform.hpp"

namespace hawser::advice {

// Waves in directions without rows. quantity: "wave forces", "drift forces".
std::string directions_not_covered(const std::string& key, const char* quantity, const WaveForceTable& table,
                                   const model::Coverage& coverage);
std::string directions_missing(const char* quantity, const WaveForceTable& table,
                               const model::Coverage& coverage);
// Waves of shorter or longer periods than the last one [s] of the files; energy: their fraction.
std::string periods_not_covered(const std::string& key, const char* quantity, double energy,
                                BeyondPeriods beyond, double last);
std::string periods_missing(const char* quantity, double energy, BeyondPeriods beyond, double last);

// direction: rad, relative to the bow.
std::string one_direction_of_difference_forces(const std::string& key, double direction);
std::string negative_drift_damping(const std::string& key);

}  // namespace hawser::advice
