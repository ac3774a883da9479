// Axis of an element, cubic for beams and straight for cables, and its attachment to the nodes.
#include "hawser/kernels/axis_shape.hpp"

namespace hawser {

AxisShape::AxisShape(const AxisEnds& e) : count_(e.beam ? 4 : 2), length_(e.length), c_(e.tangent) {
  X_.fill(Vec3::Zero());
  V_.fill(Vec3::Zero());
  if (!e.beam) {
    X_[0] = e.x1;
    X_[1] = e.x2;
    V_[0] = e.v1;
    V_[1] = e.v2;
    slope_bound_ = (e.x2 - e.x1).norm();
    return;
  }
  q_ = {e.q1, e.q2};
  R_ = {e.q1.toRotationMatrix(), e.q2.toRotationMatrix()};
  w_ = {e.w1, e.w2};
  X_ = {e.x1, length_ * (R_[0] * c_), e.x2, length_ * (R_[1] * c_)};
  V_ = {e.v1, length_ * (R_[0] * e.w1.cross(c_)), e.v2, length_ * (R_[1] * e.w2.cross(c_))};
  // |H1'| <= 3/2 on the chord, |H2'|, |H4'| <= 1 at the ends and small where the other is large.
  slope_bound_ = 1.5 * (e.x2 - e.x1).norm() + length_;
  const double straight = (X_[2] - X_[0]).norm();
  const double bend = std::max((X_[1] - (X_[2] - X_[0])).norm(), (X_[3] - (X_[2] - X_[0])).norm());
  // slope = chord + H2'(X1 - chord) + H4'(X3 - chord), and |H2'| + |H4'| <= 1
  slope_bound_ = std::min(slope_bound_, straight + bend);
}

BezierAxis AxisShape::bezier() const {
  if (count_ == 2) return BezierAxis::straight(X_[0], X_[1]);
  return {{X_[0], X_[0] + X_[1] / 3, X_[2] - X_[3] / 3, X_[2]}};
}

void AxisShape::attach(Stencil& to, size_t first_turn) const {
  for (size_t k = 0; k < 2; ++k) {
    to.add({to.blocks++, -1, {}});
    if (count_ == 2) continue;
    to.turns[first_turn + k] = {-1, to.blocks, {.R = R_[k]}};
    to.add({-1, to.blocks++, {length_ * c_, R_[k], w_[k]}});
  }
}

}  // namespace hawser
