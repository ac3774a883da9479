// What the files of BodyContactTerm share: the sum over what touches of a pair.
#pragma once

#include <algorithm>

#include "hawser/terms/body_contact.hpp"

namespace hawser {

// What a pair does in a state.
struct BodyContactTerm::Sum {
  BodyContact contact;
  double potential = 0, damping_power = 0;  // J, W
  double depth = 0;                         // m, largest penetration
  bool touches = false;
  bool springs = false;             // also:
  Vec12 elastic = Vec12::Zero();    // residual without damping
  Mat12 stiffness = Mat12::Zero();  // of the springs, where they stand

  explicit Sum(bool with_springs = false) : springs(with_springs) {}
  void add(const BodyContactPoint& p, double weight) {
    touches = touches || p.law.elastic > 0;
    potential += weight * p.law.potential;
    damping_power += weight * (p.law.elastic - p.law.force) * p.rate;
    depth = std::max(depth, -p.gap);
    if (!springs || !(p.law.elastic > 0)) return;
    elastic -= weight * p.law.elastic * p.gradient;
    stiffness += weight * std::max(-p.law.by_gap, 0.0) * p.gradient * p.gradient.transpose();
  }
};

}  // namespace hawser
