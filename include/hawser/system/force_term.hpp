// Every physical effect is one ForceTerm: it reads the trial kinematics and adds to the residual and its
// derivatives. Further abilities of a term are roles (roles.hpp). Sign: the residual is inertia + internal -
// external, so an applied force F adds -F.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "hawser/state/kinematics.hpp"
#include "hawser/system/assembler.hpp"
#include "hawser/system/checkpoint_record.hpp"
#include "hawser/system/field_registry.hpp"
#include "hawser/system/roles.hpp"

namespace hawser {

// Sums over the objects that this rank counts, J. All but the first three accumulate over the accepted steps.
struct Energy {
  double kinetic = 0, strain = 0, potential = 0;
  double friction = 0, damping = 0;  // dissipated by friction, by damping
  double work =
      0;  // by forces from outside: moving bodies, feeders, loads with a ramp, waves, current and wind
  double unresolved = 0;  // taken by the time integration from axial vibration that is too fast for its steps
  double by_water = 0;    // part of `work` done by moving water and drag

  Energy& operator+=(const Energy& o) {
    kinetic += o.kinetic;
    strain += o.strain;
    potential += o.potential;
    friction += o.friction;
    damping += o.damping;
    work += o.work;
    unresolved += o.unresolved;
    by_water += o.by_water;
    return *this;
  }
};

class ForceTerm {
 public:
  virtual ~ForceTerm() = default;
  // Key of the term's records in checkpoints, and its name in -log_view. A key that has been released stays
  // as it is, because a restart finds the records by it.
  virtual std::string_view checkpoint_key() const = 0;

  // Stores what the term needs of the state `from`, from which the coming trials depart. In dynamics that is
  // the last accepted state, and h [s] the longest step that may be tried. In statics it is the state that
  // the search has reached, before every iteration, and h = 0. Several calls may precede a trial; none
  // changes the committed history. May communicate.
  virtual void prepare(const Kinematics& /*from*/, double /*h*/) {}

  // Adds force and tangent at the trial state. Local and repeatable: it only reads committed history.
  virtual void evaluate(const Kinematics& trial, Assembler& assembler) = 0;

  // Called when a state is accepted: its history becomes the committed history. In statics that is the
  // equilibrium; with friction in dynamic relaxation, every step.
  virtual void commit(const Kinematics& /*accepted*/) {}

  // In statics and at the start of the motion: of any state, for example a trial whose sum of strain and
  // potential the line search compares with that of another since the same prepare(). At the end of a step
  // (Kinematics::ends_step): of the accepted state only, because contact then has the energy that commit()
  // has stored.
  virtual Energy energy(const Kinematics&) const { return {}; }
  virtual void fields(FieldRegistry&) const {}

  // The kinds of checkpoint records of the term, the same on all ranks.
  virtual std::vector<CheckpointKind> checkpoint_kinds() const { return {}; }
  // Committed history of the owned nodes in the range. Checkpoints are written in parts, one range at a time.
  virtual std::vector<CheckpointRecord> checkpoint_records(NodeRange) const { return {}; }
  // All of them in the order of a checkpoint.
  std::vector<CheckpointRecord> save() const {
    std::vector<CheckpointRecord> all = checkpoint_records({});
    std::ranges::stable_sort(all, {}, checkpoint_place);
    return all;
  }
  // Restores the committed history from the records of the owned nodes, in the order of a checkpoint.
  virtual void restore(const std::vector<CheckpointRecord>&) {}
};

}  // namespace hawser
