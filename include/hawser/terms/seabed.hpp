// The seabed under the lines: a plane with a spring, a damper and friction at every node, shared out by the
// length of line that belongs to it. See docs/theory/seabed.md.
#pragma once

#include <mpi.h>

#include <vector>

#include "hawser/kernels/volume_contact.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/line_neighbours.hpp"

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
  struct NodeLaw {
    double radius = 0;  // m; of a node that takes no part < 0
    ContactLaw law;     // of the node: N/m
  };

  // nodes: one for each owned node.
  SeabedTerm(const LocalMesh& mesh, const Plane& plane, std::vector<NodeLaw> nodes);
  // held: local nodes that are supported, which the bed leaves alone.
  SeabedTerm(const LocalMesh& mesh, const model::Case& c, const std::vector<int>& held);

  std::string_view name() const override { return "seabed"; }
  void prepare(const Kinematics& committed, double h) override;
  void evaluate(const Kinematics& trial, Sink& sink) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  Vec3 node_force(const Kinematics& at, int node) const override;
  void fields(FieldRegistry& registry) const override;
  std::vector<HistoryRecord> save() const override;
  void restore(const std::vector<HistoryRecord>& records) override;

  // Off in the first stage of statics. While off no slip is kept.
  void enable_friction(bool on) { friction_on_ = on; }
  bool has_friction() const { return has_friction_; }
  // From a static state without friction: the slip that pulling the line out of where it was laid without
  // tension, from a held end on the bed on, has brought; friction of the next statics is reckoned from there.
  // held: nodes of the mesh that are lines' ends, supported. Collective.
  void lay(MPI_Comm comm, const Kinematics& at, const std::vector<int>& held);

  const Plane& plane() const { return plane_; }
  int touching() const;

 private:
  struct History {
    bool touches = false;
    Vec3 slip = Vec3::Zero(), force = Vec3::Zero(), friction = Vec3::Zero();  // m, N, N
    double damping_force = 0, potential = 0;                                  // N, J
    double friction_work = 0, damping_work = 0;                               // J, taken out so far
  };
  struct Point {
    int node = 0, block = 0;
    double radius = 0;
    ContactLaw law;
    ContactStart start;
    History history;
    double pressed = 0;  // N, at the last prepare() of statics
  };
  PointContact contact(const Point& p, const Kinematics& at, bool derivatives) const;
  double friction_potential(const Point& p, const Vec3& x) const;

  const LocalMesh& mesh_;
  Plane plane_;
  std::vector<Point> points_;
  LineNeighbours line_;
  bool friction_on_ = true, has_friction_ = false, laid_ = false;
};

}  // namespace hawser
