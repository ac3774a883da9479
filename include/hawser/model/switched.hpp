// Selection of the volumes that an event switches.
#pragma once

#include "hawser/model/case.hpp"

namespace hawser::model {

// True if the event names the volume, or for a roller its box ("stinger 3") or group of supports ("stinger").
inline bool switches(const Action& a, const Volume& v) {
  return a.kind == Action::Kind::contact &&
         (a.volume == v.name || (v.roller && v.name.starts_with(a.volume + " ")));
}

}  // namespace hawser::model
