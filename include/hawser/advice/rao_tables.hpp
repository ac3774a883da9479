// Notes on tables of response amplitude operators. key: "bodies.NAME.motion.rao".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hawser/advice/beyond_periods.hpp"
#include "hawser/kernels/rao.hpp"

namespace hawser::advice {

// Columns of a table [period, direction, six amplitudes each with its phase] that seem to be in other units,
// one sentence each; gravity [m/s²]. In long waves every vessel follows the elevation and slope of the waves.
std::vector<std::string> odd_rao_units(const std::string& key, const std::vector<std::vector<double>>& rows,
                                       double gravity);
// Responses to the longest waves whose phases or amplitudes are those of another convention, one sentence
// each; rows: as given, before those of the other side are added.
std::vector<std::string> odd_in_long_waves(const std::string& key, const std::vector<RaoTable::Row>& rows,
                                           double gravity);

// Waves, the first of them to `direction` [rad, relative to the bow], between distant directions of the
// table.
std::string sea_in_direction_gap(const std::string& key, size_t waves, double direction,
                                 const DirectionGap& gap);
// The table has one direction [rad]; waves are up to `furthest` [rad] away from it.
std::string only_one_direction(const std::string& key, double direction, double furthest);
// Waves with this fraction of the energy, to the period `farthest` [s], are shorter or longer than the last
// period of the table [s].
std::string sea_beyond_responses(const std::string& key, double energy, BeyondPeriods beyond, double farthest,
                                 double last);
// A fast change of the phase between rows, where this fraction of the energy is; more: number of other
// places.
std::string phase_turns_between_rows(const std::string& key, const RaoTable::Turn& t, double energy,
                                     size_t more);

}  // namespace hawser::advice
