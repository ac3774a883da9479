// The seabed: a plane or a surface with a spring, a damper and friction at every node and at the middle of
// each cable element. Each point represents a share of the line's length. The law at a point, with friction
// and the tangents of both, is in kernels/surface_contact_law.cpp. See docs/theory/seabed.md.
#pragma once

#include <memory>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/pressed_friction.hpp"
#include "hawser/kernels/suction.hpp"
#include "hawser/kernels/surface_contact_law.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/line_neighbours.hpp"
#include "hawser/terms/run_roles.hpp"
#include "hawser/terms/surface_contact_points.hpp"

namespace hawser {

namespace model {
struct Case;
}

class BedContact final : public ForceTerm, public HasFriction {
 public:
  struct Plane {
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();
    double gap(const Vec3& x) const { return normal.dot(x - point); }
  };
  struct PointLaw {
    double radius = 0;  // m, reduced by the lowering of the bed beside a held end
    ContactLaw law;     // N/m, for the whole point; no contact without normal stiffness
    Suction suction;
    // Share of the line at the point: length [m], weight in water [N], EA divided by the element's length
    // [N/m].
    double length = 0, weight = 0, axial_stiffness = 0;
    bool operator==(const PointLaw&) const = default;
  };
  // `nodes`: one law for each owned node. `middles`: one for the middle of each local element, or empty.
  struct PointLaws {
    std::vector<PointLaw> nodes, middles;
  };

  // A surface is given in space axes; its inside is the ground.
  BedContact(const LocalMesh& mesh, const Plane& plane, PointLaws laws);
  BedContact(const LocalMesh& mesh, std::shared_ptr<const Surface> surface, PointLaws laws);
  // held: supported local nodes, on which the bed does not act.
  BedContact(const LocalMesh& mesh, const model::Case& c, const std::vector<int>& held);

  std::string_view checkpoint_key() const override { return "seabed"; }
  void prepare(const Kinematics& from, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  // Force of the bed on a local node in the accepted state, N, space axes.
  Vec3 node_force(int node) const;
  void fields(FieldRegistry& registry) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  void restore(const std::vector<CheckpointRecord>& records) override;

  void enable_friction(bool on) override { friction_ = on ? FrictionMode::contact : FrictionMode::none; }
  // In statics, until the first time step, slip is counted from where the lines were laid, in two phases. In
  // the first phase (pressed) the normal force does not depend on the trial, so that friction has a
  // potential. It is the weight of the points on the bed at the start, later the contact force of the last
  // solution. In the second phase friction has the law of motion. full_friction: the friction springs of
  // the first phase are as stiff as the line's elements; the mobilised friction carries over to the second
  // phase. places: by local node, m; NaN: not laid.
  void lay(const std::vector<Vec3>& places, const Kinematics& start, bool full_friction);
  // For the first phase: friction is fully mobilised at this slip [m] or more, so that it increases smoothly.
  void mobilise_at(double full_slip) { full_slip_ = full_slip; }
  void press_by_contact(const Kinematics& state);
  void use_contact_friction(const Kinematics& state);

  // Part of a line on the bed in the accepted state.
  struct OnBed {
    // m of line on the bed: with friction; with friction that is not fully mobilised.
    double friction_length = 0, sticking = 0;
    double friction_tension = 0;  // N, tension that friction takes up, positive from end A to end B
  };
  // By line of the mesh, summed over the points that this rank counts.
  std::vector<OnBed> on_bed(const Kinematics& state) const;

  int active_count() const;

 private:
  // Memory of a point in contact: elastic slip of friction [m] with the normal of the bed for which it is
  // stored, forces [N] and potential [J] (SurfaceContactPoint), and suction.
  struct PointHistory : SurfaceContactPoint {
    using SurfaceContactPoint::SurfaceContactPoint;
    bool active = false;
    SuctionState soil;

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      SurfaceContactPoint::quantities(self, each, "N", "J");
      each("touches", "", self.active);
      each("deepest", "m", self.soil.deepest);
      each("held by suction", "", self.soil.held);
    }
  };
  // Energy that lines have lost so far at the points that this rank counts, J: to friction, including elastic
  // slip, which may return it; to damping, including suction.
  struct Account {
    double friction = 0, damping = 0;

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("friction work", "J", self.friction);
      each("damping work", "J", self.damping);
    }
  };
  // Point at the start of the step: position, gap, and direction of the line.
  struct StepStart {
    Vec3 point = Vec3::Zero(), direction = Vec3::UnitX();
    double gap = 0;
  };
  enum class FrictionMode { none, pressed, contact };
  // Reference of friction in statics: position, slip at this position, bed normal, and normal force at the
  // last iteration.
  struct LaidReference {
    Vec3 place = Vec3::Zero(), slip = Vec3::Zero(), normal = Vec3::UnitZ();
    double normal_force = 0;                          // N
    bool known() const { return place.allFinite(); }  // false: no friction
  };
  // Cache for a bed that is a surface; it saves time and does not change results. There is no contact within
  // `clear` of `centre`, because the signed distance is 1-Lipschitz. `hint`: nearest triangle of the last
  // query.
  struct Cache {
    Vec3 centre = Vec3::Zero();
    double clear = -1;
    int hint = -1;
  };
  // Most points do not touch, so this struct contains only the data that every evaluation reads for all
  // points. Other lists hold the rest by the index of the point; only points in contact have a PointHistory.
  struct Point {
    // Local nodes. second: other node of the element whose middle is the point; -1: the point is a node.
    int node = 0, second = -1;
    int element = -1;        // local
    int law = 0;             // index into laws_
    int history_index = -1;  // index into histories_; -1: none
    bool counted = true;     // this rank counts it in sums
  };
  // of_nodes(): interpolates nodal values to the point. fraction_on_node(): fraction of a force on the point
  // that acts on a node.
  static Vec3 of_nodes(const Point& p, std::span<const Vec3> values) {
    const Vec3& first = values[p.node];
    return p.second < 0 ? first : Vec3(0.5 * (first + values[p.second]));
  }
  static double fraction_on_node(const Point& p, int node) {
    if (p.second < 0) return p.node == node ? 1 : 0;
    return p.node == node || p.second == node ? 0.5 : 0;
  }
  size_t index_of(const Point& p) const { return static_cast<size_t>(&p - points_.data()); }
  const PointLaw& law(const Point& p) const { return laws_[p.law]; }
  ContactStart start(const Point& p) const;
  const PointHistory& history(const Point& p) const {
    static const PointHistory none;
    return p.history_index < 0 ? none : histories_[p.history_index];
  }
  void store(Point& p, const PointHistory& h);
  bool laid() const { return !laid_.empty(); }
  Vec3 line_direction(const Point& p, const Kinematics& state) const;
  void add(const Point& p, const Vec3& residual, const Mat3* K, const Mat3* C, Assembler& assembler) const;
  // Friction of the first phase of statics. In the second phase its potential replaces friction in the line
  // search.
  PressedFriction pressed_friction_at(const Point& p, const Vec3& x) const;
  double contact_distance(const Point& p) const { return law(p).radius + law(p).law.normal.smoothing; }
  // Sets gap, normal and curvature of the trial for a point at x [m]. Returns false if the point does not
  // touch; the gap to a surface is then limited to `beyond` [m] more than where contact begins.
  bool locate(const Point& p, const Vec3& x, double beyond, ContactTrial& trial) const;
  // Signed distance of x [m] if it is less than `max_distance` [m]; else infinity.
  double gap(const Vec3& x, double max_distance) const;
  // convex: without the geometric stiffness of a curved bed, which is negative over a mound.
  ContactForce contact(const Point& p, const Kinematics& state, bool derivatives, ContactTrial& trial,
                       bool convex = false) const;
  // Suction state of a point at the start of a step. Suction does not act in statics, which has no path in
  // time.
  SuctionState suction_state(const Point& p, const Kinematics& state) const {
    return state.moves() && suction_ ? history(p).soil : SuctionState{};
  }

  const LocalMesh& mesh_;
  Plane plane_;
  std::shared_ptr<const Surface> surface_;          // null: the plane
  std::shared_ptr<const ContactForceTable> table_;  // referenced by the laws; may be null
  Box bounds_ = Box::everything();                  // bounding box of the surface
  std::vector<PointLaw> laws_;                      // each distinct law once
  std::vector<Point> points_;
  std::vector<StepStart> starts_;
  std::vector<LaidReference>
      laid_;  // in statics with friction; empty: slip and normal are those of histories_
  bool full_friction_ = false;
  double full_slip_ = 0;
  std::vector<PointHistory> histories_;
  std::vector<int> vacant_;  // free indices in histories_
  Account account_;
  mutable std::vector<Cache> cache_;     // empty: a plane
  bool suction_ = false;                 // at least one point has suction
  std::vector<double> longest_element_;  // m, longest element at each local node
  LineNeighbours line_;
  FrictionMode friction_ = FrictionMode::contact;
};

}  // namespace hawser
