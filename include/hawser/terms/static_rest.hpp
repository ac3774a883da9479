// Decides whether statics computes the equilibrium of a floating body or holds it where it starts.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser {

struct StaticRest {
  // The body is a platform, has loads or dynamic positioning, carries lines or links, can be touched by
  // lines, is held by springs in wind and current or by a stiffness matrix, or floats in water where no
  // current moves it.
  bool always = false;
  bool by_friction = false;  // other bodies can hold it if contact has friction in statics
  bool is_computed(bool friction) const { return always || (friction && by_friction); }
};

// body: index in the case, of a body with mass.
StaticRest static_rest(const model::Case& c, int body);

}  // namespace hawser
