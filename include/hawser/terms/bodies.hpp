// The bodies of a case and where they are at any time.
#pragma once

#include <vector>

#include "hawser/kernels/motion.hpp"
#include "hawser/model/case.hpp"

namespace hawser {

class Bodies {
 public:
  Bodies() = default;
  explicit Bodies(std::vector<RigidMotion> motions) : motions_(std::move(motions)) {}
  // Throws std::invalid_argument for a motion that makes no sense (model::check has refused it before).
  explicit Bodies(const std::vector<model::Body>& bodies);

  int size() const { return static_cast<int>(motions_.size()); }
  // body < 0: fixed in space, the identity.
  RigidPose pose(int body, double time) const {
    return body < 0 ? RigidPose{} : motions_[static_cast<size_t>(body)].at(time);
  }
  bool moves(int body) const { return body >= 0 && motions_[static_cast<size_t>(body)].moves(); }

 private:
  std::vector<RigidMotion> motions_;
};

}  // namespace hawser
