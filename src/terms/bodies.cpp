#include "hawser/terms/bodies.hpp"

#include "hawser/model/body_motion.hpp"

namespace hawser {

Bodies::Bodies(const std::vector<model::Body>& bodies) {
  for (const model::Body& b : bodies) motions_.push_back(model::rigid_motion(b));
}

}  // namespace hawser
