// Messages about supports of laid lines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hawser/kernels/motion.hpp"
#include "hawser/model/case.hpp"
#include "hawser/model/supports.hpp"

namespace hawser::advice {

// A line that starts below the rollers that should carry it: a sentence with the remedy, and its key, that of
// the support out of line with its neighbours if there is one. nullopt: no such line. poses: of the bodies.
struct BelowSupport {
  std::string key, why;
};
std::optional<BelowSupport> below_supports(const model::Case& c,
                                           const std::vector<model::SupportCrossing>& crossings,
                                           const std::vector<RigidPose>& poses);

// A line beyond the end of a box's rollers at a time [s].
std::string off_rollers(const model::SupportBox& box, const model::SupportCrossing& at, double time);
// A box that never carries its line, although later boxes do; height [m] of the line above it, infinite: the
// line did not cross it.
std::string never_carries(const model::SupportBox& box, double height);
std::string none_carries(const std::string& line);

}  // namespace hawser::advice
