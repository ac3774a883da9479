// The order of the actions after an accepted step.
#include "hawser/run/step_actions.hpp"

namespace hawser::run {

void act_after_step(Events& events, FeederNodes& feeder_nodes, const std::function<void()>& record,
                    const std::function<void(const std::string&)>& report) {
  feeder_nodes.agree();
  record();
  for (const std::string& e : events.apply_due()) report(e);
  feeder_nodes.transfer_node();
}

}  // namespace hawser::run
