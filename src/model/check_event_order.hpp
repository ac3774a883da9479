// Checks of events against each other, a part of check_events().
#pragma once

#include "hawser/model/check.hpp"

namespace hawser::model {

// Checks that chains of events have a start, that release and attachment of ends and switching of volumes
// alternate, that one end stays at each joint, and that each stage of statics has an event.
void check_event_order(const Case& c, const Issues& issue);

}  // namespace hawser::model
