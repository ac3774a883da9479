// The seabed under the lines: a plane or a surface with a spring, a damper and friction at every node and
// half way along cables' elements, shared out by the length of line that belongs to each. The law at a point,
// with friction and the tangent of both: kernels/surface_contact_law.cpp. See docs/theory/seabed.md.
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

class SeabedTerm final : public ForceTerm, public HasFriction {
 public:
  struct Plane {
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();
    double gap(const Vec3& x) const { return normal.dot(x - point); }
  };
  struct PointLaw {
    double radius = 0;  // m, less what the bed is lowered by beside a held end
    ContactLaw law;     // of the point: N/m; without normal stiffness it takes no part
    Suction suction;
    // What the point stands for: length of line [m], its weight in water [N], EA over the element's length
    // [N/m].
    double length = 0, weight = 0, axial_stiffness = 0;
    bool operator==(const PointLaw&) const = default;
  };
  // One for each owned node, and one for each local element, of the point half way between its nodes, or
  // none.
  struct PointLaws {
    std::vector<PointLaw> nodes, middles;
  };

  // A surface is in axes of space, the ground inside.
  SeabedTerm(const LocalMesh& mesh, const Plane& plane, PointLaws laws);
  SeabedTerm(const LocalMesh& mesh, std::shared_ptr<const Surface> surface, PointLaws laws);
  // held: local nodes that are supported, which the bed leaves alone.
  SeabedTerm(const LocalMesh& mesh, const model::Case& c, const std::vector<int>& held);

  std::string_view name() const override { return "seabed"; }
  void prepare(const Kinematics& committed, double h) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  // Of the bed on a local node in the accepted state, N, space axes.
  Vec3 node_force(int node) const;
  void fields(FieldRegistry& registry) const override;
  std::vector<HistoryKind> history() const override;
  std::vector<HistoryRecord> records(NodeRange of) const override;
  void restore(const std::vector<HistoryRecord>& records) override;

  void enable_friction(bool on) override { friction_ = on ? Friction::contact : Friction::none; }
  // Friction in statics acts from where the lines were laid, in two stages, until the first step in time.
  // First it is that under a normal force which does not follow the trial, so that it has a potential: the
  // weight of what lies at the start, then the contact force of the state that has been found. Then it is the
  // law of motion. firm: in the first stage friction springs are as stiff as the line's elements instead of
  // the law's, and what they mobilise is mobilised in the second.
  void lay(const std::vector<Vec3>& places, const Kinematics& start, bool firm);  // m, by local node or NaN
  // In the first stage: friction is fully mobilised by this slip [m] at the least, so that lines slip
  // smoothly.
  void mobilise_by(double least_slip) { least_slip_ = least_slip; }
  void press_by_contact(const Kinematics& at);
  void follow_contact(const Kinematics& at);

  // What lies of a line in the accepted state.
  struct OnBed {
    // m of line: on the bed, of that with friction, and of that where friction is not fully mobilised.
    double lies = 0, laid = 0, held = 0;
    double taken = 0;  // N, tension that friction takes, signed from end A to end B
  };
  // By line of the mesh, at the points that this rank counts.
  std::vector<OnBed> on_bed(const Kinematics& at) const;

  int active_count() const;

 private:
  struct History : SurfaceContactPoint {
    using SurfaceContactPoint::SurfaceContactPoint;
    bool active = false, held = false;
    // How deep it has been since it landed [m], and whether the soil holds it: until it is lifted too far.
    double deepest = 0;

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      SurfaceContactPoint::quantities(self, each, "N", "J");
      each("touches", "", self.active);
      each("deepest", "m", self.deepest);
      each("held by suction", "", self.held);
    }
  };
  // J, taken out so far at the points that this rank counts; suction's is damping's.
  struct Account {
    double friction = 0, damping = 0;

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("friction work", "J", self.friction);
      each("damping work", "J", self.damping);
    }
  };
  // Of a point at the start of the step: where it was, how far off the bed, and which way the line ran.
  struct Start {
    Vec3 point = Vec3::Zero(), direction = Vec3::UnitX();
    double gap = 0;
  };
  enum class Friction { none, pressed, contact };
  // What friction in statics is counted from: a place, the slip there, and the bed's normal and the normal
  // force at the last iteration.
  struct Laid {
    Vec3 place = Vec3::Zero(), slip = Vec3::Zero(), normal = Vec3::UnitZ();
    double pressed = 0;                               // N
    bool known() const { return place.allFinite(); }  // else there is no friction
  };
  // Of a bed that is a surface, changes the time and never the answer: no force nearer than `clear` to
  // `centre` (the signed distance is 1-Lipschitz); nearest triangle of the last query.
  struct Cache {
    Vec3 centre = Vec3::Zero();
    double clear = -1;
    int hint = -1;
  };
  // Most points are out of touch: what is read of all of them at every evaluation is as little as can be, and
  // the rest of a point stands in the other lists, at its place. Only those that touch have a history.
  struct Point {
    int node = 0, second = -1;  // local; second: of the element it is half way along, -1 at a node
    int element = -1;           // local
    int law = 0;                // of laws_
    int touch = -1;             // of histories_; -1: none
    bool counted = true;        // this rank counts it in sums
  };
  // What nodes have, at the point; and what of a force on the point a node bears.
  static Vec3 of_nodes(const Point& p, std::span<const Vec3> values) {
    const Vec3& first = values[p.node];
    return p.second < 0 ? first : Vec3(0.5 * (first + values[p.second]));
  }
  static double share(const Point& p, int node) {
    if (p.second < 0) return p.node == node ? 1 : 0;
    return p.node == node || p.second == node ? 0.5 : 0;
  }
  size_t place(const Point& p) const { return static_cast<size_t>(&p - points_.data()); }
  const PointLaw& law(const Point& p) const { return laws_[p.law]; }
  ContactStart start(const Point& p) const;
  const History& history(const Point& p) const {
    static const History none;
    return p.touch < 0 ? none : histories_[p.touch];
  }
  void remember(Point& p, const History& h);
  bool laid() const { return !laid_.empty(); }
  Vec3 line_direction(const Point& p, const Kinematics& at) const;
  void add(const Point& p, const Vec3& residual, const Mat3* K, const Mat3* C, Assembler& assembler) const;
  // Of the first stage of statics, and what stands for the law's in the line search of the second.
  PressedFriction pressed(const Point& p, const Vec3& x) const;
  double contact_distance(const Point& p) const { return law(p).radius + law(p).law.normal.smoothing; }
  // The bed seen from x [m]: gap, normal and curvature of the trial. False out of touch; the gap of a surface
  // is then cut to `beyond` [m] more than where it touches.
  bool locate(const Point& p, const Vec3& x, double beyond, ContactTrial& trial) const;
  // Signed distance of x when less than `most` [m], infinite else.
  double gap(const Vec3& x, double most) const;
  // convex: without negative stiffness of a hollow.
  PointContact contact(const Point& p, const Kinematics& at, bool derivatives, ContactTrial& trial,
                       bool convex = false) const;
  // How far above where springs touch suction goes [m].
  double suction_range(const Point& p, double step) const;
  Pull pull(const Point& p, const ContactTrial& trial, double step) const;
  void hold(const Point& p, double gap, bool moves, History& next) const;

  const LocalMesh& mesh_;
  Plane plane_;
  std::shared_ptr<const Surface> surface_;          // null: the plane
  std::shared_ptr<const ContactForceTable> table_;  // that laws point to; may be null
  Box bounds_ = Box::everything();                  // of the surface
  std::vector<PointLaw> laws_;                      // each once
  std::vector<Point> points_;
  std::vector<Start> starts_;
  std::vector<Laid> laid_;  // in statics with friction; empty: slip and normal are the histories'
  bool firm_ = false;
  double least_slip_ = 0;
  std::vector<History> histories_;
  std::vector<int> vacant_;  // places in histories_ of points that have left the bed
  Account account_;
  mutable std::vector<Cache> cache_;  // empty: a plane
  bool suction_ = false;              // of some point
  std::vector<double> element_;       // m, longest at a local node
  LineNeighbours line_;
  Friction friction_ = Friction::contact;
};

}  // namespace hawser
