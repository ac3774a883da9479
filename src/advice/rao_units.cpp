// Check of the units of a response table: periods in s, directions and phases in deg, rotations in deg/m.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "hawser/advice/rao_tables.hpp"

namespace hawser::advice {
namespace {

constexpr double kTurn = 6.3;  // a full turn in rad, rounded

bool is_integer(double x) { return x == std::round(x); }

}  // namespace

std::vector<std::string> odd_rao_units(const std::string& key, const std::vector<std::vector<double>>& rows,
                                       double gravity) {
  std::vector<std::string> out;
  double longest = 0, farthest = 0, latest = 0, farthest_motion = 0, steepest = 0, phase_following = 0,
         fewest_slopes = HUGE_VAL;
  bool broken_direction = false, broken_phase = false;
  std::set<double> directions;
  for (const std::vector<double>& r : rows) {
    longest = std::max(longest, r[0]);
    directions.insert(r[1]);
    farthest = std::max(farthest, std::abs(r[1]));
    broken_direction |= !is_integer(r[1]);
    for (std::size_t k = 2; k < 14; k += 2) {
      if (!(r[k] > 0)) continue;
      latest = std::max(latest, std::abs(r[k + 1]));
      broken_phase |= !is_integer(r[k + 1]);
      if (k < 8) farthest_motion = std::max(farthest_motion, r[k]);
    }
    if (r[0] < 10) continue;
    // deg of slope for 1 m of amplitude, in deep water
    const double slope = 4 * M_PI * M_PI / (gravity * r[0] * r[0]) * 180 / M_PI;
    const double turns = std::max(r[8], r[10]) / slope;
    steepest = std::max(steepest, turns);
    phase_following = std::max(phase_following, r[6]);
    if (turns > 0) fewest_slopes = std::min(fewest_slopes, turns);
  }
  if (longest < 3 && rows.size() > 1)
    out.push_back(
        fmt::format("{}: the longest period is {:g} s: is the first column a frequency?", key, longest));
  if (directions.size() > 1 && broken_direction && farthest < kTurn)
    out.push_back(fmt::format("{}: all directions are within {:g} deg: are they in rad?", key, farthest));
  if (rows.size() > 2 && broken_phase && latest > 0.5 && latest < kTurn)
    out.push_back(fmt::format("{}: all phases are within {:g} deg: are they in rad?", key, latest));
  if (farthest_motion > 20)
    out.push_back(fmt::format("{}: it moves {:g} m for each m of a wave: are translations in m/m?", key,
                              farthest_motion));
  if (steepest > 0 && steepest < 0.05 && phase_following > 0.3)
    out.push_back(fmt::format(
        "{}: in waves of 10 s and more roll and pitch are {:.2g} of the wave's slope at most: are they in "
        "rad/m, not deg/m?",
        key, steepest));
  if (fewest_slopes < HUGE_VAL && fewest_slopes > 30)
    out.push_back(
        fmt::format("{}: in waves of 10 s and more it rolls or pitches {:.3g} times the wave's slope: are "
                    "rotations in deg/m?",
                    key, fewest_slopes));
  return out;
}

}  // namespace hawser::advice
