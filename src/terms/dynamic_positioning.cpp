// The class DynamicPositioning: forces at rest and in motion, limits, integral, work and checkpoint records.
#include "hawser/terms/dynamic_positioning.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/kernels/frame_point.hpp"
#include "hawser/kernels/platform_frame.hpp"
#include "hawser/math/heading.hpp"
#include "hawser/terms/rigid_bodies.hpp"

namespace hawser {
namespace {

// In statics, degrees of freedom with an integral part are held by kHeld times their proportional part. The
// offset is then a thousandth of that with the proportional part alone, and the integral begins with the
// difference.
constexpr double kHeld = 1000;
// A force on the ellipse of the limits up to rounding, as after statics, is limited: its integral is
// constant.
constexpr double kOnEllipse = 1 - 1e-9;

}  // namespace

DynamicPositioning::DynamicPositioning(const model::Case& c, const LocalMesh& mesh)
    : statics_(c.statics.enabled) {
  for (const model::Body& b : c.bodies) has_.push_back(b.mass && b.mass->positioning);
  for (int n = 0; n < mesh.owned; ++n) {
    const int body = mesh.node(n).body;
    if (body < 0 || !has_[static_cast<size_t>(body)]) continue;
    const model::Body& b = c.bodies[body];
    Positioned p;
    p.data = *b.mass->positioning;
    const Vec3 place = p.data.place.value_or(b.position);
    p.target << place.x(), place.y(), p.data.heading.value_or(heading_of(exp_so3(b.rotation)).angle);
    p.arm = -b.mass->centre;
    p.node = n;
    p.block = mesh.block[n];
    p.global = mesh.global[n];
    p.body = body;
    list_.push_back(std::move(p));
  }
}

// The offset in yaw is taken the shorter way round.
Vec3 DynamicPositioning::offset(const Positioned& p, const Vec3& pose) {
  Vec3 e = pose - p.target;
  e.z() = std::remainder(e.z(), 2 * M_PI);
  return e;
}

// The limits keep the direction of the horizontal force A: A/q where q = |(A_x/X, A_y/Y)| > 1, with X and Y
// the largest forces in surge and sway alone; the derivative is (1 - A (A_x/X², A_y/Y²)/q²)/q. If only one of
// the two has an integral, its force is the remainder of the ellipse, A_x = X sqrt(1 - (A_y/Y)²), up to which
// it increases.
DynamicPositioning::Delivered DynamicPositioning::limited(const model::DynamicPositioning& data,
                                                          const Vec3& demand, int only_integral_axis) {
  Delivered out;
  out.force = demand;
  const Eigen::Vector2d inverse_limit = data.max_force.cwiseInverse();
  const Eigen::Vector2d plane = demand.head<2>();
  const double size = plane.cwiseProduct(inverse_limit).norm();
  out.force_limited = size > kOnEllipse;
  out.moment_limited = std::abs(demand.z()) > data.max_moment;
  if (out.force_limited) {
    const Eigen::Vector2d along = plane / size;
    const Eigen::Vector2d across = along.cwiseProduct(inverse_limit.cwiseAbs2());
    out.force.head<2>() = along;
    out.by_demand.topLeftCorner<2, 2>() = (Eigen::Matrix2d::Identity() - along * across.transpose()) / size;
  }
  if (out.moment_limited) {
    out.force.z() = std::copysign(data.max_moment, demand.z());
    out.by_demand(2, 2) = 0;
  }
  if (out.force_limited && only_integral_axis >= 0) {
    const int axis = only_integral_axis;
    const int other = 1 - axis;
    const double fraction = std::clamp(plane[other] * inverse_limit[other], -1.0, 1.0);
    const double remaining = std::sqrt(1 - fraction * fraction);
    const double end = std::copysign(1 / inverse_limit[axis], plane[axis]);
    out.force[other] = fraction / inverse_limit[other];
    out.force[axis] = remaining * end;
    out.by_demand.topLeftCorner<2, 2>().setZero();
    if (remaining > 0) {
      out.by_demand(other, other) = 1;
      out.by_demand(axis, other) = -fraction * inverse_limit[other] / remaining * end;
    }
  }
  return out;
}

// F = H limited(-(P H^T e + D H^T e' + I H^T s)), H: axes of the slow heading. With d H/d heading = J H,
// J = hat(z), and L the derivative of the limits:
//   dF = J F + H L (-(P a + D b + I c) H^T d(x, y, heading)
//                   + a (P J H^T e + D J H^T e' + I J H^T s) d heading)
// a, b, c: by_place, by_speed, by_sum; J F is multiplied by a as well.
DynamicPositioning::Thrust DynamicPositioning::thrust(const model::DynamicPositioning& data,
                                                      const Deviation& deviation, int only_integral_axis) {
  const Mat3 H = heading_axes(deviation.heading);
  const Mat3 J = hat(Vec3::UnitZ());
  const Vec3 e = H.transpose() * deviation.offset;
  const Vec3 rate = H.transpose() * deviation.speed;
  const Vec3 sum = H.transpose() * deviation.sum;
  const auto by_gains = [&](const Vec3& P, const Vec3& D, const Vec3& I) -> Vec3 {
    return P.cwiseProduct(data.proportional) + D.cwiseProduct(data.derivative) +
           I.cwiseProduct(data.integral);
  };
  Thrust out;
  out.demand = -by_gains(e, rate, sum);
  const Delivered delivered = limited(data, out.demand, only_integral_axis);
  out.force_limited = delivered.force_limited;
  out.moment_limited = delivered.moment_limited;
  out.force = H * delivered.force;
  const Vec3 gain = by_gains(Vec3::Constant(deviation.by_place), Vec3::Constant(deviation.by_speed),
                             Vec3::Constant(deviation.by_sum));
  out.by_pose = -H * delivered.by_demand * gain.asDiagonal() * H.transpose();
  out.by_pose.col(2) +=
      deviation.by_place * (J * out.force + H * (delivered.by_demand * by_gains(J * e, J * rate, J * sum)));
  return out;
}

// For motion about rest limits are ignored: a force at its limit has a one-sided derivative only.
DynamicPositioning::Thrust DynamicPositioning::thrust_at_rest(const Positioned& p, const Vec3& pose) const {
  Deviation deviation;
  deviation.heading = pose.z();
  deviation.offset = offset(p, pose);
  model::DynamicPositioning data = p.data;
  int only_integral_axis = -1;
  if (!integrates_) {
    deviation.sum = p.integral;
    data.max_force.setConstant(HUGE_VAL);
    data.max_moment = HUGE_VAL;
  } else if (statics_) {
    for (int k = 0; k < 3; ++k)
      if (data.integral[k] > 0) data.proportional[k] *= kHeld;
    if ((data.integral[0] > 0) != (data.integral[1] > 0)) only_integral_axis = data.integral[0] > 0 ? 0 : 1;
  }
  return thrust(data, deviation, only_integral_axis);
}

// The integral is continued from the last accepted state by the trapezoidal rule.
DynamicPositioning::Thrust DynamicPositioning::thrust_in_motion(const Positioned& p, const Vec3& pose,
                                                                double time) {
  const double h = time - p.time;
  const ControllerPose slow = h > 0 ? p.slow.after(pose, h, p.data.filter) : p.slow;
  const ControllerPose::Derivatives weights =
      h > 0 ? ControllerPose::derivatives(h, p.data.filter) : ControllerPose::Derivatives{};
  Deviation deviation;
  deviation.heading = slow.place.z();
  deviation.offset = offset(p, slow.place);
  deviation.speed = slow.speed;
  deviation.sum = p.integral + 0.5 * h * (offset(p, p.slow.place) + deviation.offset);
  deviation.by_place = weights.place;
  deviation.by_speed = weights.speed;
  deviation.by_sum = 0.5 * h * weights.place;
  return thrust(p.data, deviation);
}

DynamicPositioning::Thrust DynamicPositioning::thrust(const Positioned& p, const Kinematics& state) const {
  const Vec3 pose = place_and_heading(p.arm, floating_state(state, p.node));
  return state.moves() ? thrust_in_motion(p, pose, state.time) : thrust_at_rest(p, pose);
}

void DynamicPositioning::begin(Positioned& p, const Vec3& pose, double time) {
  p.slow = ControllerPose::at(pose);
  p.time = time;
  p.begun = true;
}

std::vector<std::string> DynamicPositioning::load_components(int body) const {
  if (!has_[static_cast<size_t>(body)]) return {};
  return {"thrusters"};
}

std::vector<BodyForce> DynamicPositioning::forces_on(int body, const Kinematics& state) const {
  std::vector<BodyForce> out;
  for (const Positioned& p : list_) {
    if (p.body != body) continue;
    const Vec3 f = thrust(p, state).force;
    const Vec3 force(f.x(), f.y(), 0);
    out.push_back({force, (floating_state(state, p.node).q * p.arm).cross(force) + Vec3(0, 0, f.z())});
  }
  return out;
}

DynamicPositioning::WorkPoint DynamicPositioning::work_point(const Positioned& p, const Kinematics& state,
                                                             const Thrust& now) {
  const RigidBodyState s = floating_state(state, p.node);
  return {now.force, s.x + s.q * p.arm, s.q};
}

double DynamicPositioning::work(const WorkPoint& from, const WorkPoint& to) {
  Vec3 displacement = to.origin - from.origin;
  displacement.z() = log_so3(to.rotation * from.rotation.conjugate()).z();
  return 0.5 * (from.force + to.force).dot(displacement);
}

// Without statics the integral begins at zero.
void DynamicPositioning::prepare(const Kinematics& from, double) {
  for (Positioned& p : list_) {
    const Vec3 pose = place_and_heading(p.arm, floating_state(from, p.node));
    if (from.moves() && !p.begun) begin(p, pose, from.time);
    p.last = work_point(p, from, thrust(p, from));
  }
}

// Residual on the body's unknowns from the force at the origin and the moment about the vertical:
//   f = -P F,   P = (e_x, e_y, 0; y x R^T e_x, y x R^T e_y, R^T z).
// The pose depends on the unknowns by Q: the first two rows of P^T and the derivative of the heading.
void DynamicPositioning::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (const Positioned& p : list_) {
    const RigidBodyState s = floating_state(trial, p.node);
    const FramePoint at{p.arm, s.q.toRotationMatrix(), Vec3::Zero()};
    const Thrust now = thrust(p, trial);
    const Vec3 pull(-now.force.x(), -now.force.y(), 0);
    const Vec3 up = at.R.transpose().col(2);
    Eigen::Matrix<double, 6, 3> P = Eigen::Matrix<double, 6, 3>::Zero();
    P.topLeftCorner<2, 2>().setIdentity();
    P.col(0).tail<3>() = at.moment(Vec3::UnitX());
    P.col(1).tail<3>() = at.moment(Vec3::UnitY());
    P.col(2).tail<3>() = up;
    Eigen::Matrix<double, 3, 6> Q = P.transpose();
    Q.row(2).tail<3>() = heading_of(s.q).by_turn.transpose();
    const Vec6 f = -P * now.force;
    Mat6 K = -P * now.by_pose * Q;
    K.bottomRightCorner<3, 3>() += at.moment_by_turn(pull) - now.force.z() * hat(up);
    const int blocks[2] = {p.block, p.block + 1};
    assembler.add(blocks, f, K);
  }
}

// After statics the integral is set to the force that holds the body at rest. Where the thrusters are at
// their limit, it does not grow further.
void DynamicPositioning::commit(const Kinematics& accepted) {
  for (Positioned& p : list_) {
    const Vec3 pose = place_and_heading(p.arm, floating_state(accepted, p.node));
    const Thrust now = thrust(p, accepted);
    if (!accepted.moves()) {
      const Mat3 H = heading_axes(pose.z());
      Vec3 sum = Vec3::Zero();
      const Vec3 e = H.transpose() * offset(p, pose);
      const Vec3 delivered = H.transpose() * now.force;
      for (int k = 0; statics_ && k < 3; ++k)
        if (p.data.integral[k] > 0)
          sum[k] = -(delivered[k] + p.data.proportional[k] * e[k]) / p.data.integral[k];
      p.integral = H * sum;
      begin(p, pose, accepted.time);
      continue;
    }
    p.work += work(p.last, work_point(p, accepted, now));
    const double h = accepted.time - p.time;
    const Vec3 before = offset(p, p.slow.place);
    p.slow = p.slow.after(pose, h, p.data.filter);
    p.time = accepted.time;
    Vec3 integral_increment = 0.5 * h * (before + offset(p, p.slow.place));
    const Vec3 integral_demand =
        -p.data.integral.cwiseProduct(heading_axes(p.slow.place.z()).transpose() * integral_increment);
    if (now.force_limited && integral_demand.head<2>().dot(now.demand.head<2>()) > 0)
      integral_increment.head<2>().setZero();
    if (now.moment_limited && integral_demand.z() * now.demand.z() > 0) integral_increment.z() = 0;
    p.integral += integral_increment;
  }
}

// In statics, the potential includes the work since the last iteration.
Energy DynamicPositioning::energy(const Kinematics& state) const {
  Energy e;
  for (const Positioned& p : list_) {
    e.work += p.work;
    if (!state.moves()) e.potential -= work(p.last, work_point(p, state, thrust(p, state)));
  }
  return e;
}

namespace {

struct KeptThrust {
  ControllerPose slow;
  Vec3 integral = Vec3::Zero();
  double time = 0, work = 0;
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    ControllerPose::quantities(self.slow, each);
    each("integral of the offset", "m s, rad s", self.integral);
    each("time", "s", self.time);
    each("work", "J", self.work);
  }
};

}  // namespace

std::vector<CheckpointKind> DynamicPositioning::checkpoint_kinds() const {
  return {checkpoint_kind<KeptThrust>("dynamic positioning")};
}

std::vector<CheckpointRecord> DynamicPositioning::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> out;
  for (const Positioned& p : list_)
    if (p.begun && range.has(p.global))
      out.push_back(record_of(p.global, 0, KeptThrust{p.slow, p.integral, p.time, p.work}, 0));
  return out;
}

void DynamicPositioning::restore(const std::vector<CheckpointRecord>& records) {
  for (Positioned& p : list_) {
    p.begun = false;
    p.work = 0;
    p.integral.setZero();
    const auto kept = find_entry<KeptThrust>(records, p.global);
    if (!kept) continue;
    p.slow = kept->slow;
    p.integral = kept->integral;
    p.time = kept->time;
    p.work = kept->work;
    p.begun = true;
  }
}

}  // namespace hawser
