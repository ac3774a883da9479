// Impacts within a step, the energy that a step may then create or lose, and the longest step that is
// acceptable for every line.
#include "hawser/kernels/impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSteps = 25;        // per period: with fewer, fast rebounds create energy
constexpr double kAbove = 1 + 1e-6;  // rounding of a step length
constexpr double kShort = 0.02;      // fraction of such a step: nearer contacts count as present
constexpr double kRounding = 1e-12;  // fraction of the kinetic energy of the rigid motion

// Time until a mass at the distance `away` [m] with the speed `speed` [m/s, > 0] arrives, with `acceleration`
// [m/s²] away; infinite: it reverses before.
double until_contact(double away, double speed, double acceleration) {
  const double root = speed * speed - 2 * acceleration * away;
  if (root < 0) return kNever;
  return 2 * away / (speed + std::sqrt(root));
}

// 1 over the energy tolerance of the line; of two lines the smaller tolerance.
double weight(int line, int other, std::span<const double> energy_tolerance) {
  double smaller = energy_tolerance[line];
  if (other >= 0) smaller = std::min(smaller, energy_tolerance[other]);
  return smaller > 0 ? 1 / smaller : 1 / std::numeric_limits<double>::min();
}

// Largest argument up to `limit` for which function(), increasing and summed over the ranks, is at most 1.
template <class Function>
double largest(double limit, Sum sum, const Function& function) {
  constexpr int kParts = 16, kRounds = 6;
  double from = 0;
  double part = limit / kParts;
  std::array<double, kParts> values{};
  for (int round = 0; round < kRounds; ++round, part /= kParts) {
    for (int i = 0; i < kParts; ++i) values[i] = function(from + (i + 1) * part);
    sum(values);
    const auto end = std::find_if(values.begin(), values.end(), [](double e) { return !(e <= 1); });
    from += static_cast<double>(end - values.begin()) * part;
    if (end == values.end()) break;
  }
  return from;
}

}  // namespace

bool may_impact(double inverse_frequency, double significant_depth, double speed, double acceleration) {
  const double rounding = 1 + 1e-9;
  return std::hypot(inverse_frequency * speed, inverse_frequency * inverse_frequency * acceleration) *
             rounding >
         significant_depth;
}

bool resolves_contact(double inverse_frequency, double h) {
  return h <= kAbove * M_PI / (2 * kSteps) * inverse_frequency;
}

// A mass m that meets the spring k = m/tau², tau = inverse_frequency, with the speed v and the acceleration a
// vibrates with the energy k ((tau v)² + (tau² a)²)/2.
std::optional<ImpactEvent> impact_event(double inverse_frequency, double significant_depth, double mass,
                                        const Approach& approach) {
  const double by_speed = inverse_frequency * std::abs(approach.closing);
  const double by_acceleration = inverse_frequency * inverse_frequency * std::abs(approach.acceleration);
  if (!(std::hypot(by_speed, by_acceleration) > significant_depth)) return {};
  const double step = 2 * M_PI / kSteps * inverse_frequency;
  ImpactEvent s;
  s.approach_ = approach;
  s.inverse_frequency_ = inverse_frequency;
  s.half_stiffness_ = 0.5 * mass / (inverse_frequency * inverse_frequency);
  s.energy_ = s.half_stiffness_ * (by_speed * by_speed + by_acceleration * by_acceleration);
  s.crossing_ = kNever;
  s.resolved_ = kAbove * step;
  if (approach.gap < 0) {
    // The contact pushes only at the start of that step, so the trapezoidal rule includes half of it.
    if (approach.last && approach.closing < 0)
      s.crossing_ = until_contact(-approach.gap, -approach.closing, -0.5 * approach.acceleration);
  } else if (approach.closing > 0) {
    // Bounded, because accelerations change during the step.
    s.crossing_ = std::min(until_contact(approach.gap, approach.closing, approach.acceleration),
                           2 * approach.gap / approach.closing);
    s.resolved_ += s.crossing_;
  } else if (!(by_acceleration > significant_depth)) {
    return {};  // it separates; else it vibrates at the frequency of the contact
  }
  if (s.crossing_ < kShort * step) s.crossing_ = kNever;
  return s;
}

// Energy of a step h that begins at the gap g with the speed v and the acceleration a outwards, at most that
// of the vibration:
//   arriving:  k g d/(2 (1 + (h/2 tau)²)),   depth at the end d = -g + v h - a h²/2
//   leaving:   -k g d/2,                     distance at the end d = g + v h + a h²/4
double ImpactEvent::crossed(double h) const {
  if (!(h > crossing_)) return 0;
  const double speed = std::abs(approach_.closing);
  h = std::min(h, resolved_ + 2 * M_PI / kSteps * inverse_frequency_);  // longer steps: unresolved()
  if (approach_.gap < 0) {
    const double out = approach_.gap + speed * h + 0.25 * approach_.acceleration * h * h;
    return std::min(-half_stiffness_ * approach_.gap * std::max(out, 0.0), energy_);
  }
  const double z = 0.5 * h / inverse_frequency_;
  // If the mass would reverse before, it is assumed to continue at its speed.
  const double root = speed * speed - 2 * approach_.acceleration * approach_.gap;
  const double depth = -approach_.gap + speed * h -
                       (root < 0 ? speed * crossing_ - approach_.gap : 0.5 * approach_.acceleration * h * h);
  return std::min(half_stiffness_ * approach_.gap * std::max(depth, 0.0) / (1 + z * z), energy_);
}

double ImpactEvent::period() const { return approach_.gap < 0 ? 2 * M_PI * inverse_frequency_ : kNever; }

// E exp(-2 zeta omega t); more than critical damping leaves no oscillation.
double ImpactEvent::energy_after(double time) const {
  if (!(approach_.gap < 0)) return 0;
  return energy_ * std::exp(-2 * std::min(approach_.damping, 1.0) * time / inverse_frequency_);
}

double crossing_error(double inverse_frequency, double significant_depth, double force, double potential,
                      double path, double speed) {
  return inverse_frequency * speed > significant_depth ? std::max(0.5 * force * path - potential, 0.0) : 0;
}

double LineMotion::energy() const {
  const double of_centre = mass > 0 ? 0.5 * momentum.squaredNorm() / mass : 0;
  const double inner = kinetic - of_centre;
  return (inner > kRounding * kinetic ? inner : 0) + impact_energy;
}

bool LineMotion::has_impacts() const { return impact_energy > kErrorOfStep * energy(); }

std::vector<double> energy_tolerance(std::span<const LineMotion> lines, int lines_with_impacts) {
  std::vector<double> out;
  for (const LineMotion& l : lines)
    out.push_back(kErrorOfStep * std::max(lines_with_impacts, 1) * l.energy());
  return out;
}

double growth_limited_step(std::span<const LineMotion> stored, std::span<const double> energy_tolerance,
                           double factor, double last) {
  double rate = 0;  // 1/s², relative to the energy tolerance of the line
  for (size_t l = 0; l < stored.size(); ++l)
    if (const double held = factor * stored[l].energy(); held > 0)
      rate = std::max(rate, held / std::max(energy_tolerance[l], std::numeric_limits<double>::min()));
  return last > 0 && rate > 0 ? std::max(2 * last, std::hypot(last, 1 / std::sqrt(rate))) : kNever;
}

bool within_tolerance(std::span<const UnresolvedImpact> impacts, std::span<const double> energy_tolerance,
                      Sum sum) {
  double error = 0;
  for (const UnresolvedImpact& i : impacts) error += weight(i.line, i.other, energy_tolerance) * i.energy;
  sum({&error, 1});
  return error <= 1;
}

StepLimit impact_limited_step(std::span<const ImpactEvent> impacts, std::span<const double> energy_tolerance,
                              double max_step, Sum sum) {
  std::vector<double> weights;
  for (const ImpactEvent& s : impacts) weights.push_back(weight(s.line, s.other, energy_tolerance));
  const auto total = [&](const auto& error) {
    double t = 0;
    for (size_t i = 0; i < impacts.size(); ++i) t += weights[i] * error(impacts[i]);
    return t;
  };
  StepLimit limit;
  const auto damped = std::count_if(impacts.begin(), impacts.end(), [](const auto& s) { return s.damped(); });
  std::array<double, 2> sums{total([](const ImpactEvent& s) { return s.energy(); }),
                             static_cast<double>(damped)};
  sum(sums);
  const auto [all, any_damped] = sums;
  if (!(all > 1)) return limit;
  // Longer periods do not shorten any step.
  const double longest = kSteps * max_step;
  limit.period = largest(longest, sum, [&](double period) {
    return total([&](const ImpactEvent& s) { return s.period() < period ? s.energy() : 0; });
  });
  if (limit.period >= longest) limit.period = kNever;
  limit.decay = kPeriodsAfterImpact * limit.period;
  if (any_damped > 0 && limit.period < kNever)
    limit.decay -= largest(limit.decay, sum, [&](double earlier) {
      return total([&](const ImpactEvent& s) { return s.energy_after(limit.decay - earlier); });
    });
  const double step = largest(
      max_step, sum, [&](double h) { return total([&](const ImpactEvent& s) { return s.unresolved(h); }); });
  // If contact is not reached in one step but in two, each covers half of the time.
  const double until = largest(
      2 * step, sum, [&](double h) { return total([&](const ImpactEvent& s) { return s.crossed(h); }); });
  limit.longest = until <= step ? until : 0.5 * until;
  if (limit.longest >= max_step) limit.longest = kNever;
  return limit;
}

}  // namespace hawser
