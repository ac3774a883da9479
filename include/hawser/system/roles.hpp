// Roles of force terms in addition to their force. A term inherits its roles, and System keeps a list of the
// terms with each role. The order in which terms were added matters only for fields, which may be based on
// those of an earlier term (FieldSource::onto).
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "hawser/advice/contact_stiffness.hpp"
#include "hawser/kernels/impact.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/mesh/per_line.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/system/couplings.hpp"
#include "hawser/system/verdict.hpp"

namespace hawser {

// Couples nodes that no element joins (contact of lines with lines and with bodies).
class CouplesNodes {
 public:
  virtual ~CouplesNodes() = default;
  // Called before prepare(), with the state `from`, from which trials depart, and with the local nodes as
  // before. It predicts the motion for steps of h [s]; 0: none is predicted (statics). True if
  // list_couplings() or anything stored by local node has changed on any rank; renumber() follows then.
  // Collective, and the same on all ranks.
  virtual bool refresh_couplings(const Kinematics& from, double h) = 0;
  // Adds the groups of coupled nodes of which this rank owns a node.
  virtual void list_couplings(Couplings& to) const = 0;
  // Called when the coupled nodes are local. Local nodes from LocalMesh::element_ghosts_end on have changed.
  virtual void renumber() {}
};

// Couples the same nodes during the whole run.
class CouplesFixedNodes : public CouplesNodes {
 public:
  bool refresh_couplings(const Kinematics&, double) final { return !std::exchange(coupled_, true); }

 private:
  bool coupled_ = false;
};

// Limits the length of a step, or checks whether a converged step is valid.
class LimitsSteps {
 public:
  virtual ~LimitsSteps() = default;
  // Adds the longest step from here, and the impacts, each once over all ranks. Called after prepare(). Fixed
  // steps of the user are divided by it if impacts are to be resolved.
  virtual void limit_step(const Kinematics& /*committed*/, ImpactEvents&) {}
  // Checks a converged step or a trial of statics, on this rank: tunnelling, penetration beyond the range of
  // a law, outdated candidates.
  virtual Verdict check_step(const Kinematics& /*trial*/) const { return {}; }
  // Adds the impacts that a converged step did not resolve, each once over all ranks. Called before the step
  // is accepted. Local.
  virtual void unresolved(const Kinematics& /*trial*/, UnresolvedImpacts&) {}
};

// Has a stiffness that is adapted to an equilibrium: contact raises it until the penetration is small, soil
// springs take the direction in which they are pulled. evaluate() never changes it.
class AdaptsStiffness {
 public:
  virtual ~AdaptsStiffness() = default;
  // Adapts the stiffness if this equilibrium requires it. True: solve again. Collective.
  virtual bool adapt_stiffness(const Kinematics& equilibrium) = 0;
  // In statics, raises the stiffness if it is too low to keep a line out of a volume on the path to that
  // trial. True: solve again. Collective.
  virtual bool raise_stiffness_where_blocked(const Kinematics& trial) = 0;
  // Reverts the stiffness to that of the last commit. Called before each trial of a step.
  virtual void revert_stiffness() = 0;
  // The raises in accepted states since the last call, for messages; the same on all ranks.
  virtual std::vector<advice::StiffnessRaise> take_raises() { return {}; }
};

// Acts on the elements of lines, so that forces at their ends can be computed.
class ActsOnElements {
 public:
  virtual ~ActsOnElements() = default;
  // Adds the contribution of this term to the residual of a local element, from the state alone: f = (x1,
  // theta1, x2, theta2), forces in space axes [N], moments in material axes [N m]. Cables have no moments.
  virtual void element_force(const Kinematics& state, const LocalElement& e, Vec12& f) const = 0;
};

// Has mass on lines.
class MovesMasses {
 public:
  virtual ~MovesMasses() = default;
  // Adds the moving masses that this rank counts. lines: those of this rank, perhaps among others.
  virtual void motion(const Kinematics& state, PerLine<LineMotion>& lines) const = 0;
};

// The element that is stretched or compressed furthest beyond the range of its law.
struct Overstretch {
  double beyond = 0;             // excess of the strain; 0: there is no such element
  int node = -1;                 // of the mesh, at its first end
  double strain = 0, limit = 0;  // its strain and the allowed one, both signed
  double tension = 0, EA = 0;    // N
};

// Largest tension, round-off of a tension and EA of a line, N.
struct LineTension {
  double tension = 0, round_off = 0, EA = 0;
};

// Has the axial stiffness and the tension of lines.
class HasAxialStiffness {
 public:
  virtual ~HasAxialStiffness() = default;
  // Limits the axial stiffness [N] and makes sections elastic, until the next call or restore_sections().
  // Statics starts soft, because the energy of a very stiff line is badly conditioned, and elastic, because
  // yielding sections in the bends of a shape far from equilibrium would have almost no stiffness. Returns
  // whether a section of this rank differs from its true one.
  virtual bool limit_axial_stiffness(double max_stiffness) = 0;
  virtual void restore_sections() = 0;  // true stiffness and plastic law
  // Largest EA, N, of this rank; 0: none.
  virtual double axial_stiffness() const = 0;
  // The most overstretched element of this rank, if any.
  virtual Overstretch overstretched(const Kinematics& state) const = 0;
  // Raises the entries of `lines`, one for each line of the mesh, to the values of this rank's elements.
  virtual void tensions(const Kinematics& state, std::span<LineTension> lines) const = 0;
};

// Provides magnitudes of forces with which a residual is compared.
class ScalesResiduals {
 public:
  virtual ~ScalesResiduals() = default;
  // Sum of squares of the round-off of the forces [N] and moments [N m] on this rank, in a trial of a step
  // h [s] (0: statics). No residual can be smaller.
  virtual double round_off(const Kinematics&, double /*h*/) const { return 0; }
  // Sum of the magnitudes of the dead loads on this rank, N.
  virtual double dead_load() const { return 0; }
};

}  // namespace hawser
