// The part of check_events() that looks at events together.
#pragma once

#include "hawser/model/check.hpp"

namespace hawser::model {

// Chains of events begin somewhere, ends go from held to free and back, volumes on and off, one end stays at
// each joint, and each stage of statics has something to do.
void check_event_order(const Case& c, const Issues& issue);

}  // namespace hawser::model
