// The direction of a line at its nodes.
#pragma once

#include <cmath>
#include <vector>

#include "hawser/math/angle_between.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser {

class LineNeighbours {
 public:
  explicit LineNeighbours(const LocalMesh& mesh) {
    before_.resize(mesh.owned);
    for (size_t n = 0; n < before_.size(); ++n) before_[n] = static_cast<int>(n);
    after_ = before_;
    for (const LocalElement& e : mesh.elements) {
      if (e.first < mesh.owned) after_[e.first] = e.second;
      if (e.second < mesh.owned) before_[e.second] = e.first;
    }
  }

  // Unit direction from the node before an owned node to the node after it; one-sided at an end.
  Vec3 tangent(const Kinematics& state, int node) const {
    const Vec3 chord = state.x[after_[node]] - state.x[before_[node]];
    const double length = chord.norm();
    return length > 0 ? Vec3(chord / length) : Vec3::UnitX();
  }

  // Angle [rad] between the elements before and after an owned node; 0 at an end.
  double turn(const Kinematics& state, int node) const {
    const Vec3 in = state.x[node] - state.x[before_[node]];
    const Vec3 out = state.x[after_[node]] - state.x[node];
    return angle_between(in, out);
  }

 private:
  std::vector<int> before_, after_;  // neighbouring local nodes, by owned node
};

}  // namespace hawser
