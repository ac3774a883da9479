// A checked case made ready to compute on this rank: mesh, partition, bodies, volumes, terms, start shape.
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
#include "hawser/terms/structure.hpp"

namespace hawser {
class BodyContactTerm;
class Feeders;
class RigidBodies;
class SeabedTerm;
}  // namespace hawser

namespace hawser::run {

// Supports or ends that cannot be right, whatever the lengths of the lines are.
struct WrongPlaces : InputError {
  using InputError::InputError;
};

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
  // Force terms for those who ask them more than their role; null: the case has none.
  StructureTerm& structure() const { return *system_->find<StructureTerm>(); }
  LineVolumeContact* contact() const { return system_->find<LineVolumeContact>(); }
  LinePairs* line_pairs() const { return system_->find<LinePairs>(); }
  SeabedTerm* seabed() const;
  const BodyContactTerm* body_contact() const;
  const RigidBodies* floating() const;
  Feeders* feeders() const;
  // Where a body of the case is; of a floating one only the rank that owns its node knows: nullopt elsewhere.
  std::optional<RigidPose> body_pose(int body, const Kinematics& at) const;
  // For what records it; surfaces: one for each volume of the case.
  record::Subject subject(std::vector<std::shared_ptr<const Surface>> surfaces = {});
  State& state() { return state_; }
  Dynamics& dynamics();                                             // made at the first call
  const std::vector<std::string>& notes() const { return notes_; }  // what was chosen, one sentence each
  // Of bodies at rest in the surface whose stiffness against tilting has no part of the waterplane.
  // Collective.
  std::vector<std::string> tilting_warnings() const;
  const std::vector<std::string>& details() const { return details_; }  // of what rarely matters
  const std::vector<std::string>& warnings() const { return start_contact_.warnings; }  // of the start shape
  // Of automatic contact stiffness that is higher than it was when this was last asked, one sentence a
  // volume.
  std::vector<std::string> raised_stiffness(const std::string& when);
  int cut_elements() const { return cut_; }
  // Stretches at ends of lines that have no contact with a volume in which they start.
  const std::vector<ExcludedEnds>& excluded_ends() const { return start_contact_.excluded_ends; }

  // What of a line is inside a volume that an action switches on, in words; empty: nothing. Collective.
  std::string inside(const model::Action& action, const Kinematics& at) const;
  // Whether lines touch the volumes of an action from now on.
  void enable_contact(const model::Action& action);
  // Whether statics has friction, in place of what the case says; what the current is multiplied by.
  void enable_static_friction(bool on) { static_friction_ = on; }
  bool static_friction() const {
    return static_friction_.value_or(case_.statics.contact_friction);
  }  // of contact
  void scale_current(double factor);

  // InputError if what starts inside a volume is still there. Collective.
  void check_inside() const;
  // Static equilibrium of the state: without friction first, then friction of where the lines were laid.
  // InputError as of check_inside(). progress: how far it is, now and then; on all ranks. falls: something
  // was let go, and comes to rest by dynamic relaxation first.
  StaticsReport solve_statics(std::function<void(const StaticsReport&)> progress = {}, bool falls = false);
  // Of the equilibrium: what of each line lies on the seabed and what friction does there, a sentence each.
  // Collective.
  std::vector<std::string> on_bed() const;
  DynamicsSettings dynamics_settings() const;

 private:
  template <class Term, class... From>
  Term* add(From&&... from);
  void distribute(MPI_Comm comm);
  // The force terms, by what they are about; `start`: the start shape, `held`: local nodes.
  void add_line_terms();
  void add_seabed(const Kinematics& start, const std::vector<int>& held);
  void add_contact(const Kinematics& start, const std::vector<int>& held,
                   const std::vector<std::shared_ptr<const Surface>>& surfaces);
  void add_bodies(std::vector<std::shared_ptr<const Surface>> surfaces, std::vector<BodySkeleton> skeletons,
                  const VolumeFacets& facets);
  std::string inside(int volume, const Kinematics& at) const;
  bool lays_lines() const;  // whether statics has friction of the bed
  void follow_contact(StaticsSettings settings, StaticsReport& report);

  const model::Case case_;
  std::unique_ptr<Mesh> mesh_;
  std::shared_ptr<Bodies> bodies_;
  std::unique_ptr<System> system_;
  State state_;
  std::unique_ptr<Dynamics> dynamics_;
  std::vector<std::string> notes_, details_;
  std::vector<ContactVolume> volumes_;  // that lines may touch
  StartContact start_contact_;
  // Of the volumes of contact, in their basis, as raised_stiffness() last found it.
  std::vector<double> last_stiffness_;
  int cut_ = 0;
  std::optional<bool> static_friction_;  // by a stage; none: as the case has it
  bool any_laid_ = false;                // of any line of the case it is known where it was laid
  std::vector<Vec3> laid_;               // m, where local nodes were laid on the bed; as in StartShape
};

}  // namespace hawser::run
