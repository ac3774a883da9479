// One rank's share of the discrete equations: terms, tied nodes, and their assembly into PETSc objects.
#pragma once

#include <petscmat.h>

#include <memory>
#include <vector>

#include "hawser/base/handle.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/system/ghost_exchange.hpp"
#include "hawser/system/tied_nodes.hpp"

namespace hawser {

using VecHandle = Handle<Vec, VecDestroy>;
using MatHandle = Handle<Mat, MatDestroy>;

// The residual of the line that is worst off, and what it is measured against: root of the sum of squares of
// all contributions to that line, over all ranks. A light line beside heavy ones is solved as well as they
// are.
struct ResidualNorms {
  double force = 0, moment = 0;  // N, N m, of the free components
  double force_scale = 0, moment_scale = 0;
  double round_off = 0, arm = 0;  // N, what is noise; m, that makes it a moment
  double span = 1;                // m, length of the line

  // Whether the residual is down to `tolerance` of what makes it up, or to round-off. Where nothing bends,
  // moments are measured against forces over a millimetre.
  bool small(double tolerance) const;
  bool finite() const;  // what is beyond all numbers is in balance with nothing
  // Residual over its scale, the larger of forces and moments.
  double relative() const;
};

// The result of System::couple(). pattern_changed: other couplings, which the matrix has room for;
// layout_changed: vectors and matrices need another layout.
enum class CouplingChange { unchanged, pattern_changed, layout_changed };

class System {
 public:
  System(MPI_Comm comm, LocalMesh mesh);

  MPI_Comm comm() const { return comm_; }
  const LocalMesh& mesh() const { return mesh_; }
  const TiedNodes& tied_nodes() const { return tied_nodes_; }
  const std::vector<std::unique_ptr<ForceTerm>>& terms() const { return terms_; }
  // The first term that is of that class or has that role; null: none is.
  template <class T>
  T* find() const {
    for (const auto& term : terms_)
      if (T* found = dynamic_cast<T*>(term.get())) return found;
    return nullptr;
  }
  // All that have that role.
  template <class Role>
  std::vector<Role*> with() const {
    std::vector<Role*> out;
    for (const auto& term : terms_)
      if (Role* found = dynamic_cast<Role*>(term.get())) out.push_back(found);
    return out;
  }
  // Of an element of a line, all terms that act on it: see ActsOnElements.
  void element_force(const Kinematics& at, const LocalElement& e, double* f) const {
    for (const ActsOnElements* t : on_elements_) t->element_force(at, e, f);
  }

  void add(std::unique_ptr<ForceTerm> term);
  void tie(std::vector<TiedNode> nodes, BodyMotion motion);

  // Asks the terms which nodes they couple in a coming step of h [s]. Where ghosts or matrix lack room, it
  // makes room: the caller then rebuilds vectors, matrices and solvers, and spreads states. Before prepare().
  // Collective.
  CouplingChange couple(const Kinematics& committed, double h);
  // Resizes to the local nodes and fills the ghosts from their owners. Collective.
  void spread(State& state) const;
  void spread(std::vector<Vec3>& values) const { exchange_.spread(values); }
  void spread(std::vector<Mat3>& values) const { exchange_.spread(values); }
  // Whether any nodes see each other beyond the elements, on any rank.
  bool coupled() const { return coupled_; }
  // Whether forces on nodes of other ranks may arise here (contact of a line with a body that floats).
  bool sends() const { return coupled_ && mesh_.mesh->has_frames(); }
  // Of a converged step, or a trial of statics: the weightiest verdict of all terms and ranks, the same on
  // all. Collective.
  Verdict check_step(const Kinematics& trial) const;

  // A ghosted increment vector (blocks of 3) and the tangent with the pattern of chains and couplings.
  VecHandle create_vector() const;
  MatHandle create_matrix() const;
  // Local values of a ghosted vector after refreshing its ghosts, copied to `out` (3 * local blocks). False:
  // they were there already.
  bool gather(Vec u, std::vector<double>& out) const;

  // r = sum of all terms at the trial state, and of what is `carried` (3 * local blocks; empty: nothing);
  // held components of r are zero, their reactions are kept.
  void residual(const Kinematics& trial, Vec r, std::span<const double> carried = {});
  // Of the last residual() of all terms: the forces that are means over the step, without their weight; 3 *
  // local blocks, valid for owned blocks. Only cables have some: empty in a mesh without.
  const std::vector<double>& mean_forces() const { return mean_; }
  // J = K T(u) + wC C + wM M; rows and columns of held components are the identity's. `u` are the local
  // increments that led to the trial (3 * local blocks).
  void tangent(const Kinematics& trial, Weights weights, const std::vector<double>& u, bool convex, Mat J);

  // Of the last residual() call. Collective.
  ResidualNorms norms(Vec r) const;
  // The force that the support (or whatever holds the component) exerts on the line: the residual of the
  // last residual() call before held components were zeroed; 3 * local blocks, valid for owned blocks.
  const std::vector<double>& reactions() const { return force_; }

  // Over all ranks (collective): see roles.hpp.
  bool soften(double most);  // true on all ranks: something is not as it truly is
  double axial_stiffness() const;
  double dead_load() const;
  // Of a step of at most `most` [s]: what impacts allow is bounded by the energy they are about.
  StepLimit longest_step(const Kinematics& committed, const StoredMotion& stored, double most);
  // Whether a converged step resolved the impacts in it, also those that its start, when longest_step() was
  // asked, did not show.
  bool resolves_impacts(const Kinematics& trial);
  bool raise_stiffness(const Kinematics& equilibrium);  // true on all ranks: solve again
  bool raise_stiffness_where_blocked(
      const Kinematics& trial);  // in statics; true on all ranks: the path is free now
  void revert_stiffness();

  void prepare(const Kinematics& committed, double h);
  // Says that the coming try is shorter than what was prepared for: what is noise in the residual depends on
  // it. Collective.
  void expect(const Kinematics& committed, double h);
  void commit(const Kinematics& accepted);
  // Why an equilibrium or a converged step cannot be a result, as a sentence for the user; empty where it
  // can: an element is strained beyond what its law is given for, or rounding is a hundredth or more of a
  // line's tension. Collective.
  std::string overstretched(const Kinematics& at) const;
  std::string lost_in_rounding(const Kinematics& at) const;
  // Summed over the terms, this rank's share.
  Energy energy(const Kinematics& at) const;
  FieldRegistry fields() const;

 private:
  void size_arrays();
  void sum(std::span<double> values) const;  // over the ranks, in place
  std::vector<LineMotion> motions(const Kinematics& at, const StoredMotion& stored,
                                  const std::vector<ImpactEvent>& impacts) const;
  void reghost_ties();
  void with_frames(Couplings& c) const;
  // The blocks of the tangent in this rank's rows, sorted: row and column as local blocks (a node with
  // itself, its chain neighbours, and what it is coupled with).
  std::vector<std::pair<int, int>> pattern() const;

  MPI_Comm comm_;
  LocalMesh mesh_;
  Couplings couplings_;  // what the matrix holds beyond the chains
  bool coupled_ = false;
  GhostExchange exchange_;
  TiedNodes tied_nodes_;
  TiedNodeForces ties_;
  std::vector<std::unique_ptr<ForceTerm>> terms_;
  // Those of the terms that have a role (roles.hpp).
  std::vector<CouplesNodes*> couple_nodes_;
  std::vector<LimitsSteps*> limit_steps_;
  std::vector<RaisesStiffness*> raise_stiffness_;
  std::vector<ActsOnElements*> on_elements_;
  std::vector<MovesMasses*> move_masses_;
  std::vector<CarriesTension*> carry_tension_;
  std::vector<ScalesResiduals*> scale_residuals_;
  // -log_view names time by term: forces, tangents, and what is done before a step.
  struct Events {
    PetscLogEvent force = 0, tangent = 0, prepare = 0;
  };
  std::vector<Events> events_;
  PetscLogEvent limit_event_ = -1;
  std::vector<int> turn_of_;  // by local block: place in retraction_; -1: a position
  std::vector<double> force_, mean_;
  std::vector<Mat3> retraction_;          // of rotations
  std::vector<int> square_of_block_;      // 2 * line, + 1 for rotations
  std::vector<double> squares_;           // of what made up the last residual(), by block
  size_t sums_ = 0;                       // that they are summed to
  std::vector<double> energy_tolerance_;  // J by line, what impacts may make of it in the step to come
  double round_off_ = 0, longest_element_ = 0;
};

}  // namespace hawser
