// Size and direction of mean drift forces of a body alone in its files.
#pragma once

#include <optional>
#include <string>

#include "hawser/model/case.hpp"

namespace hawser::model {

// The largest horizontal mean drift force of a body's files, relative to the force on a wall of the body's
// width that reflects a wave of unit amplitude completely, rho g L/2 (Longuet-Higgins and Stewart 1964).
struct DriftSize {
  double times = 0;   // 0: no drift forces
  double force = 0;   // N/m²
  double period = 0;  // s
  double width = 0;   // m, L: of a round waterplane, or of a cube of the displaced volume
  // A body at resonance may reflect waves of more than its width.
  bool is_noted() const { return times > 10; }
  bool is_refused() const { return times > 300; }
  // At less it is that of a deeply submerged body, whose direction is rounding.
  bool has_direction() const { return times > 1e-3; }
};
DriftSize drift_size(const Case& c, const Body& b);
std::string text_of(const DriftSize& size, const BodyHydrodynamics& h);

// Freedom (surge: 0, sway: 1) in which the mean drift force is against the waves at most frequencies; none:
// neither. A body at rest takes momentum from the waves that it scatters (Maruo 1960).
std::optional<int> drift_against_waves(const BodyHydrodynamics& h);

}  // namespace hawser::model
