// How the energy balance of a run is updated at each step, the limits for energy that the time integration
// has created or lost, and the sentences that report it at the end of a run.
#include "hawser/record/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::record {
namespace {
// Shares of Audit::size(). Energy that is made feeds on itself; what is lost damps, and a run that is damped
// a little is as good as one in thicker water.
constexpr double kMadeTold = 0.01, kMadeWrong = 0.05, kLostTold = 0.05, kLostWrong = 0.20,
                 kUnresolvedTold = 0.02;
// Share of the largest energy of motion and strain so far: energy that steps made and nothing has dissipated
// is still in the lines.
constexpr double kRemainsWrong = 0.2;

// Rounding and Newton's tolerance: of the strain energy that is there; and what is nothing to any line, J.
constexpr double kRounding = 1e-6, kNothing = 1e-6;

const char* words(Audit::Step::ContactWith with) {
  switch (with) {
    case Audit::Step::ContactWith::volume:
      return "it touches a volume there";
    case Audit::Step::ContactWith::line:
      return "it touches a line there";
    case Audit::Step::ContactWith::seabed:
      return "it touches the seabed there";
    case Audit::Step::ContactWith::nothing:
      break;
  }
  return "its motion changes faster than the time steps resolve";
}

// Steps from t = 0 on in which a blow at the start does its harm.
constexpr double kBlow = 6;

// One that is surely short: a quarter of what was too long.
std::string remedy(bool fixed, double step) {
  return fmt::format("give dynamics.{}: {:.2g} s", fixed ? "step" : "max_step", step / 4);
}

}  // namespace

bool Audit::update(const Energy& start, const Energy& e, double time, double h, double passed) {
  const double before = error, brought_before = brought_in;
  now = e;
  brought_in = e.work - start.work - (e.potential - start.potential);
  error = (e.kinetic - start.kinetic) + (e.strain - start.strain) + (e.friction - start.friction) +
          (e.damping - start.damping) + (e.unresolved - start.unresolved) - brought_in;
  at_start = start.kinetic;
  worked += std::abs(brought_in - brought_before) + passed;
  set_free = std::max(set_free, start.strain - e.strain);
  held = std::max(held, e.strain);
  if (error < least_error) least_error = error, climb = {};
  const double rise = error - least_error;
  least_by_water = std::min(least_by_water, e.by_water - start.by_water);
  const double taken_before = taken;
  taken = std::max(taken, (e.friction - start.friction) + (e.damping - start.damping) +
                              (e.unresolved - start.unresolved) - least_by_water);
  // What is dissipated takes its share of what was made with it.
  if (there > 0) remains *= std::exp(-(taken - taken_before) / there);
  remains = std::max(0.0, remains + error - before);
  most_remains = std::max(most_remains, remains);
  there = std::max(there, e.kinetic + std::abs(e.strain - start.strain) - remains);
  const bool most = error - before > climb.value;
  if (most) climb = {error - before, time, h, -1, Step::ContactWith::nothing};
  if (rise > made.value) made = {rise, time, h}, worst = climb;
  if (-error > lost.value) lost = {-error, time, h};
  return most && climb.value > 1e-4 * size();
}

void Audit::located(int node, Step::ContactWith with) {
  climb.node = node, climb.with = with;
  if (worst.time == climb.time) worst = climb;
}

double Audit::size() const { return at_start + worked + set_free + kRounding * held + kNothing; }

double Audit::percent() const { return 100 * error / size(); }

// What is made in a long run is not made good by the work of all its waves: what may still be in the lines is
// judged against the most that was there at a time.
bool Audit::wrong() const {
  if (!std::isfinite(error)) return true;
  return made.value > kMadeWrong * size() ||
         most_remains > kRemainsWrong * there + kRounding * held + kNothing ||
         lost.value > kLostWrong * size();
}

std::string Audit::warning(bool fixed, const std::string& where, const std::string& striking) const {
  if (!std::isfinite(error)) return "the energy is no number. The results are not to be used";
  const double making = made.value / (kMadeTold * size()), losing = lost.value / (kLostTold * size());
  if (std::max(making, losing) <= 1 && !wrong()) return "";
  std::string text;
  const bool blow = !striking.empty() && worst.time <= kBlow * worst.length;
  if (making > losing && blow)
    text = fmt::format(
        "the steps created {:.3g} J of energy by t = {:.6g} s, {:.3g} % of the work done; the one of {:.3g} "
        "s that ended at t = {:.6g} s made most of it, {:.3g} J, at {}: {} begins with a velocity and "
        "strikes the lines, which are at rest; a 'ramp' in it starts it smoothly, a shorter step is no help",
        made.value, made.time, 100 * made.value / size(), worst.length, worst.time, worst.value, where,
        striking);
  else if (making > losing)
    text = fmt::format(
        "the steps created {:.3g} J of energy by t = {:.6g} s, {:.3g} % of the work done; the one of {:.3g} "
        "s that ended at t = {:.6g} s made most of it, {:.3g} J, at {}: {}; {}",
        made.value, made.time, 100 * made.value / size(), worst.length, worst.time, worst.value, where,
        words(worst.with), remedy(fixed, worst.length));
  else
    text = fmt::format(
        "the steps lost {:.3g} J by t = {:.6g} s, {:.3g} % of the work done: they are too long for what "
        "moves; {}",
        lost.value, lost.time, 100 * lost.value / size(), remedy(fixed, lost.step));
  return wrong() ? text + ". The results are not to be used" : text;
}

std::string Audit::note() const {
  const double size = std::max(std::abs(brought_in), there) + kRounding * held + kNothing;
  if (now.unresolved < kUnresolvedTold * size) return "";
  return fmt::format(
      "{:.3g} J of axial vibration faster than the time steps resolve were dissipated ({:.2g} % of the most "
      "that moved at a time); what is tightened at a blow may peak higher for less than a step",
      now.unresolved, 100 * now.unresolved / size);
}

}  // namespace hawser::record
