// Prescribed motion of a rigid body: pose, velocity and acceleration at any time, exact derivatives.
// x(t) = position + offset(t), R(t) = exp(psi(t)) R0; a rotation about a fixed axis is psi = angle(t) axis.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

// Pose and motion of a body. Velocities are those of the body's origin; all in space axes.
struct RigidPose {
  Vec3 position = Vec3::Zero();              // m
  Quat rotation = Quat::Identity();          // body axes to space axes
  Vec3 velocity = Vec3::Zero();              // m/s
  Vec3 acceleration = Vec3::Zero();          // m/s²
  Vec3 angular_velocity = Vec3::Zero();      // rad/s
  Vec3 angular_acceleration = Vec3::Zero();  // rad/s²

  Vec3 to_space(const Vec3& y) const { return position + rotation * y; }
  Vec3 to_body(const Vec3& x) const { return rotation.conjugate() * (x - position); }
  // Velocity and acceleration of the body's material point at x.
  Vec3 velocity_at(const Vec3& x) const { return velocity + angular_velocity.cross(x - position); }
  Vec3 acceleration_at(const Vec3& x) const {
    const Vec3 r = x - position;
    return acceleration + angular_acceleration.cross(r) + angular_velocity.cross(angular_velocity.cross(r));
  }
};

// A vector function of time with its first two derivatives.
struct VectorMotion {
  Vec3 value = Vec3::Zero(), rate = Vec3::Zero(), second = Vec3::Zero();
};

// Interpolation between the rows of a table. spline: natural cubic spline (continuous second derivative, may
// overshoot the rows). monotone: monotone cubic (continuous slope, no component leaves the range of the
// neighbouring rows: Fritsch & Carlson 1980, SIAM J. Numer. Anal. 17, slopes by Fritsch & Butland 1984).
// linear: straight lines (the slope jumps at the rows, where it is that of the following interval).
enum class BetweenRows { spline, monotone, linear };

// Piecewise cubic through rows (time [s], value) with exact derivatives, linear beyond its ends. One row:
// constant. No rows: zero.
class RowCurve {
 public:
  RowCurve() = default;
  // Throws std::invalid_argument if the times do not increase or the sizes differ.
  RowCurve(std::vector<double> time, std::vector<Vec3> value, BetweenRows between = BetweenRows::spline);
  VectorMotion at(double t) const;

  // Place where a component is farthest outside the range of two neighbouring rows.
  struct Overshoot {
    size_t row = 0;     // the first of the two, from 0
    int component = 0;  // of the value
    double time = 0;    // s
    double value = 0, excess = 0;
  };
  // One for each interval and component that leaves the range by more than `fraction` of the component's
  // range over all rows.
  std::vector<Overshoot> overshoots(double fraction) const;

  // Integrals over the rows of |x' - mean x'|² and |x''|², all components together. A jump d of the slope at
  // a row, as with linear interpolation, counts as a change over half of both intervals: d²/((h + h')/2).
  struct Activity {
    double rate = 0, second = 0;
  };
  Activity activity() const;

 private:
  void bend_spline();
  void bend_monotone();
  std::vector<double> time_;
  std::vector<Vec3> value_;
  std::vector<std::pair<Vec3, Vec3>> bend_;  // second derivatives at the start and end of each interval
};

// Velocity, and rotation rate about a space-fixed axis through the body's origin, started by the ramp.
struct SteadyLaw {
  Vec3 velocity = Vec3::Zero();  // m/s
  Vec3 axis = Vec3::UnitZ();     // any length but zero
  double rate = 0;               // rad/s
};

// amplitude * sin(2 pi t / period + phase) by component, times the ramp; rotation: a rotation vector.
struct HarmonicLaw {
  Vec3 amplitude = Vec3::Zero();           // m
  Vec3 rotation_amplitude = Vec3::Zero();  // rad
  double period = 1;                       // s
  Vec3 phase = Vec3::Zero();               // rad
  Vec3 rotation_phase = Vec3::Zero();      // rad
};

// Offset [m] and rotation vector [rad] from tables. Multiplied by the ramp.
struct TableLaw {
  RowCurve offset, rotation;
};

using MotionLaw = std::variant<std::monostate, SteadyLaw, HarmonicLaw, TableLaw>;

// Slow motion that carries the body with its other motion: the sum of three motions; the rotations are
// rotation vectors.
struct DriftLaw {
  Vec3 offset = Vec3::Zero(), rotation = Vec3::Zero();  // m, rad
  HarmonicLaw harmonic;
  TableLaw table;
  double ramp = 0;  // s, of the sum
  // Offset [m] and rotation vector [rad] at t >= 0.
  void at(double t, VectorMotion& moved, VectorMotion& turned) const;
};

class RigidMotion {
 public:
  RigidMotion() = default;
  // position [m] and rotation vector [rad] of the body without its motion, ramp [s] (0: immediate start).
  // Throws std::invalid_argument for a zero axis or an invalid period or ramp.
  RigidMotion(const Vec3& position, const Vec3& rotation, MotionLaw law = {}, double ramp = 0);

  // Adds a drift: `law` acts in the axes that the drift moves and rotates, x = position + d + D u, R = D
  // exp(psi) R0. Throws std::invalid_argument as above.
  void set_drift(DriftLaw drift);

  // The same motion of a body at another position [m]; both share the memory of everything else.
  RigidMotion from(const Vec3& position) const;

  // For t < 0 the body rests where it is at t = 0.
  RigidPose at(double t) const;
  bool moves() const { return about_->law.index() != 0 || about_->drift; }

 private:
  // The motion but for the position.
  struct About {
    Quat rotation = Quat::Identity();
    MotionLaw law;
    double ramp = 0;
    std::optional<DriftLaw> drift;
  };
  Vec3 position_ = Vec3::Zero();
  std::shared_ptr<const About> about_ = std::make_shared<const About>();
};

// The quintic step 10 z³ - 15 z⁴ + 6 z⁵ of z = t / duration: value, first and second derivative in time, and
// integral from 0 to t. duration 0: the unit step.
struct Ramp {
  double value = 1, rate = 0, second = 0, integral = 0;
};
Ramp quintic_ramp(double t, double duration);

// Spatial angular velocity and acceleration of exp(psi(t)): omega = J_l psi', alpha = J_l psi'' + J_l' psi',
// J_l = I + a hat(psi) + b hat(psi)², a = (1 - cos p)/p², b = (p - sin p)/p³.
void angular_rates(const VectorMotion& psi, Vec3& omega, Vec3& alpha);

}  // namespace hawser
