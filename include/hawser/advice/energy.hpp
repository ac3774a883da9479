// Sentences about energy that the time integration has made, lost or damped.
#pragma once

#include <string>

namespace hawser::advice {

enum class ContactWith { nothing, volume, line, seabed };

struct EnergyMade {
  double energy = 0, by = 0, work = 0;      // J; s; J, the work done so far
  double most = 0, time = 0, length = 0;    // of the step that made most: J; s, at its end; s
  ContactWith with = ContactWith::nothing;  // what acted there
  bool fixed = false;                       // the user chose the step
};
// where: in the mesh. initial_velocity_key: of a motion that begins with a velocity and explains it, or "".
std::string energy_made(const EnergyMade& made, const std::string& where,
                        const std::string& initial_velocity_key);
// J, lost by a time [s] of the work done; in steps of so many s.
std::string energy_lost(double energy, double by, double work, double step, bool fixed);
std::string energy_is_no_number();
// The end of a sentence about so much that the run has failed.
std::string not_to_be_used();
// J of axial vibration, of so much.
std::string vibration_damped(double energy, double size);

}  // namespace hawser::advice
