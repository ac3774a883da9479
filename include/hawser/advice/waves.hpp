// Notes on waves that are too steep, or beyond their theory. key: of the wave system.
#pragma once

#include <string>

#include "hawser/model/environment.hpp"

namespace hawser::advice {

// Ursell number of a Stokes wave, and the limit of fifth-order theory.
std::string long_for_its_depth(const std::string& key, double ursell, double limit);
// `current` of a Stokes wave, in a sea with a current.
std::string current_of_wave(const std::string& key);
// A spectrum with steepness 2 pi Hs/(g Tp²), and the largest one of seas with this period.
std::string sea_breaks(const model::WaveSystem& w, double steepness, double steepest);
// m: height and length of a linear wave, and the height that it can have.
std::string wave_breaks(const std::string& key, double height, double length, double highest);

}  // namespace hawser::advice
