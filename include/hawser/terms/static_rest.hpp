// Decides whether statics computes the equilibrium of a floating body or holds it where it starts.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser {

struct StaticRest {
  // The body is a platform, has dynamic positioning, carries lines or links, can be touched by lines, is held
  // by springs, also in wind and current, or floats in water where no current moves it.
  bool supported = false;
  bool loaded = false;       // by forces of the case
  bool by_friction = false;  // other bodies can hold it if contact has friction in statics
  bool is_computed(bool friction) const { return supported || loaded || (friction && by_friction); }
};

// body: index in the case, of a body with mass.
StaticRest static_rest(const model::Case& c, int body);

}  // namespace hawser
