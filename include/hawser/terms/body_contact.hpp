// Contact of bodies with bodies: corners, edges, balls and faces of one volume with the surface of another.
//
// An edge is an axis like the element of a line (contact_along_axis.hpp), attached to its body; a corner is a
// point of it. By the basis of its stiffness a volume touches with its corners and balls (per_point), its
// edges (per_length) or its faces (per_area); model::body_pairs says who leads. Friction acts at each point
// of contact, with an elastic slip of its own. See docs/theory/body-contact.md.
#pragma once

#include <mpi.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/active_contact.hpp"
#include "hawser/terms/against_body.hpp"
#include "hawser/terms/body_friction_points.hpp"
#include "hawser/terms/body_skeleton.hpp"
#include "hawser/terms/contact_along_axis.hpp"
#include "hawser/terms/contact_resultant.hpp"
#include "hawser/terms/rigid_bodies.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser {

class BodyContactPoints;

// Where a rigid body is and how it moves: of the point its unknowns belong to, which is at `centre` in the
// frame of its shapes. Places y are in that frame.
struct BodyFrame {
  Vec3 centre = Vec3::Zero(), x = Vec3::Zero();  // m
  Mat3 R = Mat3::Identity();                     // body axes to space axes
  Vec3 v = Vec3::Zero(), a = Vec3::Zero();       // m/s, m/s², space axes
  Vec3 w = Vec3::Zero(), alpha = Vec3::Zero();   // rad/s, rad/s², body axes

  Vec3 to_space(const Vec3& y) const { return x + R * (y - centre); }
  Vec3 to_body(const Vec3& p) const { return centre + R.transpose() * (p - x); }
  Vec3 velocity(const Vec3& y) const { return v + R * w.cross(y - centre); }
};

struct BodyVolume {
  std::shared_ptr<const Surface> surface;
  BodySkeleton skeleton;
};

class BodyContactTerm final : public ForceTerm,
                              public CouplesNodes,
                              public LimitsSteps,
                              public ScalesResiduals,
                              public HasFriction,
                              public ActsOnBodies {
 public:
  // volumes: all of the case, in its order. Pairs are those of model::body_pairs. comm: of all ranks.
  BodyContactTerm(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
                  std::shared_ptr<const Bodies> bodies, std::vector<BodyVolume> volumes);

  std::string_view name() const override { return "body contact"; }
  void couple(Couplings& to) const override;
  bool recouple(const Kinematics&, double) override;
  void enable_friction(bool on) override { friction_on_ = on; }
  void update_ghosts() override;
  // Looks ahead in a time step.
  void prepare(const Kinematics& committed, double h) override;
  void limit_step(const Kinematics& committed, ImpactEvents& to) const override;
  // Refuses a step in which a corner or edge passes through the other body.
  Verdict check_step(const Kinematics& trial) const override;
  void unresolved(const Kinematics& trial, UnresolvedImpacts& to) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  double round_off(const Kinematics& at, double h) const override;
  // Of contact with other bodies and with volumes that are fixed or move as prescribed, in the last accepted
  // state.
  std::vector<std::string> origins(int body) const override;
  std::vector<BodyForce> forces_on(int body, const Kinematics& at) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> records(NodeRange of) const override;
  // Collective.
  void restore(const std::vector<CheckpointRecord>& records) override;

  // SolveError where two volumes overlap far deeper than the contact of corners and edges shows. Collective.
  void watch(const Kinematics& at);
  // m, over the accepted steps, of the pairs this rank counts.
  double largest_penetration() const;
  // Adds what touches in the accepted state, of those pairs; volumes are those of the case.
  void active_contacts(ActiveContacts& out) const;
  // Likewise, on the surface of what does not lead: one for each eighth of the box of what leads.
  void resultants(ContactResultants& out) const;

 private:
  struct PairBody {
    int body = -1, node = -1, block = -1;  // of the case; local node and block, -1: prescribed or elsewhere
    int global = -1;                       // mesh node, -1: prescribed
    Vec3 centre = Vec3::Zero();            // m, of mass, body frame
    double mass = HUGE_VAL;                // kg
    Mat3 inertia = Mat3::Zero();           // kg m², body axes
  };
  struct Both {
    BodyFrame A, B;
    Vec3 across(const Vec3& y) const { return B.to_body(A.to_space(y)); }  // a place of A, as B sees it
    // Of the twelve unknowns.
    Vec12 rates() const { return (Vec12() << A.v, A.w, B.v, B.w).finished(); }
    Vec12 accelerations() const { return (Vec12() << A.a, A.alpha, B.a, B.alpha).finished(); }
    void move(double time);                              // on at their velocities
    Mat3 turn() const { return B.R.transpose() * A.R; }  // axes of A to those of B
    // Rotation vector of A against B from there on, rad, axes of B.
    Vec3 turned_since(const Both& start) const;
  };
  struct Pair {
    size_t a = 0, b = 0;         // volumes
    NormalLaw law;               // of what stands out of a against the surface of b, per unit of the basis
    FrictionLaw friction;        // likewise
    double share = 1, mass = 0;  // of the force; kg, effective
    double size = 0;             // m, of what stands out
    double round = 0;            // m, radius for which tunnelling takes a corner
    double most_depth = 0;       // m, most that passes in a step where they may meet
    // A root of the inverse of the mass of the twelve unknowns; none where motion is prescribed.
    Mat12 root = Mat12::Zero();
    bool hides = false;                        // as of model::BodyPair
    int other = -1;                            // the pair in which b leads, where both do
    bool here = false, counted = false;        // this rank owns a body of it; counts it
    double damping = 0, work = 0;              // J, over the accepted steps
    double dissipated = 0;                     // J, likewise, by friction
    double damping_power = 0, work_power = 0;  // W, at the start of the step
    // In the committed state, for the step that is tried:
    double potential = 0;           // J
    double stiffness = 0;           // N/m, of all springs that touch
    double frequency = 0;           // rad/s, of the fastest motion on its springs; 0: nothing touches
    double energy = 0;              // J, of the motion of the bodies against each other, and potential
    Vec12 elastic = Vec12::Zero();  // residual without damping
    Both at;
    double penetration = 0;        // m, penetration
    double met = 0;                // m, largest of that since the two were clear of each other
    double depth = 0;              // m, largest, over the accepted steps
    ActiveContact now;             // in the accepted state
    Vec12 acts = Vec12::Zero();    // residual there
    bool acted = false;            // there was an accepted state, of statics or of a step
    ContactResultants resultants;  // likewise
    BodyFrictionPoints touching;   // likewise, where there is friction

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("damping", "J", self.damping);
      each("work", "J", self.work);
      each("friction", "J", self.dissipated);
      each("largest penetration", "m", self.depth);
      each("since clear", "m", self.met);
    }
  };
  // What a pair does in a state: the residual of the twelve unknowns (x_A, theta_A, x_B, theta_B), positions
  // in space axes and rotations as material increments, and its derivatives if they were asked for.
  struct Sum {
    AgainstBody on;
    double potential = 0;                      // J
    double damping_power = 0, work_power = 0;  // W, the latter brought in by prescribed motion
    double depth = 0;                          // m, largest penetration
    bool active = false;
  };
  // Stiffness of the contact springs (with their dampers) in the committed state, and their forces.
  static constexpr AxisContactMode kStiffness{true, true, true}, kSprings{};
  struct Nearest {
    double gap = 0;  // m
    Vec12 gradient = Vec12::Zero();
  };
  bool owned(const PairBody& body) const { return body.node >= 0 && body.node < mesh_.owned; }
  BodyFrame frame(size_t volume, const Kinematics& at) const;
  Both both(const Pair& pair, const Kinematics& at) const;
  using Eighths = std::array<ResultantSum, 8>;  // frame of the surface
  // The law of friction in a step of length h [s], 0 in statics; the contact points go to `points`, and their
  // sums to `eighths`, if given.
  struct Slipping {
    FrictionLaw law;
    double step = 0;
    BodyFrictionPoints* points = nullptr;
    Eighths* eighths = nullptr;
  };
  Slipping slipping(const Pair& pair, double h) const {
    return {friction_on_ ? pair.friction : FrictionLaw(), h};
  }
  // Without friction unless it is given.
  Sum contact(const Pair& pair, const Both& at, const AxisContactMode& mode) const {
    return contact(pair, at, mode, Slipping());
  }
  Sum contact(const Pair& pair, const Both& at, const AxisContactMode& mode, const Slipping& friction) const;
  void contact_of_edge(const Pair& pair, const Both& at, const RigidPose& surface, const SkeletonPart& part,
                       const AxisContactMode& mode, const Slipping& friction,
                       BodyContactPoints& points) const;
  // The state at the start of the step of the place xi of a part that touches in the trial.
  ContactStart start_of(const Pair& pair, const Both& trial, const SkeletonPart& part, double xi,
                        ContactRates* rates) const;
  // Adds a point at z, in the frame of the surface, of a part of radius r at y, in the frame of a's volume.
  void add_resultant(const Pair& pair, const Vec3& y, const Vec3& z, double r, const AxisContactPoint& point,
                     Eighths& to) const;
  ContactResultants resultants_of(const Pair& pair, const Both& at, const Eighths& sums) const;
  // J, half of the work that friction at these points takes on the way of the step.
  double half_dissipation(const Pair& pair, const Both& trial, const BodyFrictionPoints& points) const;
  // W, what prescribed motion brings in against the friction at the points of the committed state.
  double friction_power(const Pair& pair) const;
  // Sends the slip of pairs of two floating bodies from the rank of the first to that of the second.
  void share_slip();
  // Whether a ball, in the frame of a volume, may be nearer to its surface than `gap` [m].
  bool near(size_t volume, const Vec3& centre, double radius, double gap) const;
  bool tunnels(const Pair& pair, const Kinematics& trial) const;
  // Step limits, in body_contact_step_limits.cpp. rad/s, largest natural frequency of the bodies on these
  // springs.
  double frequency(const Pair& pair, const Sum& stiffness) const;
  // J, of the motion of the bodies against each other.
  double relative_energy(const Pair& pair, const Both& at) const;
  // m/s, upper bound of the speed at which any point of one body approaches the other.
  double fastest(const Pair& pair, const Both& at) const;
  // Smallest gap of corners, edges and balls, where it is below `within` [m].
  std::optional<Nearest> nearest(const Pair& pair, const Both& at, double within) const;
  // s, at most `most`: the step from there that resolves the impacts within it.
  double followed(const Pair& pair, const Both& at, double most) const;
  void limit_by(const Pair& pair, ImpactEvents& to) const;
  // body_contact_penetration.cpp. m, of the deepest place of the faces of one volume in the other.
  double deepest(size_t volume, const BodyFrame& of, size_t in, const BodyFrame& there) const;
  void check_overlap(double time);

  MPI_Comm comm_;
  const LocalMesh& mesh_;
  std::shared_ptr<const Bodies> bodies_;
  std::vector<BodyVolume> volumes_;
  std::vector<Box> boxes_;                   // of their surfaces
  std::vector<PairBody> bodies_of_volumes_;  // likewise
  std::vector<Pair> pairs_;
  std::vector<std::string> names_;  // of volumes, with their bodies
  bool coupled_ = false, friction_on_ = true;
};

}  // namespace hawser
