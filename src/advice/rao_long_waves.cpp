// Check of the conventions of a response table by its longest waves, in which every vessel moves as the water
// does. With the elevation cos(omega t) at the origin, waves to beta from the bow, deep water, and
// k = omega²/g:
//   heave 1,  surge -i cos beta,  sway -i sin beta,  pitch i k cos beta
// (Faltinsen 1990, Sea Loads on Ships and Offshore Structures, chapter 3; pitch is positive with the bow
// down). In shallow water surge and sway are larger.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/rao_tables.hpp"

namespace hawser::advice {
namespace {

constexpr double kLong = 15;    // s; shorter waves are not long against ships
constexpr double kSame = 1e-9;  // rad and rad/s: equal directions or frequencies
constexpr std::complex<double> kI(0, 1);

// Responses to waves of one direction at the two longest periods, and those of the water, for 1 m of wave.
struct LongRow {
  double direction = 0;    // rad
  double omega = 0;        // rad/s, of the longer wave
  double number = 0;       // 1/m, of the longer wave
  Response longest, next;  // next: its rotations in proportion to the slope of the longer wave
};

// Table rows at the two longest periods, by direction. Empty: one period only, or no long waves.
std::vector<LongRow> long_rows(const std::vector<RaoTable::Row>& rows, double gravity) {
  double slowest = HUGE_VAL;  // rad/s
  double second = HUGE_VAL;
  for (const RaoTable::Row& r : rows) slowest = std::min(slowest, r.omega);
  for (const RaoTable::Row& r : rows)
    if (r.omega > slowest + kSame) second = std::min(second, r.omega);
  std::vector<LongRow> out;
  if (!(2 * M_PI / slowest >= kLong) || !std::isfinite(second)) return out;
  for (const RaoTable::Row& r : rows) {
    if (r.omega > slowest + kSame) continue;
    const auto next = std::find_if(rows.begin(), rows.end(), [&](const RaoTable::Row& other) {
      return std::abs(other.omega - second) < kSame && std::abs(other.direction - r.direction) < kSame;
    });
    if (next == rows.end()) continue;
    LongRow& row = out.emplace_back(
        LongRow{r.direction, slowest, slowest * slowest / gravity, r.response, next->response});
    for (size_t k = 3; k < 6; ++k) row.next[k] *= slowest * slowest / (second * second);
  }
  return out;
}

// Responses of a vessel near a resonance change from one period to the next.
bool steady(const LongRow& row, size_t freedom, double change) {
  const std::complex<double> at_longest = row.longest[freedom];
  return std::abs(at_longest - row.next[freedom]) < change * std::abs(at_longest);
}

// Factor of all amplitudes that another definition of the amplitude has: 0.5, 2 or 1. The heave of large
// ships and near a resonance may be one of them by itself, but not with the surge or sway of the water.
double common_factor(const std::vector<LongRow>& rows) {
  constexpr double kPeriod = 24;  // s
  constexpr double kNear = 0.1;
  constexpr double kLeast = 0.85, kMost = 2;  // of the horizontal amplitude, up to shallow water
  if (!(2 * M_PI / rows.front().omega >= kPeriod)) return 1;
  for (const double factor : {0.5, 2.0}) {
    const auto has_factor = [&](const LongRow& row) {
      const double along = std::hypot(std::abs(row.longest[0]), std::abs(row.longest[1])) / factor;
      return std::abs(std::abs(row.longest[2]) / factor - 1) < kNear &&
             std::abs(std::abs(row.next[2]) / factor - 1) < kNear && along > kLeast && along < kMost;
    };
    if (std::all_of(rows.begin(), rows.end(), has_factor)) return factor;
  }
  return 1;
}

// Phase of responses relative to the motion of the water, over several directions.
class Phase {
 public:
  // Responses of less than `least` or more than `most` times the water's amplitude are those of a vessel that
  // does not follow it.
  void add(const LongRow& row, size_t freedom, std::complex<double> water, double least, double most) {
    const std::complex<double> response = row.longest[freedom];
    const double size = std::abs(response);
    const double reference = std::abs(water);
    if (!(size > least * reference) || size > most * reference || !steady(row, freedom, kChange)) return;
    along_ += (response * std::conj(water)).real();
    all_ += size * reference;
  }
  bool known() const { return all_ > 0; }
  // Within 60 degrees of the water's motion, or of its opposite.
  bool with_water() const { return known() && along_ > kClear * all_; }
  bool opposite() const { return known() && along_ < -kClear * all_; }

 private:
  static constexpr double kClear = 0.5, kChange = 0.35;
  double along_ = 0, all_ = 0;
};

struct Phases {
  Phase surge, sway, heave, pitch;
};

Phases phases_of(const std::vector<LongRow>& rows, double factor) {
  constexpr double kAcross = 0.3;  // of the wave: smaller components are not evaluated
  // A spar heaves against the waves below its natural period, by amounts that change fast with the period.
  constexpr double kLeast = 0.85, kMost = 1.15, kChange = 0.1;
  constexpr double kShallow = 3;  // surge over heave in shallow water
  Phases out;
  for (const LongRow& row : rows) {
    const double heave = std::abs(row.longest[2]) / factor;
    if (heave < kLeast || heave > kMost || !steady(row, 2, kChange)) continue;
    out.heave.add(row, 2, factor, 0, HUGE_VAL);
    const double c = std::cos(row.direction);
    const double s = std::sin(row.direction);
    if (std::abs(c) > kAcross) {
      out.surge.add(row, 0, -kI * (factor * c), 0.5, kShallow);
      out.pitch.add(row, 4, kI * (factor * row.number * c), 0.6, 1.6);
    }
    if (std::abs(s) > kAcross) out.sway.add(row, 1, -kI * (factor * s), 0.5, kShallow);
  }
  return out;
}

// Sentence about phases; empty: they are those of the water.
std::string odd_phase(const Phases& p) {
  const bool both = !p.sway.known() || p.sway.opposite();
  if (p.heave.opposite())
    return p.surge.opposite()
               ? "heave and surge are opposite to the motion of the water: do the phases refer to the trough?"
               : "heave is opposite to the elevation: is its z axis down?";
  if (!p.heave.with_water()) return "";
  if ((p.surge.opposite() && both) || (!p.surge.known() && p.sway.opposite()))
    return "the vessel moves against the water: are directions those from which the waves come, or are the "
           "phases leads in place of lags ('phase')?";
  if (p.surge.opposite())
    return "surge is opposite to the motion of the water: is its x axis towards the stern?";
  if (p.sway.opposite())
    return "sway is opposite to the motion of the water: are directions clockwise, or is its y axis to "
           "starboard?";
  if (p.surge.with_water() && p.pitch.opposite())
    return "pitch is opposite to the slope of the water: it is positive if the bow goes down";
  return "";
}

}  // namespace

std::vector<std::string> odd_in_long_waves(const std::string& key, const std::vector<RaoTable::Row>& rows,
                                           double gravity) {
  std::vector<std::string> out;
  const std::vector<LongRow> longest = long_rows(rows, gravity);
  if (longest.empty()) return out;
  const std::string where = fmt::format("{}: in its longest waves, ", key);
  const double factor = common_factor(longest);
  if (factor != 1)
    out.push_back(fmt::format(
        "{}in which every vessel heaves 1 m for 1 m of amplitude, it heaves {:g} m: are "
        "the amplitudes {}?",
        where, factor,
        factor < 1 ? "those for 1 m of wave height" : "from crest to trough, for 1 m of amplitude"));
  if (const std::string odd = odd_phase(phases_of(longest, factor)); !odd.empty()) out.push_back(where + odd);
  return out;
}

}  // namespace hawser::advice
