// Roles of force terms in the course of a run; roles in the equations are in system/roles.hpp. System::with()
// lists the terms with a role.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "hawser/math/types.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/field.hpp"

namespace hawser {

// A term with friction, which the first phase of statics switches off.
class HasFriction {
 public:
  virtual ~HasFriction() = default;
  // While friction is off, no slip is stored.
  virtual void enable_friction(bool on) = 0;
};

// Loads bodies with mass from outside of the model: weight, springs, water, wind, thrusters. Lines, links and
// contact join bodies to something and do not have this role.
class AppliesExternalLoad {
 public:
  virtual ~AppliesExternalLoad() = default;
};

// A term that acts differently in statics, which may hold bodies with mass at their start.
class RestrainedInStatics {
 public:
  virtual ~RestrainedInStatics() = default;
  // computed: by body of the case, whether statics finds its equilibrium; it holds the others.
  void begin_statics(std::vector<bool> computed) {
    in_statics_ = true;
    computed_ = std::move(computed);
  }
  void end_statics() { in_statics_ = false; }

 protected:
  bool in_statics() const { return in_statics_; }
  // Whether statics holds this body of the case where it starts.
  bool is_held(int body) const { return in_statics_ && !computed_[static_cast<size_t>(body)]; }

 private:
  bool in_statics_ = false;
  std::vector<bool> computed_;
};

// A term for which not every equilibrium of statics is a valid result.
class ChecksRest {
 public:
  virtual ~ChecksRest() = default;
  // Throws SolveError on all ranks if the equilibrium, the state that was evaluated last, is not valid.
  // Collective.
  virtual void check_at_rest(const Kinematics& equilibrium) = 0;
};

// A term that depends on the current.
class InCurrent {
 public:
  virtual ~InCurrent() = default;
  // Sets the factor on the current velocities of the case.
  virtual void scale_current(double factor) = 0;
};

// A named row of numbers at every step, in addition to nodal fields.
struct Series {
  std::string name;
  std::vector<Field> columns;  // name, unit and components
};

// A term with output series.
class HasSeries {
 public:
  virtual ~HasSeries() = default;
  virtual std::vector<Series> series() const = 0;  // same on all ranks
  // One row for each series in an accepted state, with all components of its columns; empty on all ranks
  // except one.
  virtual std::vector<std::vector<double>> rows(const Kinematics& state) const = 0;
};

// Force on a body of one component of its load, such as waves, at the centre of mass, space axes.
struct BodyForce {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  // N, N m
};

// A term that acts on floating bodies and reports its forces.
class ReportsBodyForces {
 public:
  virtual ~ReportsBodyForces() = default;
  // Load components, such as "wave", that act on a body of the case, equal on all ranks; empty: the term does
  // not act on it.
  virtual std::vector<std::string> load_components(int body) const = 0;
  // One force for each load component in an accepted state, on the rank that owns the body.
  virtual std::vector<BodyForce> forces_on(int body, const Kinematics& state) const = 0;
};

}  // namespace hawser
