// The seabed under the lines: a plane or a surface with a spring, a damper and friction at every node and
// half way along cables' elements, shared out by the length of line that belongs to each. The law at a point,
// with friction and the tangent of both: kernels/surface_contact_law.cpp. See docs/theory/seabed.md.
#pragma once

#include <mpi.h>

#include <memory>
#include <optional>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/suction.hpp"
#include "hawser/kernels/surface_contact_law.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/line_neighbours.hpp"
#include "hawser/terms/surface_contact_points.hpp"

namespace hawser {

namespace model {
struct Case;
}

class SeabedTerm final : public ForceTerm {
 public:
  struct Plane {
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();
    double gap(const Vec3& x) const { return normal.dot(x - point); }
  };
  struct PointLaw {
    double radius = 0;  // m; of a point that takes no part < 0
    ContactLaw law;     // of the point: N/m
    Suction suction;
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

  // Off in the first stage of statics. While off no slip is kept.
  void enable_friction(bool on) { friction_on_ = on; }
  // Before statics: lines whose nodes are all nearer to the bed than `near` [m, one a line; < 0: never] were
  // laid there. Until lay(), while friction is off, springs keep them about there. Collective.
  void lay_at_start(MPI_Comm comm, const Kinematics& start, const std::vector<double>& near);
  // From a static state without friction: the slip that pulling the line out of where it was laid has
  // brought; friction of the next statics is reckoned from there. A line was laid where it started, or
  // without tension from a held end on the bed or in it on. held: nodes of the mesh that are lines' ends,
  // supported. tension: by local node [N]; with it friction is full from where the line lies on, as far as
  // what there is of tension goes, however little the line was pulled. Returns the lines of the mesh that lie
  // from end to end and were not laid at the start: they have no friction. Collective.
  std::vector<int> lay(MPI_Comm comm, const Kinematics& at, const std::vector<int>& held,
                       const std::vector<double>& tension = {});

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
      each("deepest", "m", self.deepest), each("held by suction", "", self.held);
    }
  };
  // J, taken out so far at the points that this rank counts; suction's is damping's.
  struct Account {
    double friction = 0, damping = 0;

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("friction work", "J", self.friction), each("damping work", "J", self.damping);
    }
  };
  // Of a point at the start of the step: where it was, how far off the bed, and which way the line ran.
  struct Start {
    Vec3 point = Vec3::Zero(), tangent = Vec3::UnitX();
    double gap = 0;
  };
  // Where a point was laid; the slip and normal that friction in statics is reckoned from.
  struct Origin {
    Vec3 point, normal;
  };
  struct Laid {
    Vec3 slip, normal;
  };
  // Of a bed that is a surface, changes the time and never the answer: no force nearer than `clear` to
  // `centre` (the signed distance is 1-Lipschitz); nearest triangle of the last query.
  struct Seen {
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
  const Origin* origin(const Point& p) const {
    return origins_.empty() || !origins_[place(p)] ? nullptr : &*origins_[place(p)];
  }
  Vec3 tangent(const Point& p, const Kinematics& at) const;
  void add(const Point& p, const Vec3& residual, const Mat3* K, const Mat3* C, Assembler& assembler) const;
  // Of all nodes of the mesh, on every rank.
  struct Lying {
    std::vector<double> x, contact_distance;  // m; < 0 of what the bed leaves alone
    Vec3 place(int node) const { return Eigen::Map<const Vec3>(x.data() + 3 * node); }
  };
  Lying lying(MPI_Comm comm, const Kinematics& at) const;
  // A point's number on all ranks: its node of the mesh, or behind all of these its element of the mesh.
  size_t number(const Point& p) const;
  // What full friction is reckoned from.
  struct Full {
    std::vector<double> tension, limit, length;  // N, N, m; by number of a point
  };
  Full full(MPI_Comm comm, const Kinematics& at, const std::vector<double>& tension) const;
  // Off the bed's normal, from where the point was laid: what its spring is stretched by in the first stage
  // of statics. Nothing of other points and later.
  bool kept(const Point& p, double step) const { return !friction_on_ && !(step > 0) && origin(p); }
  Vec3 strayed(const Point& p, const Vec3& x) const;
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
  double friction_potential(const Point& p, const Vec3& x, const Vec3& normal) const;

  const LocalMesh& mesh_;
  Plane plane_;
  std::shared_ptr<const Surface> surface_;          // null: the plane
  std::shared_ptr<const ContactForceTable> table_;  // that laws point to; may be null
  Box bounds_ = Box::everything();                  // of the surface
  std::vector<PointLaw> laws_;                      // each once
  std::vector<Point> points_;
  std::vector<Start> starts_;
  std::vector<Laid> laid_;  // of a static state; empty: of none, slip and normal are the histories'
  std::vector<History> histories_;
  std::vector<int> vacant_;  // places in histories_ of points that have left the bed
  Account account_;
  std::vector<double> pressed_;                 // N, at the last prepare() of statics with friction
  std::vector<std::optional<Origin>> origins_;  // empty: nothing was laid
  mutable std::vector<Seen> seen_;              // empty: a plane
  bool suction_ = false;                        // of some point
  std::vector<double> element_;                 // m, longest at a local node
  std::vector<bool> buried_;  // by node of the mesh: the soil holds it (terms/buried.hpp), not the bed
  LineNeighbours line_;
  std::vector<bool> laid_at_start_;  // by line of the mesh
  bool friction_on_ = true;
};

}  // namespace hawser
