// How far the axis of an element is from a surface, along it.
#pragma once

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/axis_shape.hpp"
#include "hawser/kernels/contact_stretches.hpp"
#include "hawser/kernels/motion.hpp"

namespace hawser {

// Less `most` [m]: contact_stretches() finds where it is nearer than that, or deeper inside than -most.
class AxisDistance final : public AxisGapFunction {
 public:
  AxisDistance(const Surface& surface, const RigidPose& pose, const AxisShape& shape, double most = 0)
      : surface_(surface), pose_(pose), shape_(shape), most_(most) {}
  AxisGap at(double xi, double within) override {
    const auto p = surface_.query(pose_.to_body(shape_.point(xi)), within + most_, hint_);
    if (!p) return {within, 0};
    hint_ = p->triangle;
    return {p->distance - most_, (pose_.rotation * p->normal).dot(shape_.slope(xi))};
  }

 private:
  const Surface& surface_;
  const RigidPose& pose_;
  const AxisShape& shape_;
  double most_;
  int hint_ = -1;
};

}  // namespace hawser
