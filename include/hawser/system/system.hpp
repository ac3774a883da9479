// One rank's share of the discrete equations: terms, tied nodes, and their assembly into PETSc objects.
#pragma once

#include <petscmat.h>

#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "hawser/advice/steps.hpp"
#include "hawser/base/handle.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/state.hpp"
#include "hawser/system/fed_lines.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/system/ghost_exchange.hpp"
#include "hawser/system/tied_nodes.hpp"

namespace hawser {

using VecHandle = Handle<Vec, VecDestroy>;
using MatHandle = Handle<Mat, MatDestroy>;

// The residual of the line that is furthest from balance, and its scale: the root of the sum of squares of
// all contributions to that line, over all ranks. A scale by line lets a light line beside heavy ones
// converge as well as they do.
struct ResidualNorms {
  double force = 0, moment = 0;  // N, N m, of the free components
  double force_scale = 0, moment_scale = 0;
  double round_off = 0, arm = 0;  // N, round-off of the forces; m, lever by which it becomes that of moments
  double span = 1;                // m, length of the line

  // True if the residual is below `tolerance` times its scale, or within round-off. If nothing bends, the
  // scale of moments is that of forces times a millimetre.
  bool small(double tolerance) const;
  bool finite() const;  // whether neither residual nor scale has overflowed
  // Residual over its scale; the larger of forces and moments.
  double relative() const;
};

// Result of System::update_couplings(). pattern_changed: there are other couplings, for which the matrix has
// room. layout_changed: vectors and matrices need another layout.
enum class CouplingChange { unchanged, pattern_changed, layout_changed };

class System {
 public:
  System(MPI_Comm comm, LocalMesh mesh);

  MPI_Comm comm() const { return comm_; }
  const LocalMesh& mesh() const { return mesh_; }
  const TiedNodes& tied_nodes() const { return tied_nodes_; }
  const std::vector<std::unique_ptr<ForceTerm>>& terms() const { return terms_; }
  // The first term of that class or with that role; null: there is none.
  template <class T>
  T* find() const {
    for (const auto& term : terms_)
      if (T* found = dynamic_cast<T*>(term.get())) return found;
    return nullptr;
  }
  // All terms with that role.
  template <class Role>
  std::vector<Role*> with() const {
    std::vector<Role*> out;
    for (const auto& term : terms_)
      if (Role* found = dynamic_cast<Role*>(term.get())) out.push_back(found);
    return out;
  }
  // Adds the forces of all terms on an element of a line, see ActsOnElements.
  void element_force(const Kinematics& state, const LocalElement& e, Vec12& f) const {
    for (const ActsOnElements* t : listed<ActsOnElements>()) t->element_force(state, e, f);
  }

  void add(std::unique_ptr<ForceTerm> term);
  // Deletes a term that this system owns; null: no effect.
  void remove(const ForceTerm* term);
  void tie(std::vector<TiedNode> nodes, BodyMotion motion);

  // Collects from the terms the nodes they couple in coming steps of h [s] from a state (h = 0: without a
  // prediction of its motion), and extends ghosts and pattern if they lack these nodes. If the layout has
  // changed, the caller rebuilds vectors, matrices and solvers, and updates the ghosts of its states. Called
  // before prepare(). Collective.
  CouplingChange update_couplings(const Kinematics& from, double h);
  // Resizes to the local nodes and fills the ghosts from their owners. Collective.
  void update_ghosts(State& state) const;
  void update_ghosts(std::vector<Vec3>& values) const { exchange_.update_ghosts(values); }
  void update_ghosts(std::vector<Mat3>& values) const { exchange_.update_ghosts(values); }
  // True if any nodes on any rank are coupled by more than elements.
  bool coupled() const { return coupled_; }
  // True if this rank may compute forces on nodes of other ranks (contact of a line with a floating body).
  bool sends() const { return coupled_ && mesh_.mesh->has_frames(); }
  // Checks a converged step or a trial of statics. Returns the most severe verdict of all terms and ranks,
  // the same on all ranks; its finding is on ranks that have it. impacts: also whether the step resolved its
  // impacts, including those that were not predicted when longest_step() was called. together: numbers of the
  // caller for the same reduction over the ranks. Collective.
  Verdict check_step(const Kinematics& trial, bool impacts = false, RankMax together = {});

  // A ghosted increment vector (blocks of 3) and the tangent with the pattern of chains and couplings.
  VecHandle create_vector() const;
  MatHandle create_matrix() const;
  // Refreshes the ghosts of a ghosted vector and copies its local values to `out` (3 * local blocks). False:
  // `out` already had these values.
  bool gather_with_ghosts(Vec u, std::vector<double>& out) const;

  // r = sum of all terms at the trial state plus `mean_history` (3 * local blocks; empty: nothing). Held
  // components of r are zero; their values are kept as reactions().
  void residual(const Kinematics& trial, Vec r, std::span<const double> mean_history = {});
  // Sum of the mean forces over the step in the last residual(), without their weight (StepMean): 3 * local
  // blocks, valid for owned blocks. Only cables have mean forces; empty in a mesh without cables.
  const std::vector<double>& mean_forces() const { return mean_; }
  // J = wK K T(u) + wC C + wM M; rows and columns of held components are those of the identity. `u` are the
  // local increments that led to the trial (3 * local blocks).
  void tangent(const Kinematics& trial, Weights weights, const std::vector<double>& u, bool convex, Mat J);

  // Norms of r, with the scales of the last residual(). Collective.
  ResidualNorms norms(Vec r) const;
  // The force of the support (or of whatever else holds the component) on the line: the residual of the last
  // residual() call before held components were zeroed; 3 * local blocks, valid for owned blocks.
  const std::vector<double>& reactions() const { return force_; }

  // The following combine all ranks (collective); see roles.hpp.
  bool limit_axial_stiffness(double max_stiffness);  // true on all ranks: a section differs from its true one
  void restore_sections();
  double axial_stiffness() const;
  double dead_load() const;
  // Limit for a step of at most `max_step` [s]. Impacts limit it by the error of energy that they may cause.
  StepLimit longest_step(const Kinematics& committed, const StoredMotion& stored, double max_step);
  bool adapt_stiffness(const Kinematics& equilibrium);  // true on all ranks: solve again
  bool raise_stiffness_where_blocked(
      const Kinematics& trial);  // in statics; true on all ranks: stiffness was raised, search again
  void revert_stiffness();

  // Prepares the terms for trials of at most h [s] that depart from a state (ForceTerm::prepare). Collective.
  void prepare(const Kinematics& from, double h);
  // Computes the round-off of the residual in a trial of h [s], after prepare() for a longer one. Collective.
  void update_round_off(const Kinematics& from, double h);
  void commit(const Kinematics& accepted);
  // overstretched(), lost_in_rounding(): why an equilibrium or a converged step is not a valid result;
  // nullopt: it is valid. overstretched: an element is strained beyond the range of its law.
  // lost_in_rounding: round-off is a hundredth or more of a line's tension. Collective, the same on all
  // ranks.
  std::optional<advice::Overstretched> overstretched(const Kinematics& state) const;
  // The most overstretched element of this rank, if any; not collective.
  Overstretch overstretch(const Kinematics& state) const;
  std::optional<advice::LostInRounding> lost_in_rounding(const Kinematics& state) const;
  // By line of the mesh, the same on all ranks. Collective.
  std::vector<LineTension> line_tensions(const Kinematics& state) const;
  // Energy summed over the terms, this rank's share.
  Energy energy(const Kinematics& state) const;
  FieldRegistry fields() const;

 private:
  // with<Role>() of a role of roles_, without a search.
  template <class Role>
  const std::vector<Role*>& listed() const {
    return std::get<std::vector<Role*>>(roles_);
  }
  void list_roles();
  void update_fed_lines(const Kinematics& state) const {
    for (FedLines* f : listed<FedLines>()) f->update(state);
  }
  void size_arrays();
  void sum(std::span<double> values) const;  // sums over the ranks, in place
  // The motion of the masses of lines that this rank counts, without impacts.
  struct Motions {
    explicit Motions(const std::vector<int>& lines) : moving(lines), stored(lines) {}
    PerLine<LineMotion> moving;
    PerLine<LineMotion> stored;  // with algorithmic accelerations as velocities
  };
  Motions motions(const Kinematics& state, const StoredMotion& stored) const;  // of lines_
  // Every rank gets the sums over the ranks for some of the lines, which are the same on all ranks, and of
  // `more`.
  void sum_lines(std::span<const int> lines, Motions& motions, std::span<double> more = {}) const;
  void reghost_ties();
  void with_frames(Couplings& c) const;
  // The blocks of the tangent in this rank's rows, sorted: row and column as local blocks. A node is coupled
  // with itself, its chain neighbours, and the nodes of its couplings.
  std::vector<std::pair<int, int>> pattern() const;

  MPI_Comm comm_;
  LocalMesh mesh_;
  Couplings couplings_;  // couplings for which the matrix has room, beside those of the chains
  bool coupled_ = false;
  GhostExchange exchange_;
  TiedNodes tied_nodes_;
  TiedNodeForces ties_;
  std::vector<std::unique_ptr<ForceTerm>> terms_;
  // The terms that have a role (roles.hpp).
  std::tuple<std::vector<CouplesNodes*>, std::vector<LimitsSteps*>, std::vector<AdaptsStiffness*>,
             std::vector<ActsOnElements*>, std::vector<MovesMasses*>, std::vector<HasAxialStiffness*>,
             std::vector<ScalesResiduals*>, std::vector<FedLines*>>
      roles_;
  // Events of -log_view, by term: forces, tangents, and preparation of a step.
  struct Events {
    PetscLogEvent force = 0, tangent = 0, prepare = 0;
  };
  std::vector<Events> events_;
  PetscLogEvent limit_event_ = -1;
  std::vector<int> turn_of_;  // by local block: index into retraction_; -1: a position
  std::vector<double> force_, mean_;
  std::vector<Mat3> retraction_;      // of rotations
  std::vector<int> square_of_block_;  // 2 * place in lines_, + 1 for rotations
  std::vector<double> squares_;       // of the contributions to the last residual(), by block
  // Lines of the mesh, ascending; a body's node counts as one.
  std::vector<int> cut_;          // of which several ranks own nodes; the same on all ranks
  std::vector<int> local_lines_;  // of which this rank owns nodes
  std::vector<int> lines_;        // both
  // J, error of energy that impacts may cause in the coming step; of lines_ and of lines of impacts
  PerLine<double> energy_tolerance_;
  double round_off_ = 0, longest_element_ = 0;
};

}  // namespace hawser
