// Every physical effect is one ForceTerm: it reads the trial kinematics and adds to the residual and its
// derivatives. What a term may be beside that, it takes on as a role (roles.hpp). Sign: the residual is
// inertia + internal - external, so an applied force F adds -F.
#pragma once

#include <string_view>
#include <vector>

#include "hawser/state/kinematics.hpp"
#include "hawser/system/assembler.hpp"
#include "hawser/system/field_registry.hpp"
#include "hawser/system/history.hpp"
#include "hawser/system/roles.hpp"

namespace hawser {

// Sums over what this rank counts, J. All but the first three are accumulated over the accepted steps.
struct Energy {
  double kinetic = 0, strain = 0, potential = 0;
  double friction = 0, damping = 0,
         work = 0;        // taken out by friction, by damping; brought in by moving bodies
  double unresolved = 0;  // taken by the time integration out of axial vibration too fast for its steps
  double by_water = 0;    // the part of `work` that moving water and drag have done

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
  virtual std::string_view name() const = 0;

  // Once before a step of length h [s] is tried, from the last accepted state. May communicate.
  virtual void prepare(const Kinematics& committed, double h) {
    (void)committed;
    (void)h;
  }

  // Adds force and tangent at the trial state. Local, repeatable: reads committed history only.
  virtual void evaluate(const Kinematics& trial, Assembler& assembler) = 0;

  // The state is accepted: history that belongs to it becomes the committed history.
  virtual void commit(const Kinematics& accepted) { (void)accepted; }

  virtual Energy energy(const Kinematics& at) const {
    (void)at;
    return Energy{};
  }
  virtual void fields(FieldRegistry& registry) const { (void)registry; }

  // Committed history of the owned nodes, and back (records may arrive in any order); the kinds of record
  // there are, the same on all ranks.
  virtual std::vector<HistoryKind> history() const { return {}; }
  // Of these nodes: checkpoints are not made as a whole.
  virtual std::vector<HistoryRecord> records(NodeRange) const { return {}; }
  std::vector<HistoryRecord> save() const { return records({}); }
  virtual void restore(const std::vector<HistoryRecord>& records) { (void)records; }
};

}  // namespace hawser
