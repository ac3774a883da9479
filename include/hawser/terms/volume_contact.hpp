// Contact of lines with volumes at the nodes of the lines (OMAE2006-92155): a spring, a damper and
// friction between each node and the surface of each volume it can meet. See docs/theory/contact.md.
//
// The `line` method (contact along the element) will be a term beside this one: it shares the volumes, the
// laws and kernels/volume_contact.hpp, but has a stencil of two nodes and its own candidates.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/volume_contact.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/bodies.hpp"

namespace hawser {

struct ContactVolume {
  std::shared_ptr<const Surface> surface;  // in the body's frame
  int body = -1;                           // index into Bodies; -1: fixed in space
  model::Volume settings;  // basis, stiffness, smoothing, damping, friction; basis not automatic
};

// What contact must know of an owned node.
struct ContactNode {
  double radius = 0;  // m, half the contact diameter; 0: the node takes no part
  double mass = 0;    // kg, nodal mass: the effective mass of relative_damping
};

struct Penetration {
  double depth = 0;  // m
  int node = -1;     // mesh node, -1: none yet
  int volume = -1;
  double time = 0;  // s
};

// A stiffness per length [N/m²] when none is given, and why it is what it is.
struct AutomaticStiffness {
  double per_length = 0;
  std::string reason;
};
// radius [m], weight per length [N/m], length [m] and EA [N] of the heaviest line that can meet the volume.
AutomaticStiffness automatic_contact_stiffness(double radius, double weight, double length, double EA);

class VolumeContact final : public ForceTerm {
 public:
  // nodes: one for each owned node. All lengths and indices are checked, std::invalid_argument otherwise.
  VolumeContact(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                std::vector<ContactVolume> volumes, std::vector<ContactNode> nodes);

  // Off in the first stage of statics. While off no slip is kept.
  void enable_friction(bool on) { friction_on_ = on; }

  std::string_view name() const override { return "volume contact"; }
  void prepare(const Kinematics& committed, double h) override;
  // So that no node gets deeper past a surface in a step than half its radius at its present speed.
  double longest_step(const Kinematics& committed) const override;
  void evaluate(const Kinematics& trial, Sink& sink) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  void fields(FieldRegistry& registry) const override;
  std::vector<HistoryRecord> save() const override;
  void restore(const std::vector<HistoryRecord>& records) override;

  // Largest penetration of this rank's nodes over the run.
  Penetration largest_penetration() const;
  int candidates() const { return static_cast<int>(pairs_.size()); }
  int touching() const;

  // Force of one volume on one candidate pair's node, space axes: K = -df/dx, C = -df/dv. In statics (step 0)
  // velocities don't count.
  struct Force {
    bool touches = false;
    Vec3 total = Vec3::Zero(), friction = Vec3::Zero();
    Mat3 K = Mat3::Zero(), C = Mat3::Zero();
  };
  Force force(const Kinematics& trial, int pair, bool tangent, bool convex = false);

 private:
  // What a step leaves behind, body frame. Kept while the pair touches.
  struct History {
    Vec3 slip = Vec3::Zero(), normal = Vec3::UnitZ();    // m, -
    Vec3 force = Vec3::Zero(), friction = Vec3::Zero();  // N
    double normal_force = 0, damping_force = 0;          // N, of which damping
    double potential = 0, depth = 0;                     // J, m
    int hint = -1;                                       // nearest triangle
    bool touches = false;
  };
  struct Pair {
    int node = 0, volume = 0;
    double touch = 0;  // m, distance below which there is a force: radius + smoothing
    ContactLaw law;
    ContactStart start;
    History history;
    // Cache of this step, changes the time and never the answer: no contact nearer than `clear` to `centre`
    // (the signed distance is 1-Lipschitz); nearest triangle of the last query.
    Vec3 centre = Vec3::Zero();
    double clear = -1;
    int hint = -1;
  };
  // Sums of an owned node over the accepted steps.
  struct Account {
    double friction = 0, damping = 0, work = 0;  // J
    double depth = 0, time = 0;                  // m, s: largest penetration
    int volume = -1;
  };

  // The surface seen from y (body frame); false when it is out of touch. With the gap in `trial` when known.
  bool locate(Pair& pair, const Vec3& y, double reach, ContactTrial& trial) const;
  Force resolve(Pair& pair, const Kinematics& trial, bool tangent, bool convex);
  PointContact contact(Pair& pair, const Kinematics& at, bool derivatives, bool convex, ContactTrial& trial);
  ContactLaw law(int node, int volume) const;
  void pose_bodies(double time, std::vector<RigidPose>& poses) const;
  size_t body(int volume) const {
    return static_cast<size_t>(volumes_[static_cast<size_t>(volume)].body + 1);
  }
  Vec3 line_tangent(const Kinematics& at, int node) const;
  void account(const Pair& pair, const History& next, const Vec3& y);

  std::shared_ptr<const Bodies> bodies_;
  std::vector<ContactVolume> volumes_;
  std::vector<ContactNode> nodes_;
  std::vector<int> global_, block_;  // of owned nodes: mesh node, local 3-block
  std::vector<int> before_, after_;  // neighbours along the line (local nodes), itself at an end
  std::vector<double> tributary_;    // m, line length that belongs to the node
  std::vector<double> element_;      // m, longest element at the node
  std::vector<Box> boxes_;           // of the volumes
  std::vector<Pair> pairs_;          // sorted by node and volume
  std::vector<Account> accounts_;
  std::vector<RigidPose> poses_, start_poses_;  // of space and of the bodies, at the trial and at the start
  bool friction_on_ = true;
};

}  // namespace hawser
