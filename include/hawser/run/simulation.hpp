// A checked case prepared for computation on this rank: mesh, partition, bodies, volumes, terms, start shape.
#pragma once

#include <mpi.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/run/start_contact.hpp"
#include "hawser/solve/dynamics.hpp"
#include "hawser/solve/statics.hpp"
#include "hawser/system/system.hpp"
#include "hawser/terms/bodies.hpp"
#include "hawser/terms/body_skeleton.hpp"
#include "hawser/terms/hulls.hpp"
#include "hawser/terms/line_pairs.hpp"
#include "hawser/terms/line_volume_contact.hpp"
#include "hawser/terms/static_rest.hpp"

namespace hawser {
class Feeders;
}  // namespace hawser

namespace hawser::run {

// Error in supports or ends that no choice of line lengths can remove.
struct WrongPlaces : InputError {
  using InputError::InputError;
};

// Where statics starts: near rest, or where something was released, which comes to rest by dynamic
// relaxation.
enum class StartsFrom { rest, release };

class Simulation {
 public:
  // surfaces: one for each volume of the case, in its order; skeletons: likewise, for contact of bodies with
  // bodies; facets: likewise, for hulls. Collective.
  Simulation(MPI_Comm comm, model::Case c, std::vector<std::shared_ptr<const Surface>> surfaces = {},
             std::vector<BodySkeleton> skeletons = {}, const VolumeFacets& facets = {});

  const model::Case& model() const { return case_; }
  const Mesh& mesh() const { return *mesh_; }
  const LocalMesh& local() const { return system_->mesh(); }
  const Bodies& bodies() const { return *bodies_; }
  System& system() { return *system_; }
  // Force terms that several callers use beyond their interface; null: the case has none. Others are found by
  // System::find().
  LineVolumeContact* line_volume_contact() const { return system_->find<LineVolumeContact>(); }
  LinePairs* line_pairs() const { return system_->find<LinePairs>(); }
  Feeders* feeders() const;
  // Pose of a body of the case; for a floating body nullopt except on the rank that owns its node.
  std::optional<RigidPose> body_pose(int body, const Kinematics& state) const;
  // Subject for recordings; surfaces: one per volume of the case.
  record::Subject subject(std::vector<std::shared_ptr<const Surface>> surfaces = {});
  State& state() { return state_; }
  Dynamics& dynamics();  // created by the first call
  // Choices, one sentence each; those on lines at rest only on the first rank.
  const std::vector<std::string>& notes() const { return notes_; }
  // Warnings of floating bodies without waterplane stiffness against tilting. Collective.
  std::vector<std::string> tilting_warnings() const;
  const std::vector<std::string>& details() const { return details_; }                  // minor choices
  const std::vector<std::string>& warnings() const { return start_contact_.warnings; }  // on the start shape
  // Messages about automatic contact stiffness that was raised since the last call, one sentence per volume.
  std::vector<std::string> take_stiffness_raises(const std::string& when);
  int cut_elements() const { return cut_; }
  // Stretches at line ends without contact with a volume in which they start.
  const std::vector<ExcludedEnds>& excluded_ends() const { return start_contact_.excluded_ends; }

  // Description of the parts of lines inside a volume that an action switches on; empty: none. Collective.
  std::string inside(const model::Action& action, const Kinematics& state) const;
  // Switches contact of lines with the volumes of an action.
  void enable_contact(const model::Action& action);
  // Overrides, for the coming stages, whether all friction acts in statics; none: as in the case.
  void enable_friction_in_statics(bool on) {
    friction_in_statics_ = on;
    resting_.clear();
  }
  // True if friction of contact with volumes and lines acts in statics; for that of the bed see lays_lines().
  bool contact_friction_in_statics() const {
    return friction_in_statics_.value_or(case_.statics.contact_friction.value_or(false));
  }
  // Frees what the case has of lines of other ranks, on all ranks but the first, which writes messages about
  // all lines.
  void forget_lines_of_others();

  // Throws InputError if a line that starts inside a volume is still inside. Collective.
  void check_inside() const;
  // Static equilibrium of the state: first without friction, then with friction relative to the laid
  // position. Throws InputError as check_inside(). progress: called occasionally, on all ranks.
  StaticsReport solve_statics(std::function<void(const StaticsReport&)> progress = {},
                              StartsFrom from = StartsFrom::rest);
  DynamicsSettings dynamics_settings() const;

 private:
  template <class Term, class... From>
  Term* add(From&&... from);
  void distribute(MPI_Comm comm);
  // Adds the force terms by subject; `start`: the start shape, `held`: local nodes.
  void add_line_terms();
  void add_seabed(const Kinematics& start, const std::vector<int>& held);
  void add_contact(const Kinematics& start, const std::vector<int>& held,
                   const std::vector<std::shared_ptr<const Surface>>& surfaces);
  void add_bodies(std::vector<std::shared_ptr<const Surface>> surfaces, std::vector<BodySkeleton> skeletons,
                  const VolumeFacets& facets);
  PlacedLines placed_lines(const Kinematics& state) const;
  std::string inside(int volume, const Kinematics& state) const;
  bool lays_lines() const;  // statics has bed friction
  void solve_with_contact_friction(StaticsSettings settings, StaticsReport& report);
  // Finds the equilibrium with friction as in statics, and with bodies restrained that have no equilibrium of
  // their own. The bodies keep their initial velocities for dynamics.
  StaticsReport find_restrained_equilibrium(const StaticsSettings& settings);
  // The same, by friction of contact if there is none without it, or if bodies start in contact that nothing
  // else supports.
  StaticsReport find_equilibrium_or_rest_by_friction(StaticsSettings settings);
  std::optional<StaticsReport> rest_in_contact(StaticsSettings settings);
  // Whether statics finds the equilibrium of a body with this support.
  bool has_equilibrium(size_t body, const StaticRest& support) const;
  std::vector<bool> bodies_with_equilibrium() const;
  void enable_friction_at_rest();
  void note_contact_at_rest();
  void note_bodies_held_without_weight();
  void note_slack_lines(bool relaxed);

  model::Case case_;
  std::unique_ptr<Mesh> mesh_;
  std::shared_ptr<Bodies> bodies_;
  std::unique_ptr<System> system_;
  State state_;
  std::unique_ptr<Dynamics> dynamics_;
  std::vector<std::string> notes_, details_;
  std::vector<ContactVolume> volumes_;  // that lines may touch
  StartContact start_contact_;
  int cut_ = 0;
  std::optional<bool> friction_in_statics_;  // set by a stage; none: as in the case
  std::vector<StaticRest> support_;          // by body of the case, for those of this rank
  std::vector<bool> resting_;  // by body, whether contact supports it from its start; empty: none
  bool any_laid_ = false;      // the laid position of some line of the case is known
  std::vector<Vec3> laid_;     // m, laid positions of local nodes on the bed; as in StartShape
};

}  // namespace hawser::run
