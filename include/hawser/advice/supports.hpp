// Sentences about supports of laid lines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hawser/kernels/motion.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/supports.hpp"

namespace hawser::advice {

// A line that starts below the rollers that it should lie on: one sentence with the remedy, and its key,
// which is that of the support that is out of line with its neighbours, if one is. nullopt: none does. poses:
// of the bodies.
struct BelowSupport {
  std::string key, why;
};
std::optional<BelowSupport> below_supports(const model::Case& c,
                                           const std::vector<model::SupportCrossing>& crossings,
                                           const std::vector<RigidPose>& poses);

// A line past the end of a box's rollers, at a time [s].
std::string off_rollers(const model::SupportBox& box, const model::SupportCrossing& at, double time);
// A box that never carries its line, which lies on others further on; height [m] of the line above it,
// infinite: it did not cross it.
std::string never_carries(const model::SupportBox& box, double height);
std::string none_carries(const std::string& line);

}  // namespace hawser::advice
