// Messages about the energy balance.
#include "hawser/advice/energy.hpp"

#include <fmt/format.h>

namespace hawser::advice {
namespace {

const char* words(ContactWith with) {
  switch (with) {
    case ContactWith::volume:
      return "it touches a volume there";
    case ContactWith::line:
      return "it touches a line there";
    case ContactWith::seabed:
      return "it touches the seabed there";
    case ContactWith::nothing:
      break;
  }
  return "its velocity changes faster than the time steps resolve";
}

// A step that is certainly short enough: a quarter of the one that was too long.
std::string remedy(StepChoice choice, double step) {
  return fmt::format("give dynamics.{}: {:.2g} s", step_key(choice), step / 4);
}

}  // namespace

std::string energy_created(const EnergyCreated& m, const std::string& where,
                           const std::string& initial_velocity_key) {
  const std::string text = fmt::format(
      "the steps created {:.3g} J of energy by t = {:.6g} s, {:.3g} % of the work done; the one of {:.3g} s "
      "that ended at t = {:.6g} s created most of it, {:.3g} J, at {}: ",
      m.energy, m.until, 100 * m.energy / m.work, m.length, m.time, m.step_energy, where);
  if (!initial_velocity_key.empty())
    return text + fmt::format(
                      "{} begins with a non-zero velocity, which is an impact on the lines at rest; add a "
                      "'ramp' to it (a shorter step does not help)",
                      initial_velocity_key);
  return text + fmt::format("{}; {}", words(m.with), remedy(m.step, m.length));
}

std::string energy_lost(double energy, double until, double work, double step, StepChoice choice) {
  return fmt::format(
      "the steps lost {:.3g} J by t = {:.6g} s, {:.3g} % of the work done: they are too long for the motion; "
      "{}",
      energy, until, 100 * energy / work, remedy(choice, step));
}

std::string energy_is_no_number() { return "the energy is not a finite number" + not_to_be_used(); }

std::string not_to_be_used() { return ". Do not use the results"; }

std::string vibration_damped(double energy, double size) {
  return fmt::format(
      "{:.3g} J of axial vibration faster than the time steps resolve were dissipated ({:.2g} % of the "
      "energy brought in or stored); the peak tension of a snap load may be higher for less than a step",
      energy, 100 * energy / size);
}

}  // namespace hawser::advice
