// What a force term may be beside a force. A term that takes a role on inherits it as well; System keeps a
// list of those who have it. The order in which terms were added means nothing but to fields, which may build
// on those of a term before (FieldSource::onto).
#pragma once

#include <span>

#include "hawser/kernels/impact.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/couplings.hpp"
#include "hawser/system/verdict.hpp"

namespace hawser {

// Couples nodes that no element joins (contact of lines with lines and with bodies).
class CouplesNodes {
 public:
  virtual ~CouplesNodes() = default;
  // Before a step of length h [s] (0: statics) and before prepare(). Collective; local nodes of the time
  // before count. True: couple() or what was kept by local node is no longer what it was; update_ghosts()
  // follows.
  virtual bool recouple(const Kinematics& committed, double h) = 0;
  // Adds the coupled nodes of those groups of which this rank owns a node.
  virtual void couple(Couplings& to) const = 0;
  // Those nodes are local ones now; local nodes from LocalMesh::chain on are no longer what they were.
  virtual void update_ghosts() {}
};

// Says how long a step may be, and whether a converged one can be trusted.
class LimitsSteps {
 public:
  virtual ~LimitsSteps() = default;
  // Longest step from here, and the impacts, each once over all ranks; asked after prepare(). Steps that the
  // user fixed are divided by it where impacts are to be resolved.
  virtual void limit_step(const Kinematics& committed, ImpactEvents& to) const = 0;
  // Of a converged step or a trial of statics, on this rank: tunnelling, penetration beyond what a law is
  // for, candidates that are out of date.
  virtual Verdict check_step(const Kinematics& trial) const = 0;
  // Adds the impacts that a converged step did not resolve, each once over all ranks; local. Asked before it
  // is accepted.
  virtual void unresolved(const Kinematics& trial, UnresolvedImpacts& to) {
    (void)trial;
    (void)to;
  }
};

// A penalty stiffness that follows what the run meets. evaluate() never changes it.
class RaisesStiffness {
 public:
  virtual ~RaisesStiffness() = default;
  // From an equilibrium, raises it where that asks for it and says so (solve again). Collective.
  virtual bool raise_stiffness(const Kinematics& equilibrium) = 0;
  // In statics, raises the stiffness where it is too low to keep a line out of a volume on the path to that
  // trial.
  // Collective.
  virtual bool raise_stiffness_where_blocked(const Kinematics& trial) = 0;
  // Reverts the stiffness to that of the last commit, before a step is tried (again).
  virtual void revert_stiffness() = 0;
};

// Acts on the elements of lines, so that forces at their ends can be computed.
class ActsOnElements {
 public:
  virtual ~ActsOnElements() = default;
  // Adds what this term has in the residual of a local element, from the state alone: f[12] = (x1, theta1,
  // x2, theta2), forces in space axes [N], moments in material axes [N m]; of cables no moments.
  virtual void element_force(const Kinematics& at, const LocalElement& e, double* f) const = 0;
};

// Has mass on lines.
class MovesMasses {
 public:
  virtual ~MovesMasses() = default;
  // Adds what this rank counts of the masses that move, by line of the mesh.
  virtual void motion(const Kinematics& at, std::span<LineMotion> lines) const = 0;
};

// The element that is stretched (or pressed) furthest beyond what its law can mean.
struct Overstretch {
  double beyond = 0;            // of the strain; 0: none is
  int node = -1;                // of the mesh, at its first end
  double strain = 0, most = 0;  // and what is borne, both signed
  double tension = 0, EA = 0;   // N
};

// Of a line: the largest tension, round-off in one, and EA, N.
struct LineTension {
  double tension = 0, round_off = 0, EA = 0;
};

// Carries the tension of lines.
class CarriesTension {
 public:
  virtual ~CarriesTension() = default;
  // Axial stiffness is at most this, N, and nothing yields, until it is called again (HUGE_VAL: as it truly
  // is): statics starts soft, where a very stiff line would have to creep along a narrow valley of its
  // energy, and elastic, where the bends of a shape far from rest would leave sections that yield hardly any
  // stiffness. Whether that changes anything on this rank.
  virtual bool soften(double most) = 0;
  // Largest EA, N, of this rank; 0: none.
  virtual double axial_stiffness() const = 0;
  // The worst overstretched element of this rank, if there is one.
  virtual Overstretch overstretched(const Kinematics& at) const = 0;
  // Raises what `lines`, one for each line of the mesh, have to what this rank's elements have.
  virtual void tensions(const Kinematics& at, std::span<LineTension> lines) const = 0;
};

// Provides the size of forces, which a residual is compared with.
class ScalesResiduals {
 public:
  virtual ~ScalesResiduals() = default;
  // Sum of squares, N², of the round-off in the forces on this rank, in a try of a step h [s] (0: statics):
  // no residual can be smaller.
  virtual double round_off(const Kinematics& at, double h) const {
    (void)at;
    (void)h;
    return 0.0;
  }
  // Sum of the sizes of the dead loads on this rank, N.
  virtual double dead_load() const { return 0; }
};

}  // namespace hawser
