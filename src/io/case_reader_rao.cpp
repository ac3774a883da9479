// Vessel motion by response amplitude operators, from a file or rows in the case.
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/advice/rao_tables.hpp"
#include "hawser/kernels/rao.hpp"
#include "hawser/math/degree.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/wave_components.hpp"

namespace hawser::io {
namespace {

using model::refuse;

constexpr double kOneDirection = kDegree;   // largest deviation from the only direction of a table
constexpr double kWideGap = 100 * kDegree;  // a wider gap between directions misses a side of the vessel

// True if a table declared as one side has rows of both sides.
bool both_sides(const std::vector<RaoTable::Row>& rows) {
  const auto has_direction = [&](double sign) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const RaoTable::Row& r) { return sign * std::sin(r.direction) > 1e-9; });
  };
  return has_direction(1) && has_direction(-1);
}

RaoTable read_table(const model::Value& rao, double gravity, const CaseSource& source,
                    std::vector<std::string>& notes) {
  const InputRows given = read_input_rows(rao, source);
  const auto& rows = given.rows;
  const double sign = rao["phase"].is("lead") ? 1 : -1;
  std::vector<RaoTable::Row> table;
  for (size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double>& r = rows[i];
    if (r.size() != 14)
      refuse_rows(
          given,
          "a row of responses has 14 numbers (period, direction, six amplitudes each with its phase), but "
          "row {} has {}",
          i + 1, r.size());
    if (!(r[0] > 0)) refuse_rows(given, "periods must be above 0, but row {} has {:g} s", i + 1, r[0]);
    for (size_t k = 2; k < 14; k += 2)
      if (!(r[k] >= 0))
        refuse_rows(given, "amplitudes must not be negative, but row {} has {:g}: turn its phase by 180 deg",
                    i + 1, r[k]);
    RaoTable::Row& row = table.emplace_back();
    row.omega = 2 * M_PI / r[0];
    row.direction = r[1] * kDegree;
    for (size_t k = 0; k < 6; ++k)
      row.response[k] =
          std::polar(1.0, sign * r[3 + 2 * k] * kDegree) * (r[2 + 2 * k] * (k < 3 ? 1 : kDegree));
  }
  for (std::string& odd : advice::odd_rao_units(rao.where, rows, gravity)) notes.push_back(std::move(odd));
  for (std::string& odd : advice::odd_in_long_waves(rao.where, table, gravity))
    notes.push_back(std::move(odd));
  if (rao["symmetry"].is("port_starboard")) {
    if (both_sides(table))
      refuse_rows(
          given,
          "'symmetry: port_starboard' makes the other side of a table of one side (directions from 0 to "
          "180 deg, or from 180 to 360), but the rows have directions on both");
    table = with_other_side(table);
  }
  try {
    return RaoTable(std::move(table));
  } catch (const std::invalid_argument& e) {
    refuse_rows(given, e.what());
  }
}

// A table of 0 to 180 deg interpolates from 180 to 360: at 270 it has the mean of both ends, without roll.
void check_gaps(const RaoTable& table, const WaveField& waves, double bow, const std::string& key,
                std::vector<std::string>& notes) {
  size_t uncovered = 0;
  DirectionGap gap;
  double direction = 0;
  for (const WaveComponent& w : waves.components()) {
    const double to = std::atan2(w.y, w.x) - bow;
    const DirectionGap b = table.neighbours(to);
    if (b.to - b.from <= kWideGap * (1 + 1e-9)) continue;
    if (uncovered++ == 0) {
      gap = b;
      direction = to;
    }
  }
  if (uncovered == 0) return;
  // Shifts the direction into the gap by full turns.
  direction = gap.from + std::fmod(std::fmod(direction - gap.from, 2 * M_PI) + 2 * M_PI, 2 * M_PI);
  notes.push_back(advice::sea_in_direction_gap(key, uncovered, direction, gap));
}

// A single direction applies to all, and the end periods apply beyond the table; notes waves for which this
// matters.
void check_reach(const RaoTable& table, const WaveField& waves, double bow, const std::string& key,
                 std::vector<std::string>& notes) {
  double furthest = 0, only = 0;                                       // rad, from the table's only direction
  double all = 0, fast = 0, slow = 0, highest = 0, lowest = HUGE_VAL;  // variance of the elevation; rad/s
  for (const WaveComponent& w : waves.components()) {
    const double to = std::atan2(w.y, w.x) - bow;
    const DirectionGap b = table.neighbours(to);
    if (const double off = std::abs(std::remainder(to - b.from, 2 * M_PI));
        b.from == b.to && off > std::max(furthest, kOneDirection)) {
      furthest = off;
      only = b.from;
    }
    const double energy = w.amplitude * w.amplitude;
    all += energy;
    if (w.omega > table.highest() * (1 + 1e-9)) {
      fast += energy;
      highest = std::max(highest, w.omega);
    }
    if (w.omega < table.lowest() * (1 - 1e-9)) {
      slow += energy;
      lowest = std::min(lowest, w.omega);
    }
  }
  if (furthest > 0) notes.push_back(advice::only_one_direction(key, only, furthest));
  const auto check_beyond = [&](double energy, advice::BeyondPeriods beyond, double omega, double last) {
    if (energy > 1e-3 * all)
      notes.push_back(
          advice::sea_beyond_responses(key, energy / all, beyond, 2 * M_PI / omega, 2 * M_PI / last));
  };
  check_beyond(fast, advice::BeyondPeriods::shorter, highest, table.highest());
  check_beyond(slow, advice::BeyondPeriods::longer, lowest, table.lowest());
}

// If the phase changes fast between rows, linear interpolation gives a false response; notes such intervals.
void check_phases(const RaoTable& table, const WaveField& waves, double bow, const std::string& key,
                  std::vector<std::string>& notes) {
  constexpr double kReportedShare = 0.01;  // of the sea's energy
  std::map<RaoTable::Turn, double> turns;
  double all = 0;
  for (const WaveComponent& w : waves.components()) {
    const double energy = w.amplitude * w.amplitude;
    all += energy;
    for (const RaoTable::Turn& t : table.turns(w.omega, std::atan2(w.y, w.x) - bow)) turns[t] += energy;
  }
  std::erase_if(turns, [&](const auto& f) { return f.second < kReportedShare * all; });
  if (turns.empty()) return;
  const auto& [t, energy] = *std::max_element(
      turns.begin(), turns.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  notes.push_back(advice::phase_turns_between_rows(key, t, energy / all, turns.size() - 1));
}

// True if the vessel has a constant position.
bool stays(const model::Drift& d) {
  return d.harmonic.amplitude.isZero(0) && d.table.offset.empty() && d.ramp == 0;
}

}  // namespace

const WaveField& ReadFiles::sea(const model::Environment& e) {
  if (!waves) waves = std::make_shared<const WaveField>(model::wave_field(e));
  return *waves;
}

std::shared_ptr<const RaoTable> read_responses(const model::Value& rao, double gravity,
                                               const CaseSource& source, std::vector<std::string>& notes) {
  std::shared_ptr<const RaoTable>& known =
      source.files->responses[source.directory + " " + model::value_text(rao)];
  if (!known) known = std::make_shared<const RaoTable>(read_table(rao, gravity, source, notes));
  return known;
}

model::TableMotion read_rao(const model::Value& rao, const model::Environment& sea, const model::Body& body,
                            double duration, const CaseSource& source, std::vector<std::string>& notes) {
  const RaoTable& table = *read_responses(rao, sea.gravity, source, notes);
  const std::string key = "bodies." + body.name + ".motion.rao";
  const WaveField& waves = source.files->sea(sea);
  if (waves.none()) refuse(rao, "a vessel moves by its responses in waves: give 'environment: {waves: ...}'");
  const model::Drift none;
  const DriftLaw drift = model::drift_law(body.drift ? *body.drift : none);
  const double yaw = body.drift ? body.drift->rotation.z() : 0;
  const double heading = model::heading(body);
  check_gaps(table, waves, heading + yaw, key, notes);
  if (advice::possible(sea.water.waves)) check_reach(table, waves, heading + yaw, key, notes);
  check_phases(table, waves, heading + yaw, key, notes);
  const RaoMotion motion(table, waves, body.position, heading, yaw);
  // The highest of many components has ten times the peak frequency and almost no energy.
  const double step = 2 * M_PI / motion.highest() / (waves.components().size() > 20 ? 30 : 100);
  const double count = duration / step + 20;
  constexpr double kMost = 5e6;
  if (count > kMost)
    refuse(rao, "{:g} s of this motion are {:.3g} rows of a table; the limit is {:g}", duration, count,
           kMost);
  model::TableMotion m;
  m.of_waves = true;
  constexpr int kBefore = 10;
  for (int i = -kBefore; i <= static_cast<int>(count) - kBefore; ++i) m.time.push_back(i * step);
  if (!body.drift || stays(*body.drift)) {
    motion.rows(-kBefore * step, step, m.time.size(), body.drift ? body.drift->offset : Vec3(Vec3::Zero()),
                m.offset, m.rotation);
    return m;
  }
  for (const double t : m.time) {
    Vec3 offset, rotation;
    VectorMotion drifted, turned;
    drift.at(std::max(t, 0.0), drifted, turned);
    motion.at(t, offset, rotation, drifted.value);
    m.offset.push_back(offset);
    m.rotation.push_back(rotation);
  }
  return m;
}

}  // namespace hawser::io
