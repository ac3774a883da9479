// Every physical effect is one ForceTerm: it reads the trial kinematics and adds to the residual and its
// derivatives. Sign: the residual is inertia + internal - external, so an applied force F adds -F.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hawser/kernels/impact.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/couplings.hpp"
#include "hawser/system/field_registry.hpp"
#include "hawser/system/history_record.hpp"
#include "hawser/system/sink.hpp"

namespace hawser {

// Sums over what this rank counts, J. All but the first three are accumulated over the accepted steps.
struct Energy {
  double kinetic = 0, strain = 0, potential = 0;
  double friction = 0, damping = 0,
         work = 0;        // taken out by friction, by damping; brought in by moving bodies
  double unresolved = 0;  // taken by the time integration out of axial vibration too fast for its steps

  Energy& operator+=(const Energy& o) {
    kinetic += o.kinetic, strain += o.strain, potential += o.potential;
    friction += o.friction, damping += o.damping, work += o.work, unresolved += o.unresolved;
    return *this;
  }
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

class ForceTerm {
 public:
  virtual ~ForceTerm() = default;
  virtual std::string_view name() const = 0;

  // A term that lets nodes see each other which no element joins (contact of lines with lines) says so before
  // a step of length h [s] (0: statics), before prepare(). Collective; local nodes of the time before count.
  // True: couple() or what was kept by local node is no longer what it was; reghost() follows.
  virtual bool recouple(const Kinematics& committed, double h) { return (void)committed, (void)h, false; }
  // Adds which nodes see each other, of those groups of which this rank owns a node.
  virtual void couple(Couplings& to) const { (void)to; }
  // Those nodes are local ones now; local nodes from LocalMesh::chain on are no longer what they were.
  virtual void reghost() {}
  // Of a converged step, before it is accepted, on this rank: whether everything that acts in it was
  // foreseen. False: it is taken again, shorter.
  virtual bool covers(const Kinematics& trial) const { return (void)trial, true; }
  // Of a step that is not covered, why not, in words for the user; empty: not by this term. Local.
  virtual std::string refusal(const Kinematics& trial) const { return (void)trial, std::string(); }
  // Whether that is so only because what was foreseen is old: preparing anew is the remedy, not a shorter
  // step.
  virtual bool outdated() const { return false; }

  // Once before a step of length h [s] is tried, from the last accepted state. May communicate.
  virtual void prepare(const Kinematics& committed, double h) { (void)committed, (void)h; }

  // Longest step that this term can be trusted with from here, and what strikes, each once over all ranks;
  // asked after prepare(). Steps that the user fixed are divided by it where impacts are to be resolved.
  virtual void limit_step(const Kinematics& committed, Strikes& to) const { (void)committed, (void)to; }
  // Adds what limit_step() could not foresee, each once over all ranks; local. Asked of a converged step
  // before it is accepted.
  virtual void unforeseen(const Kinematics& trial, Unforeseen& to) { (void)trial, (void)to; }
  // What impacts may make, lose or leave unresolved in that step, J by line of the mesh.
  virtual void bear(std::span<const double> energies) { (void)energies; }
  // Adds what this rank counts of the masses that move, by line of the mesh.
  virtual void motion(const Kinematics& at, std::span<LineMotion> lines) const { (void)at, (void)lines; }

  // Adds force and tangent at the trial state. Local, repeatable: reads committed history only.
  virtual void evaluate(const Kinematics& trial, Sink& sink) = 0;

  // The state is accepted: history that belongs to it becomes the committed history.
  virtual void commit(const Kinematics& accepted) { (void)accepted; }

  // A stiffness that follows what the run meets: from an equilibrium, raises it where that asks for it and
  // says so (solve again), and takes back what was raised since the last commit, before a step is tried
  // (again). evaluate() never changes it. stiffen() is collective.
  virtual bool stiffen(const Kinematics& equilibrium) { return (void)equilibrium, false; }
  virtual void forget_stiffening() {}

  // Sum of squares, N², of the round-off in the forces on this rank, in a try of a step h [s] (0: statics):
  // no residual can be smaller.
  virtual double round_off(const Kinematics& at, double h) const { return (void)at, (void)h, 0.0; }
  // Axial stiffness is at most this, N, until told otherwise (HUGE_VAL: the true one): statics starts soft,
  // where a very stiff line would have to creep along a narrow valley of its energy.
  virtual void soften(double most) { (void)most; }
  // The worst overstretched element of this rank, if there is one.
  virtual Overstretch overstretched(const Kinematics& at) const { return (void)at, Overstretch{}; }
  // Raises what `lines`, one for each line of the mesh, have to what this rank's elements have.
  virtual void tensions(const Kinematics& at, std::span<LineTension> lines) const { (void)at, (void)lines; }
  // Sum of the sizes of the dead loads on this rank, N: what a static residual is judged against.
  virtual double dead_load() const { return 0; }
  // Largest EA, N, of this rank; 0: none.
  virtual double axial_stiffness() const { return 0; }

  // Adds what this term, if it belongs to the elements of lines, has in the residual of a local element, from
  // the state alone: f[12] = (x1, theta1, x2, theta2), forces in space axes [N], moments in material axes
  // [N m]; of cables no moments. Terms that act at nodes (loads, masses, contact, the bed) add nothing.
  virtual void element_force(const Kinematics& at, const LocalElement& e, double* f) const {
    (void)at, (void)e, (void)f;
  }

  virtual Energy energy(const Kinematics& at) const { return (void)at, Energy{}; }
  virtual void fields(FieldRegistry& registry) const { (void)registry; }

  // Committed history of the owned nodes, and back (records may arrive in any order).
  virtual std::vector<HistoryRecord> save() const { return {}; }
  virtual void restore(const std::vector<HistoryRecord>& records) { (void)records; }
};

}  // namespace hawser
