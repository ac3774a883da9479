// Roles of force terms in the course of a run; system/roles.hpp has those in the equations. System::with()
// lists the terms that have a role.
#pragma once

#include <string>
#include <vector>

#include "hawser/math/types.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/field.hpp"

namespace hawser {

// Has friction, which the first stage of statics switches off.
class HasFriction {
 public:
  virtual ~HasFriction() = default;
  // While it is off no slip is stored.
  virtual void enable_friction(bool on) = 0;
};

// Acts differently in statics, which can hold bodies with mass where they start.
class RestrainedInStatics {
 public:
  virtual ~RestrainedInStatics() = default;
  // friction: contact has it in statics.
  virtual void hold(bool on, bool friction) = 0;
};

// Depends on the current of the water.
class InCurrent {
 public:
  virtual ~InCurrent() = default;
  // The factor of the current velocities of the case.
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

// The part of the force on a body that has one origin, such as waves: at its centre of mass, axes of space.
struct BodyForce {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  // N, N m
};

// Acts on floating bodies and can state its forces.
class ActsOnBodies {
 public:
  virtual ~ActsOnBodies() = default;
  // The origins of the forces on a body of the case, equal on all ranks; none: the term does not act on it.
  virtual std::vector<std::string> origins(int body) const = 0;
  // One for each of them, in an accepted state, on the rank that owns the body.
  virtual std::vector<BodyForce> forces_on(int body, const Kinematics& at) const = 0;
};

}  // namespace hawser
