// Messages about energy that the time integration has created, lost or damped.
#pragma once

#include <string>

#include "hawser/advice/step_choice.hpp"

namespace hawser::advice {

enum class ContactWith { nothing, volume, line, seabed };

struct EnergyCreated {
  double energy = 0, until = 0, work = 0;        // created energy, J; until, s; work done so far, J
  double step_energy = 0, time = 0, length = 0;  // step that created most: energy, J; end, s; length, s
  ContactWith with = ContactWith::nothing;       // force acting there
  StepChoice step = StepChoice::automatic;
};
// where: place in the mesh. initial_velocity_key: key of a motion that begins with a velocity and is the
// cause, or "".
std::string energy_created(const EnergyCreated& created, const std::string& where,
                           const std::string& initial_velocity_key);
// Energy lost [J] until time `until` [s] of the work done [J], in steps of `step` [s].
std::string energy_lost(double energy, double until, double work, double step, StepChoice choice);
std::string energy_is_no_number();
// End of a sentence about an energy error that makes the run fail.
std::string not_to_be_used();
// Energy of damped axial vibration [J], relative to `size` [J].
std::string vibration_damped(double energy, double size);

}  // namespace hawser::advice
