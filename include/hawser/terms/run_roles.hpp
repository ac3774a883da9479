// What a force term may be beside a force in the course of a run, as system/roles.hpp has it for the
// equations. System::with() lists those who have a role.
#pragma once

#include <string>
#include <vector>

#include "hawser/math/types.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/field.hpp"

namespace hawser {

// Has friction, which statics begins without.
class HasFriction {
 public:
  virtual ~HasFriction() = default;
  // While off no slip is kept.
  virtual void enable_friction(bool on) = 0;
};

// Acts otherwise in statics, where bodies with mass stay near the place where they start.
class RestrainedInStatics {
 public:
  virtual ~RestrainedInStatics() = default;
  // friction: contact has it in statics.
  virtual void hold(bool on, bool friction) = 0;
};

// Is in the water's current.
class InCurrent {
 public:
  virtual ~InCurrent() = default;
  // What the velocities of the case are multiplied by.
  virtual void scale_current(double factor) = 0;
};

// A named row of numbers at every step, beside the fields of nodes.
struct Series {
  std::string name;
  std::vector<Field> columns;  // name, unit and components
};

// Has rows of its own at every step.
class HasSeries {
 public:
  virtual ~HasSeries() = default;
  virtual std::vector<Series> series() const = 0;  // the same on all ranks
  // A row for each of them in an accepted state, with all components of its columns; empty on all ranks but
  // one.
  virtual std::vector<std::vector<double>> rows(const Kinematics& at) const = 0;
};

// A force on a body by what it comes from: on its centre of mass and about it, axes of space.
struct BodyForce {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  // N, N m
};

// Acts on floating bodies and can state its forces.
class ActsOnBodies {
 public:
  virtual ~ActsOnBodies() = default;
  // What forces on a body of the case come from, the same on all ranks; none: it does not act on it.
  virtual std::vector<std::string> origins(int body) const = 0;
  // One for each of them, in an accepted state, on the rank that owns the body.
  virtual std::vector<BodyForce> forces_on(int body, const Kinematics& at) const = 0;
};

}  // namespace hawser
