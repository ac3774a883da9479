// Decides whether statics computes the equilibrium of a floating body or holds it where it starts.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser {

struct StaticRest {
  // It is a platform, has loads, carries lines or links or can be touched by lines, or springs hold it in
  // wind and current, or it floats in water where no current moves it.
  bool always = false;
  bool by_friction = false;  // other bodies can hold it, where contact has friction in statics
  bool found(bool friction) const { return always || (friction && by_friction); }
};

// body: of the case, with mass.
StaticRest static_rest(const model::Case& c, int body);

}  // namespace hawser
