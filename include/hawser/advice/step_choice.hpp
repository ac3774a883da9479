// Who chose the length of the time steps.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::advice {

enum class StepChoice { automatic, given };  // given: by the case

inline StepChoice step_choice(const model::Case& c) {
  return c.dynamics.step > 0 ? StepChoice::given : StepChoice::automatic;
}

// Key of `dynamics` by which the user changes the steps.
constexpr const char* step_key(StepChoice choice) {
  return choice == StepChoice::given ? "step" : "max_step";
}

}  // namespace hawser::advice
