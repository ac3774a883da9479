// What happens after an accepted step, in the order that the time integration and its trial share.
#pragma once

#include <functional>
#include <string>

#include "hawser/run/events.hpp"
#include "hawser/run/feeder_nodes.hpp"

namespace hawser::run {

// After an accepted step: the ranks agree on the feeders; `record` is called with the state before the
// events, for outputs; events that are due act, and `report` receives one sentence for each; feeders release
// and absorb nodes. Throws SolveError as FeederNodes::transfer_node, and if an action is
// impossible. Collective.
void act_after_step(Events& events, FeederNodes& feeder_nodes, const std::function<void()>& record,
                    const std::function<void(const std::string&)>& report);

}  // namespace hawser::run
