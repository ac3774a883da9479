#include "hawser/terms/bodies.hpp"

#include "hawser/model/body_motion.hpp"
#include "hawser/terms/rigid_bodies.hpp"

namespace hawser {

Bodies::Bodies(const std::vector<model::Body>& bodies) {
  for (const model::Body& b : bodies) motions_.push_back(model::rigid_motion(b));
}

void Bodies::in_state(const model::Case& c, const LocalMesh& mesh) {
  mesh_ = &mesh;
  frames_.assign(c.bodies.size(), {});
  for (size_t b = 0; b < c.bodies.size(); ++b)
    if (c.bodies[b].mass) frames_[b] = {mesh.mesh->body_node(static_cast<int>(b)), c.bodies[b].mass->centre};
}

RigidPose Bodies::pose(int body, const Kinematics& at) const {
  if (!floats(body)) return pose(body, at.time);
  return floating_pose(floating_state(at, local_node(body)), frames_[static_cast<size_t>(body)].centre);
}

}  // namespace hawser
