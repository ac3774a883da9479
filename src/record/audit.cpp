// Update of the energy balance at each step, and the limits for energy that the time integration has created
// or lost.
#include "hawser/record/audit.hpp"

#include <algorithm>
#include <cmath>

namespace hawser::record {
namespace {
// Fractions of Audit::size(). Created energy amplifies itself; lost energy damps, and slight damping is
// equivalent to slightly thicker water.
constexpr double kMadeReported = 0.01, kMadeWrong = 0.05, kLostReported = 0.05, kLostWrong = 0.20,
                 kUnresolvedReported = 0.02;
// Fraction of the largest kinetic and strain energy so far: created energy that has not been dissipated is
// still in the lines.
constexpr double kRemainsWrong = 0.2;

// Rounding and Newton's tolerance as a fraction of the strain energy; negligible energy for any line, J.
constexpr double kRounding = 1e-6, kNothing = 1e-6;

// Number of steps from t = 0 in which an impact at the start creates energy.
constexpr double kImpactSteps = 6;

}  // namespace

bool Audit::update(const Energy& start, const Energy& e, double time, double h, double passed) {
  const double before = error, brought_before = brought_in;
  now = e;
  brought_in = e.work - start.work - (e.potential - start.potential);
  change.kinetic = e.kinetic - start.kinetic;
  change.strain = e.strain - start.strain;
  change.friction = e.friction - start.friction;
  change.damping = e.damping - start.damping;
  change.unresolved = e.unresolved - start.unresolved;
  error = change.kinetic + change.strain + change.friction + change.damping + change.unresolved - brought_in;
  at_start = start.kinetic;
  worked += std::abs(brought_in - brought_before) + passed;
  set_free = std::max(set_free, start.strain - e.strain);
  most_strain = std::max(most_strain, e.strain);
  if (error < least_error) {
    least_error = error;
    climb = {};
  }
  const double rise = error - least_error;
  least_by_water = std::min(least_by_water, e.by_water - start.by_water);
  const double taken_before = taken;
  taken = std::max(taken, change.friction + change.damping + change.unresolved - least_by_water);
  // Dissipation removes created energy in proportion.
  if (there > 0) remains *= std::exp(-(taken - taken_before) / there);
  remains = std::max(0.0, remains + error - before);
  most_remains = std::max(most_remains, remains);
  there = std::max(there, e.kinetic + std::abs(e.strain - start.strain) - remains);
  const bool most = error - before > climb.value;
  if (most) climb = {error - before, time, h, -1, Step::ContactWith::nothing};
  if (rise > made.value) {
    made = {rise, time, h};
    worst = climb;
  }
  if (-error > lost.value) lost = {-error, time, h};
  return most && climb.value > 1e-4 * size();
}

void Audit::located(int node, Step::ContactWith with) {
  climb.node = node;
  climb.with = with;
  if (worst.time == climb.time) worst = climb;
}

double Audit::size() const { return at_start + worked + set_free + kRounding * most_strain + kNothing; }

double Audit::percent() const { return 100 * error / size(); }

// The limit does not grow with the work of waves in a long run: created energy that may still be in the lines
// is compared with the largest energy present at a time.
bool Audit::wrong() const {
  if (!std::isfinite(error)) return true;
  return made.value > kMadeWrong * size() ||
         most_remains > kRemainsWrong * there + kRounding * most_strain + kNothing ||
         lost.value > kLostWrong * size();
}

std::string Audit::warning(bool fixed, const std::string& where,
                           const std::string& initial_velocity_key) const {
  if (!std::isfinite(error)) return advice::energy_is_no_number();
  const double making = made.value / (kMadeReported * size()), losing = lost.value / (kLostReported * size());
  if (std::max(making, losing) <= 1 && !wrong()) return "";
  const bool at_start_of_motion = worst.time <= kImpactSteps * worst.length;
  const std::string text = making > losing
                               ? advice::energy_made({made.value, made.time, size(), worst.value, worst.time,
                                                      worst.length, worst.with, fixed},
                                                     where, at_start_of_motion ? initial_velocity_key : "")
                               : advice::energy_lost(lost.value, lost.time, size(), lost.step, fixed);
  return wrong() ? text + advice::not_to_be_used() : text;
}

std::string Audit::note() const {
  const double size = std::max(std::abs(brought_in), there) + kRounding * most_strain + kNothing;
  if (now.unresolved < kUnresolvedReported * size) return "";
  return advice::vibration_damped(now.unresolved, size);
}

}  // namespace hawser::record
