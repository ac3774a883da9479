// Contact of lines with volumes: laws per length of line, integrated over the quadrature points on the axis
// of each element that LineVolumeFinder finds. See docs/theory/contact.md.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "hawser/system/fed_lines.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/active_contact.hpp"
#include "hawser/terms/contact_along_axis.hpp"
#include "hawser/terms/contact_resultant.hpp"
#include "hawser/terms/contact_work.hpp"
#include "hawser/terms/line_volume_finder.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser {

// Contact data of an element of a line.
struct LineContactElement {
  double radius = 0;           // m, half the contact diameter; 0: the element takes no part
  double mass_per_length = 0;  // kg/m: the effective mass of relative_damping
  double damping_time = 0;     // s, of a beam: its damping over its stiffness; a cable bends without damping
  std::array<bool, 2> held{};  // whether each end is held by a support or a body
  bool rolling = false;        // for a beam: friction acts at the surface and turns the beam about its axis
};

class LineVolumeContact final : public ForceTerm,
                                public CouplesNodes,
                                public LimitsSteps,
                                public AdaptsStiffness,
                                public HasFriction,
                                public ChecksRest,
                                public ActsOnFedLines {
 public:
  // elements: one for each of mesh.elements; throws std::invalid_argument if a number or an index is wrong. A
  // stiffness per point counts once for each element, or once for each node with contact at nodes. comm: the
  // ranks that have the lines.
  LineVolumeContact(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                    std::vector<ContactVolume> volumes, std::vector<LineContactElement> elements,
                    MPI_Comm comm = MPI_COMM_SELF, model::ContactMethod method = model::ContactMethod::line);

  std::string_view checkpoint_key() const override { return "line contact"; }
  bool refresh_couplings(const Kinematics& from, double h) override;
  void list_couplings(Couplings& to) const override { volumes_.list_couplings(to); }
  void prepare(const Kinematics& from, double h) override;
  // Considers the ends and the middle of each element, and present contacts (contact_laws.hpp).
  void limit_step(const Kinematics& committed, ImpactEvents& to) override;
  void unresolved(const Kinematics& trial, UnresolvedImpacts& to) override;
  // No element may pass through a volume within the step, or be deeper in one than the range of its law.
  Verdict check_step(const Kinematics& trial) const override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  // Raises an automatic stiffness that is too low for the present load; the trial is then solved again.
  bool adapt_stiffness(const Kinematics& equilibrium) override;
  bool raise_stiffness_where_blocked(const Kinematics& trial) override;
  void revert_stiffness() override;
  std::vector<advice::StiffnessRaise> take_raises() override { return volumes_.take_raises(); }
  // No line may be deeper in a volume than a contact with its stiffness can hold it.
  void check_at_rest(const Kinematics& equilibrium) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  // contact_force, contact_normal_force and friction_force, distributed by the element's shape functions.
  void fields(FieldRegistry& registry) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  // Collective.
  void restore(const std::vector<CheckpointRecord>& records) override;

  void enable_friction(bool on) override;
  // Switches contact of lines with a volume on or off. Called between steps, equally on all ranks.
  void enable(int volume, bool on) { volumes_.enable(volume, on); }
  // Called before the first step, equally on all ranks.
  void exclude_ends(std::vector<ExcludedEnds> ends) { volumes_.exclude_ends(std::move(ends)); }
  int volumes() const { return volumes_.size(); }
  const std::string& volume_name(int volume) const { return volumes_.settings(volume).name; }
  // Stiffness in the volume's basis; if it is automatic, as raised in accepted states.
  double stiffness(int volume) const { return volumes_.stiffness(volume); }
  bool has_largest_stiffness(int volume) const { return volumes_.has_largest_stiffness(volume); }
  // For what this rank counts: largest penetration over the run (with the node at the nearer end of the
  // element), number of pairs of an element and a volume in contact, number of candidate pairs in the step.
  Penetration largest_penetration() const;
  int active_count() const;
  int candidates() const;
  // Adds the contacts of the accepted state that this rank counts; volumes are those of volume_name().
  void active_contacts(ActiveContacts& out) const;
  // Likewise, on the surface of the volume: one for each pair and facet group.
  void resultants(const Kinematics& state, ContactResultants& out) const;
  // Forces of each volume on lines in the accepted state that this rank counts [N, space axes].
  std::vector<Vec3> forces_by_volume(const Kinematics& state) const;
  // Force of one volume and its moment about the origin of the volume's body; the force acts at the axis of
  // the line [N, N m, space axes].
  std::array<Vec3, 2> reaction(int volume, const Kinematics& state) const;
  // Forces of volumes on each local element in the accepted state, whether counted here or not, in the order
  // of the elements.
  struct Load {
    int element = 0;  // of LocalMesh::elements
    int volume = 0;
    double xi = 0;              // position along the element, 0 to 1
    Vec3 force = Vec3::Zero();  // N, space axes
    double from = 0, to = 0;    // limits of its panel along the element
    double gap = 0;             // m
    double smoothing = 0;       // m, of the normal law
  };
  std::vector<Load> loads(const Kinematics& state) const;
  AxisShape axis(const Kinematics& state, int element) const { return AxisShape(ends(state, element)); }

 private:
  using Pair = LineVolumePair;
  // A pair that may touch in the trial.
  struct Near {
    size_t pair = 0;
    AxisShape shape;
  };

  const LocalElement& local(const Pair& p) const { return mesh_.elements[p.element]; }
  const Element& element(const Pair& p) const { return mesh_.element(local(p)); }
  const LineContactElement& settings(const Pair& p) const { return elements_[p.element]; }
  AxisEnds ends(const Kinematics& state, int element) const;
  std::array<ContactLaw, 2> laws(const Pair& pair) const;
  void renew_laws();
  // The law, without friction if that is off.
  ContactLaw applied(const ContactLaw& l) const {
    return {l.normal, friction_on_ ? l.friction : FrictionLaw{}};
  }
  // Contact spring of a point. A straight element moves as a whole on the spring of the length in
  // contact [m].
  ContactSpring spring(const Pair& p, double xi, double contact_length) const {
    return contact_spring(p.law(xi).normal, settings(p).mass_per_length * p.length / contact_length,
                          p.radius);
  }

  // Pairs of an element and a volume at the start of a step, with data from earlier steps.
  bool start_pair(Pair& pair, const AxisEnds& at, const AxisShape& shape, double h, double& motion) const;
  void reuse_previous(Pair& previous, Pair& pair) const;
  void start_facet_groups(Pair& pair, double motion) const;
  bool idle(int element) const;
  void find_near_pairs(const Kinematics& trial);

  std::optional<AxisContact::Rolls> rolls(const Pair& pair, const AxisShape& shape) const;
  AxisContact contact(Pair& pair, const AxisShape& shape, const AxisContactMode& mode) const;
  void account(const Pair& pair, const AxisShape& shape, const std::vector<AxisContactPoint>& next);

  // add_impact_at() adds the impact at xi, of `length` m of the `contact_length` m in contact; `last`:
  // see Approach. predict_impacts() adds the impact with a surface that the element may reach.
  void add_impact_at(const Pair& pair, const Kinematics& committed, double xi, double length, double gap,
                     const Vec3& normal, bool last, ImpactEvents& to, double contact_length) const;
  void predict_impacts(const Pair& pair, const Kinematics& committed, double xi, const SurfacePoint& p,
                       ImpactEvents& to) const;
  // Adds the impacts with each facet group that the element may reach in the step. Returns whether there are
  // several.
  bool predict_impacts_by_group(const Pair& pair, const Kinematics& committed, ImpactEvents& to) const;
  void limit_by_active_contacts(const Pair& pair, const Kinematics& committed, ImpactEvents& to) const;
  void limit_ahead(Pair& pair, const Kinematics& committed, ImpactEvents& to) const;
  // Parts of unresolved().
  struct EndOfStep;
  struct Crossing;
  bool sinks_too_far(const EndOfStep& end) const;
  void add_lost_contacts(const EndOfStep& end, UnresolvedImpacts& to) const;
  void add_new_contacts(const EndOfStep& end, UnresolvedImpacts& to) const;
  void add_crossing(const EndOfStep& end, const Crossing& c, UnresolvedImpacts& to) const;
  // Where a line is deeper in a volume than the range of its law; nullopt: nowhere. `state` must be the one
  // that was evaluated last. Local.
  std::optional<advice::TooDeep> deeper_than_allowed(const Kinematics& state) const;
  bool tunnels(const Pair& pair, const AxisShape& shape, const RigidPose& pose, bool rests) const;
  bool is_pulled_in(const Pair& pair, const AxisShape& shape, const RigidPose& pose) const;
  bool is_inside(const Pair& pair, const AxisShape& shape, const RigidPose& pose) const;
  // True if stiffness cannot reduce the penetration of this element because one of its ends is held. With
  // contact at nodes, held ends are excluded from contact.
  bool is_held(const Pair& p) const { return !finder_.at_nodes() && (p.held[0] || p.held[1]); }
  double static_fraction(const Pair& pair, const Kinematics& state, double force, double depth,
                         const Vec3& normal) const;

  const LocalMesh& mesh_;
  ContactVolumes volumes_;
  LineVolumeFinder finder_;
  std::vector<LineContactElement> elements_;
  std::vector<Pair> pairs_;            // sorted by element and volume
  std::vector<ContactWork> accounts_;  // of the elements
  bool friction_on_ = true;
  std::vector<Near> near_;  // for the trial that was evaluated last
};

}  // namespace hawser
