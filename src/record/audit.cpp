// Update of the energy balance at each step, and the limits for energy that the time integration has created
// or lost.
#include "hawser/record/audit.hpp"

#include <algorithm>
#include <cmath>

namespace hawser::record {
namespace {
// Fractions of Audit::size() above which created or lost energy is reported, or the results are wrong.
// Created energy amplifies itself; lost energy acts as slightly more drag.
constexpr double kCreatedReported = 0.01, kCreatedWrong = 0.05, kLostReported = 0.05, kLostWrong = 0.20,
                 kUnresolvedReported = 0.02;
// The same of Audit::remaining, as a fraction of Audit::largest_energy: created energy that has not been
// dissipated is still in the lines.
constexpr double kRemainingWrong = 0.2;
// Created energy e as axial vibration changes the tension T of a line with the strain energy E = T² L/2EA by
// sqrt(e/E) of it: by at most 5 % if e is below this fraction of E.
constexpr double kSmallVibration = 0.0025;

// Rounding and Newton's tolerance as a fraction of the strain energy; an energy [J] negligible for any line.
constexpr double kRounding = 1e-6, kNegligible = 1e-6;

// Number of steps from t = 0 in which an impact at the start creates energy.
constexpr double kImpactSteps = 6;

}  // namespace

bool Audit::update(const Energy& start, const Energy& e, double time, double h, double passed) {
  const double before = error;
  const double brought_before = brought_in;
  now = e;
  brought_in = e.work - start.work - (e.potential - start.potential);
  change.kinetic = e.kinetic - start.kinetic;
  change.strain = e.strain - start.strain;
  change.friction = e.friction - start.friction;
  change.damping = e.damping - start.damping;
  change.unresolved = e.unresolved - start.unresolved;
  error = change.kinetic + change.strain + change.friction + change.damping + change.unresolved - brought_in;
  initial_kinetic = start.kinetic;
  absolute_work += std::abs(brought_in - brought_before) + passed;
  released_strain = std::max(released_strain, start.strain - e.strain);
  largest_strain = std::max(largest_strain, e.strain);
  if (error < smallest_error) {
    smallest_error = error;
    largest_step_gain = {};
  }
  const double rise = error - smallest_error;
  smallest_by_water = std::min(smallest_by_water, e.by_water - start.by_water);
  const double dissipated_before = dissipated;
  dissipated = std::max(dissipated, change.friction + change.damping + change.unresolved - smallest_by_water);
  // Dissipation removes created energy in proportion.
  if (largest_energy > 0) remaining *= std::exp(-(dissipated - dissipated_before) / largest_energy);
  remaining = std::max(0.0, remaining + error - before);
  largest_remaining = std::max(largest_remaining, remaining);
  largest_energy = std::max(largest_energy, e.kinetic + std::abs(e.strain - start.strain) - remaining);
  const bool is_largest = error - before > largest_step_gain.value;
  if (is_largest) largest_step_gain = {error - before, time, h, -1, Step::ContactWith::nothing};
  if (rise > largest_gain.value) {
    largest_gain = {rise, time, h};
    worst = largest_step_gain;
  }
  if (-error > largest_loss.value) largest_loss = {-error, time, h};
  return is_largest && largest_step_gain.value > 1e-4 * size();
}

void Audit::located(int node, Step::ContactWith with) {
  largest_step_gain.node = node;
  largest_step_gain.with = with;
  if (worst.time == largest_step_gain.time) worst = largest_step_gain;
}

double Audit::size() const {
  return initial_kinetic + absolute_work + released_strain + kRounding * largest_strain + kNegligible;
}

double Audit::percent() const { return 100 * error / size(); }

// The limit does not grow with the work of waves in a long run: created energy that may still be in the lines
// is compared with the largest energy present at a time.
bool Audit::wrong() const {
  if (!std::isfinite(error)) return true;
  const bool created =
      largest_gain.value > kCreatedWrong * size() ||
      largest_remaining > kRemainingWrong * largest_energy + kRounding * largest_strain + kNegligible;
  return (created && largest_gain.value > kSmallVibration * largest_strain) ||
         largest_loss.value > kLostWrong * size();
}

std::string Audit::warning(advice::StepChoice step, const std::string& where,
                           const std::string& initial_velocity_key) const {
  if (!std::isfinite(error)) return advice::energy_is_no_number();
  const double relative_gain = largest_gain.value / (kCreatedReported * size());
  const double relative_loss = largest_loss.value / (kLostReported * size());
  if (std::max(relative_gain, relative_loss) <= 1 && !wrong()) return "";
  const bool at_start_of_motion = worst.time <= kImpactSteps * worst.length;
  const std::string text =
      relative_gain > relative_loss
          ? advice::energy_created({largest_gain.value, largest_gain.time, size(), worst.value, worst.time,
                                    worst.length, worst.with, step},
                                   where, at_start_of_motion ? initial_velocity_key : "")
          : advice::energy_lost(largest_loss.value, largest_loss.time, size(), largest_loss.step, step);
  return wrong() ? text + advice::not_to_be_used() : text;
}

std::string Audit::note() const {
  const double size =
      std::max(std::abs(brought_in), largest_energy) + kRounding * largest_strain + kNegligible;
  if (now.unresolved < kUnresolvedReported * size) return "";
  return advice::vibration_damped(now.unresolved, size);
}

}  // namespace hawser::record
