// Which volumes an event switches on or off.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::model {

// Its own name, or of rollers that of their box ("stinger 3") or group of supports ("stinger").
inline bool switches(const Action& a, const Volume& v) {
  return a.kind == Action::Kind::contact &&
         (a.volume == v.name || (v.roller && v.name.starts_with(a.volume + " ")));
}

}  // namespace hawser::model
