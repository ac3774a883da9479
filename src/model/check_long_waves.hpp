// Checks of wave forces against their limits in long waves, a part of the checks of coefficients.
#pragma once

#include "hawser/model/check.hpp"

namespace hawser::model {

// Refuses phases of another convention, and a heave force of another scale than the hydrostatic stiffness.
void check_long_waves(const Case& c, const Body& b, const Issues& issue);
// Notes the largest of what displaced volume and hydrostatic stiffness differ from those by the wave forces.
void note_long_waves(const Case& c, const Body& b, const Issues& note);

}  // namespace hawser::model
