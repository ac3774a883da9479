// Contact of lines with each other and with themselves: kernels/line_pair.hpp over all candidate pairs,
// each in several passes (kPassKinds below): each element once as the slave, against the element and the ends
// of the other. See docs/theory/line-line.md.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hawser/geometry/segment_distance.hpp"
#include "hawser/kernels/line_pair.hpp"
#include "hawser/model/case.hpp"
#include "hawser/system/fed_lines.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/active_contact.hpp"
#include "hawser/terms/contact_along_axis.hpp"
#include "hawser/terms/contact_resultant.hpp"
#include "hawser/terms/line_candidates.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser {

// A line type on other lines.
struct LinePairType {
  double radius = 0;           // m, half the contact diameter; 0: its lines take no part
  double mass_per_length = 0;  // kg/m
  // k and k₃ of N = k s + k₃ s³ a metre, for pairs with basis `automatic` (automatic_stiffness.hpp).
  double linear = 0, cubic = 0;  // N/m², N/m⁴
};

struct LinePairOptions {
  // Contact laws by pair of lines (indices, the smaller first); `general` for all other pairs. Stiffness in
  // N/m² or N/m³ by its basis (per length, per area), not automatic.
  model::LinePairSettings general;
  std::map<std::pair<int, int>, model::LinePairSettings> tuned;
  std::vector<bool> takes_part;  // by line; empty: all do
  CandidateSettings candidates;
  // Shared places of the lines that take part; `first_part`: see SharedPlaces.
  std::vector<SharedPlace> shared;
  std::vector<int> first_part;
};

// Largest penetration [m], from the parabola through the deepest Gauss point and the two next to it; 0
// without points.
double largest_depth_of(const std::vector<LinePairContactPoint>& points);

class LinePairs final : public ForceTerm,
                        public CouplesNodes,
                        public LimitsSteps,
                        public HasFriction,
                        public ActsOnFedLines {
 public:
  // types: by line type of the case. std::invalid_argument for settings that make no sense. Collective.
  LinePairs(MPI_Comm comm, const LocalMesh& mesh, std::vector<LinePairType> types, LinePairOptions options);

  // Places that lines share, with the lengths without contact near them.
  const SharedPlaces& shared() const { return shared_; }
  void enable_friction(bool on) override { friction_on_ = on; }

  std::string_view checkpoint_key() const override { return "line-line contact"; }
  // In statics the lengths without contact at shared places follow the shape; in motion they only shrink.
  bool refresh_couplings(const Kinematics& from, double h) override;
  void list_couplings(Couplings& to) const override { candidates_.list_couplings(to); }
  void renumber() override;
  // Refuses a step that missed a contact or in which a line passed through another.
  Verdict check_step(const Kinematics& trial) const override;
  void prepare(const Kinematics& from, double h) override;
  void limit_step(const Kinematics& committed, ImpactEvents& to) override;
  void unresolved(const Kinematics& trial, UnresolvedImpacts& to) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  // Adds line_contact_force, line_contact_normal_force, line_friction_force and line_penetration.
  void fields(FieldRegistry& registry) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

  // Largest penetration over the run of the pairs that this rank counts; mesh elements, -1: no contact so
  // far.
  struct Deepest {
    double depth = 0, time = 0;  // m, s
    int first = -1, second = -1;

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("penetration", "m", self.depth);
      each("time", "s", self.time);
      each("element", "", self.first);
      each("other element", "", self.second);
    }
  };
  Deepest deepest() const { return deepest_; }
  // Number of pairs in contact that this rank counts.
  int active_count() const;
  // Sum of the magnitudes of the normal and of the friction forces of those pairs, N.
  double normal_force() const;
  double friction_force() const;
  // Adds the contacts of those pairs in the accepted state.
  void active_contacts(ActiveContacts& out) const;
  // Likewise in that state, if it is the one evaluated last without derivatives.
  void active_contacts(const Kinematics& evaluated, ActiveContacts& out) const;
  // Likewise, one for each pair, midway between the two surfaces.
  void resultants(const Kinematics& state, ContactResultants& out) const;

 private:
  // A pass of a pair integrates along one element, the slave, against a target on the other, the master: the
  // element, or one of its ends if it is a joint, where the pass removes what the neighbour counts again.
  struct PassKind {
    bool swapped;  // the slave is the second element of the pair, not the first
    ProjectOn target;
    bool on_element() const { return target == ProjectOn::element; }
  };
  static constexpr size_t kPasses = 6;
  // Checkpoints store the index of a pass.
  static constexpr std::array<PassKind, kPasses> kPassKinds{{{false, ProjectOn::element},
                                                             {false, ProjectOn::first_end},
                                                             {false, ProjectOn::second_end},
                                                             {true, ProjectOn::element},
                                                             {true, ProjectOn::first_end},
                                                             {true, ProjectOn::second_end}}};
  using ContactPoints = std::array<std::vector<LinePairContactPoint>, kPasses>;
  using Key = std::pair<int, int>;  // of Mesh::elements
  // Panels of a pair in the last evaluated state, which tangent and commit() of the same state reuse, and
  // contact points from the last evaluation without derivatives, for commit().
  struct Trial {
    AxisShape a, b;
    std::array<std::vector<LinePairPass::Panel>, kPasses> panels{};
    bool active = false;
    bool evaluated = false, moves = false;  // moves: evaluated with velocities
    ContactPoints points{};

    // For a search at other axes, in the same memory.
    void reset(const AxisShape& axis_a, const AxisShape& axis_b) {
      a = axis_a;
      b = axis_b;
      active = evaluated = moves = false;
      for (auto& pass : panels) pass.clear();
      for (auto& pass : points) pass.clear();
    }
  };
  struct Pair {
    int a = 0, b = 0;  // indices of segments
    Key key;
    bool counted = false;
    LinePairLaw law;
    std::array<double, 2> range_a{0, 1}, range_b{0, 1};  // of the elements in xi, may touch the other
    SegmentPair chords;                                  // at the start of the step
    double clear = 0;  // m, lower bound of the distance between the surfaces at the start of the step
    std::unique_ptr<ContactPoints> points;  // null: no contact
    std::unique_ptr<Trial> trial;           // null: not evaluated in this step
  };
  // True if the elements share a place with a length without contact, so that the distance of their chords
  // does not indicate contact.
  static bool clipped(const Pair& p) {
    return p.range_a[0] > 0 || p.range_a[1] < 1 || p.range_b[0] > 0 || p.range_b[1] < 1;
  }
  // A segment as a rod: its chord, and the largest distance of the axis from it.
  struct Rod {
    Vec3 x1, x2;
    double sagitta = 0;
  };
  struct Account {
    double friction = 0, damping = 0;  // J

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("friction", "J", self.friction);
      each("damping", "J", self.damping);
    }
  };

  const ContactSegment& segment(int i) const { return segments_[i]; }
  int line_of_segment(int segment) const { return this->segment(segment).element.line; }
  const LinePairType& type_of_segment(int segment) const {
    return types_[this->segment(segment).element.type];
  }
  const AxisEnds& start(int segment) const { return start_[segment]; }
  int fed_end(int segment) const { return fed_end_[segment]; }
  PairAxis axis(const Kinematics& state, int segment) const;
  double material_of_start(int segment, const PairAxis& axis, double xi) const;
  // Sum over the contact points of the counted pairs for which which(pair) is true.
  template <class Which, class Value>
  double sum(const Which& which, const Value& value) const {
    double sum = 0;
    for (const Pair& p : pairs_)
      if (p.counted && p.points && which(p))
        for (const auto& pass : *p.points)
          for (const LinePairContactPoint& h : pass) sum += h.weight * value(h);
    return sum;
  }
  AxisEnds ends(const Kinematics& state, int segment) const;
  Rod rod(const Kinematics& state, int segment) const;
  LinePairLaw law(int segment_a, int segment_b) const;
  ActiveContact active_contact(const Pair& pair, const ContactPoints& points) const;
  // Axes and segments of slave and master in a pass of a pair with the axes A and B.
  struct PassRoles {
    const PairAxis &slave, &master;
    int slave_segment, master_segment;
  };
  static PassRoles roles(size_t pass, const Pair& pair, const PairAxis& A, const PairAxis& B) {
    if (kPassKinds[pass].swapped) return {B, A, pair.b, pair.a};
    return {A, B, pair.a, pair.b};
  }
  // Calls visit(k, pass) for the passes kPassKinds[k] of a pair that may touch.
  template <class Visit>
  void each_pass(const Pair& pair, const PairAxis& A, const PairAxis& B, bool moves, bool convex,
                 const Visit& visit) const;
  Trial& find(Pair& pair, const PairAxis& A, const PairAxis& B) const;
  // Contact forces on both elements, summed over the passes.
  AttachedForces forces(const Pair& pair, const PairAxis& A, const PairAxis& B, Trial& in_trial,
                        const AxisContactMode& mode) const;
  bool joint(const ContactSegment& s, int end) const;
  std::vector<Rod> rods(const Kinematics& state) const;
  bool may_touch(const Pair& pair, const std::vector<Rod>& moved) const;
  bool near(const Pair& pair, const std::vector<Rod>& moved) const;
  struct Nearest {
    double speed = 0, gap = 0;
  };
  Nearest nearest(const Pair& pair, const SegmentPair& chords, const AxisEnds& a, const AxisEnds& b) const;
  Nearest nearest_at_start(const Pair& p) const { return nearest(p, p.chords, start(p.a), start(p.b)); }
  double acceleration(const Pair& pair, const Kinematics& state) const;
  double mass_per_length(const Pair& pair) const;
  double inverse_frequency(const Pair& pair, double speed) const;
  double mass(const Pair& pair) const;
  bool tunnels(const Pair& pair, const Kinematics& trial) const;
  advice::NearestPlaces nearest_places(const Pair& pair) const;
  double largest_depth(const Pair& pair) const;
  double stored(const Pair& pair) const;
  advice::StepFinding too_soft(const Pair& pair) const;
  void account(const Pair& pair, const PairAxis& A, const PairAxis& B, const ContactPoints& next);
  double fed_work(const Pair& pair, const PairAxis& A, const PairAxis& B, const ContactPoints& next) const;

  const LocalMesh& mesh_;
  std::vector<LinePairType> types_;
  LinePairOptions options_;
  SharedPlaces shared_;
  LineCandidates candidates_;
  std::vector<Pair> pairs_;
  std::vector<ContactSegment> segments_;                // of the pairs
  std::map<Key, std::unique_ptr<ContactPoints>> kept_;  // points by pair while the list is rebuilt
  bool listed_ = false;
  std::vector<AxisEnds> start_;    // by segment
  std::vector<int> fed_end_;       // by segment: the fed end if it is at a feed point; else -1
  std::vector<Rod> rods_;          // by segment
  std::vector<Account> accounts_;  // by owned node
  Deepest deepest_;
  bool friction_on_ = true;
};

}  // namespace hawser
