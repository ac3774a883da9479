// What a force term may be beside a force in the course of a run, as system/roles.hpp has it for the
// equations. System::with() lists those who have a role.
#pragma once

namespace hawser {

class Feeders;

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
  virtual void hold(bool on) = 0;
};

// Is in the water's current.
class InCurrent {
 public:
  virtual ~InCurrent() = default;
  // What the velocities of the case are multiplied by.
  virtual void scale_current(double factor) = 0;
};

// Acts on elements whose lengths feeders change.
class FedByFeeders {
 public:
  virtual ~FedByFeeders() = default;
  // Of lines that are paid out and hauled in; they outlive this. null: none is.
  virtual void fed_by(Feeders* feeders) = 0;
};

}  // namespace hawser
