// Notes on waves that are too steep, or beyond their theory.
#include "hawser/advice/waves.hpp"

#include <fmt/format.h>

namespace hawser::advice {

std::string long_for_its_depth(const std::string& key, double ursell, double limit) {
  return fmt::format(
      "{}: the wave is long for its depth: its Ursell number is {:.3g}, and fifth-order theory is valid up "
      "to {:g}",
      key, ursell, limit);
}

std::string current_of_wave(const std::string& key) {
  return key +
         ".current: it acts on lines in addition to 'environment.current', which does not change the wave";
}

std::string sea_breaks(const model::WaveSystem& w, double steepness, double steepest) {
  return fmt::format(
      "{}: waves of a sea of {:g} m at {:g} s would break: its steepness 2 pi hs/(g tp²) is {:.3g}, and seas "
      "of this period get to {:.3g}, {:.3g} m high (DNV-RP-C205)",
      w.key, w.height, w.peak_period, steepness, steepest, w.height * steepest / steepness);
}

std::string wave_breaks(const std::string& key, double height, double length, double highest) {
  return fmt::format("{}: a wave of {:g} m would break: {:.3g} m long, it gets {:.3g} m high (Miche)", key,
                     height, length, highest);
}

}  // namespace hawser::advice
