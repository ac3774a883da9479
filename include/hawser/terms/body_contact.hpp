// Contact between bodies: corners, edges, balls and faces of one volume touch the surface of another.
//
// An edge is an axis like the element of a line (contact_along_axis.hpp) and moves with its body. By the
// basis of its stiffness a volume touches with its corners and balls (per_point), its edges (per_length) or
// its faces (per_area). model::body_pairs determines the slave. Friction acts at each contact point with its
// own elastic slip. See docs/theory/body-contact.md.
#pragma once

#include <mpi.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hawser/math/function_ref.hpp"
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

// Pose and motion of a rigid body: of the point that its unknowns belong to, which lies at `centre` in the
// frame of the body's shapes. Points y are in that frame.
struct BodyFrame {
  Vec3 centre = Vec3::Zero(), x = Vec3::Zero();  // m
  Mat3 R = Mat3::Identity();                     // body axes to space axes
  Vec3 v = Vec3::Zero(), a = Vec3::Zero();       // m/s, m/s², space axes
  Vec3 w = Vec3::Zero(), alpha = Vec3::Zero();   // rad/s, rad/s², body axes

  Vec3 to_space(const Vec3& y) const { return x + R * (y - centre); }
  Vec3 to_body(const Vec3& p) const { return centre + R.transpose() * (p - x); }
  Vec3 velocity(const Vec3& y) const { return v + R * w.cross(y - centre); }
};

// Two volumes in contact; indices of the case.
struct TouchingVolumes {
  int volume = 0, other_volume = 0;
};

// Two volumes that the elastic energy [J] of their contact drives apart; out: way out of contact, m. Indices
// of the case.
struct DrivenApart {
  int volume = 0, other_volume = 0;
  double energy = 0, out = 0;
};

struct BodyVolume {
  std::shared_ptr<const Surface> surface;
  BodySkeleton skeleton;
};

// Points of a body A in contact with the surface of a body B. The levers are the largest distances of a point
// from the positions that are the unknowns of the bodies.
struct TouchingPoints {
  double weight = 0;                // sum of the weights: number, length [m] or area [m²]
  double force = 0;                 // N, sum of the normal forces
  double peak = 0;                  // N, N/m or N/m², largest SurfaceContactPoint::peak
  double lever_a = 0, lever_b = 0;  // m
};

class BodyContact final : public ForceTerm,
                          public CouplesFixedNodes,
                          public LimitsSteps,
                          public ScalesResiduals,
                          public HasFriction,
                          public ChecksRest,
                          public ReportsBodyForces {
 public:
  // volumes: all volumes of the case, in its order. The pairs are those of model::body_pairs. comm: all
  // ranks.
  BodyContact(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
              std::shared_ptr<const Bodies> bodies, std::vector<BodyVolume> volumes);

  std::string_view checkpoint_key() const override { return "body contact"; }
  void list_couplings(Couplings& to) const override;
  void enable_friction(bool on) override { friction_on_ = on; }
  void renumber() override;
  // For a time step (h > 0) also computes the contact frequency. Where bodies follow a path, in time or in
  // statics with friction, also checks the overlap of the volumes.
  void prepare(const Kinematics& from, double h) override;
  void limit_step(const Kinematics& committed, ImpactEvents& to) override;
  // Refuses a step in which a body passes through another: corners and edges, and on long paths the faces;
  // and one in which a point in contact passes the middle of the other body.
  Verdict check_step(const Kinematics& trial) const override;
  void unresolved(const Kinematics& trial, UnresolvedImpacts& to) override;
  void evaluate(const Kinematics& trial, Assembler& assembler) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& state) const override;
  double round_off(const Kinematics& state, double h) const override;
  // Of contact with other bodies and with volumes that are fixed or move as prescribed, in the last accepted
  // state.
  std::vector<std::string> load_components(int body) const override;
  std::vector<BodyForce> forces_on(int body, const Kinematics& state) const override;
  std::vector<CheckpointKind> checkpoint_kinds() const override;
  std::vector<CheckpointRecord> checkpoint_records(NodeRange range) const override;
  // Collective.
  void restore(const std::vector<CheckpointRecord>& records) override;

  // No two volumes may overlap far deeper than the contact of their corners and edges shows.
  void check_at_rest(const Kinematics& equilibrium) override;
  // Pairs in contact whose springs have more energy than the motion of the bodies and the other forces, over
  // the way out of contact, take up: they drive the bodies apart. start: with its accelerations. Collective.
  std::vector<DrivenApart> driven_apart(const Kinematics& start) const;
  // Volumes with forces on each other in a state. The same on all ranks. Collective.
  std::vector<TouchingVolumes> touching(const Kinematics& state) const;
  // Largest penetration over the accepted steps of the pairs that this rank counts, m.
  double largest_penetration() const;
  // Adds the active contacts of those pairs in the accepted state. Volumes have their indices in the case.
  void active_contacts(ActiveContacts& out) const;
  // Likewise, on the surface of the master: one for each eighth of the box of the slave.
  void resultants(ContactResultants& out) const;

 private:
  struct PairBody {
    int body = -1, node = -1, block = -1;  // case; local node, block; -1: prescribed or remote
    int global = -1;                       // mesh node, -1: prescribed
    Vec3 centre = Vec3::Zero();            // m, centre of mass in the body frame
    double mass = HUGE_VAL;                // kg
    Mat3 inertia = Mat3::Zero();           // kg m², body axes
  };
  struct PairFrames {
    BodyFrame A, B;
    Vec3 across(const Vec3& y) const { return B.to_body(A.to_space(y)); }  // from A's frame to B's
    // Rates of the twelve unknowns.
    Vec12 rates() const { return (Vec12() << A.v, A.w, B.v, B.w).finished(); }
    Vec12 accelerations() const { return (Vec12() << A.a, A.alpha, B.a, B.alpha).finished(); }
    // Velocity and acceleration of A's centre [space axes] and turning [axes of A] relative to B.
    std::pair<Vec6, Vec6> relative_motion() const;
    void move(double time);                              // moves both on by `time` [s] at their velocities
    Mat3 turn() const { return B.R.transpose() * A.R; }  // from the axes of A to those of B
    // Rotation vector of A relative to B since `start`, rad, axes of B.
    Vec3 turned_since(const PairFrames& start) const;
  };
  // Natural frequencies of two bodies on the springs of their contact, rad/s; 0: none.
  struct Frequencies {
    double highest = 0;
    // The lowest one that steps must resolve: all higher ones together may be lost in a step without a
    // significant error.
    double significant = 0;
  };
  struct Pair {
    size_t a = 0, b = 0;   // volumes
    NormalLaw law;         // of a's features on the surface of b, per unit of the basis
    FrictionLaw friction;  // per unit of the basis
    model::StiffnessBasis basis = model::StiffnessBasis::automatic;  // of volume a
    bool lower_counts = false;          // the law has the lower stiffness of both volumes
    double force_factor = 1, mass = 0;  // factor on the force; effective mass, kg
    double size = 0;                    // m, largest extent of volume a
    double round = 0;                   // m, radius assumed for corners in the tunnelling test
    double max_approach = 0;            // m, largest approach allowed in a step in which the bodies may meet
    // A root of the inverse mass matrix of the twelve unknowns; zero rows for prescribed motion.
    Mat12 root = Mat12::Zero();
    bool needs_overlap_check = false;         // see model::BodyPair
    int other = -1;                           // index of the pair with a and b swapped; -1: none
    bool owns_body = false, counted = false;  // this rank owns one of the bodies; counts the pair
    double damping = 0, work = 0;             // J, over the accepted steps
    double dissipated = 0;                    // J, dissipated by friction over the accepted steps
    double work_power = 0;                    // W, at the start of the step
    // Quantities of the committed state, for the trial step:
    double potential = 0;           // J
    double stiffness = 0;           // N/m, sum over all normal springs in contact
    TouchingPoints points;          // in contact
    Frequencies frequencies;        // on the contact springs
    double energy = 0;              // J, kinetic energy of the relative motion plus potential
    Vec12 elastic = Vec12::Zero();  // residual without damping
    PairFrames frames;
    double penetration = 0;              // m, penetration
    double penetration_since_clear = 0;  // m, largest of that since the two volumes were last apart
    double depth = 0;                    // m, largest, over the accepted steps
    ActiveContact now;                   // in the accepted state
    Vec12 residual = Vec12::Zero();      // there
    bool has_accepted_state = false;     // of statics or of a step
    ContactResultants resultants;        // likewise
    BodyFrictionPoints touching;         // likewise, where there is friction

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("damping", "J", self.damping);
      each("work", "J", self.work);
      each("friction", "J", self.dissipated);
      each("largest penetration", "m", self.depth);
      each("since clear", "m", self.penetration_since_clear);
    }
  };
  // Contact of a pair in a state: residual for the twelve unknowns (x_A, theta_A, x_B, theta_B), positions in
  // space axes and rotations as material increments, and its derivatives on request.
  struct Sum {
    AgainstBody residual;
    double potential = 0;   // J
    double work_power = 0;  // W, external work of prescribed motion
    double depth = 0;       // m, largest penetration
    TouchingPoints touching;
    bool active = false;
  };
  // kStiffness: tangent of the contact springs with their dampers, without negative stiffness; kSprings:
  // forces of the springs alone.
  static constexpr AxisContactMode kStiffness{true, true, true}, kSprings{};
  struct Nearest {
    double gap = 0;  // m
    Vec12 gradient = Vec12::Zero();
  };
  bool owned(const PairBody& body) const { return body.node >= 0 && body.node < mesh_.owned; }
  BodyFrame frame(size_t volume, const Kinematics& state) const;
  PairFrames frames_of(const Pair& pair, const Kinematics& state) const;
  using Eighths = std::array<ResultantSum, 8>;  // frame of the surface
  // Half of the work of the dampers over the step to `end`, or, without it, from the start of the step, J.
  struct DampingWork {
    const PairFrames* end = nullptr;
    double sum = 0;
  };
  // The deepest point, at the start of the step, of those that pass the middle of the other body in the step.
  struct PressedThrough {
    double depth = 0;      // m, at the start of the step; 0: none
    double thickness = 0;  // m, of the other body there
    double speed = 0;      // m/s, into it
  };
  // The law of friction in a step of length h [s], 0 in statics; the contact points go to `points`, their
  // sums to `eighths`, the work of the dampers to `damping`, and the search for points that pass the middle
  // of the other body to `pressed`, if given.
  struct Slipping {
    FrictionLaw law;
    double step = 0;
    BodyFrictionPoints* points = nullptr;
    Eighths* eighths = nullptr;
    DampingWork* damping = nullptr;
    PressedThrough* pressed = nullptr;
  };
  Slipping slipping(const Pair& pair, double h) const {
    return {friction_on_ ? pair.friction : FrictionLaw(), h};
  }
  // Contact without friction.
  Sum contact(const Pair& pair, const PairFrames& at, const AxisContactMode& mode) const {
    return contact(pair, at, mode, Slipping());
  }
  Sum contact(const Pair& pair, const PairFrames& at, const AxisContactMode& mode,
              const Slipping& friction) const;
  void contact_of_edge(const Pair& pair, const PairFrames& at, const RigidPose& surface,
                       const SkeletonPart& part, const AxisContactMode& mode, const Slipping& friction,
                       BodyContactPoints& points) const;
  // State at the start of the step of the point xi of a feature that touches in the trial.
  ContactStart start_of(const Pair& pair, const PairFrames& trial, const SkeletonPart& part, double xi,
                        ContactRates* rates) const;
  // Adds half of the work of the damper of the point of a's volume at y, in the frame of the surface at z.
  void add_damping_work(const Pair& pair, const Vec3& y, const Vec3& z, const AxisContactPoint& point,
                        DampingWork& to) const;
  // Adds the point of a part of radius r at y, in the frame of a's volume, that is `now` in the other body.
  void add_pressed(const Pair& pair, const Vec3& y, double r, const SurfacePoint& now,
                   PressedThrough& to) const;
  // Adds a point at z, in the frame of the surface, of a part of radius r at y, in the frame of a's volume.
  void add_resultant(const Pair& pair, const Vec3& y, const Vec3& z, double r, const AxisContactPoint& point,
                     Eighths& to) const;
  ContactResultants resultants_of(const Pair& pair, const PairFrames& at, const Eighths& sums) const;
  void store_first_forces(Pair& pair, double h) const;
  // J, half of the work dissipated by friction at these points along their displacement in the step.
  double half_dissipation(const Pair& pair, const PairFrames& trial, const BodyFrictionPoints& points) const;
  // Sum of the stiffness k' of damped_friction() over the points of the committed state, in a step of length
  // h [s] (0: statics), N/m.
  double friction_stiffness(const Pair& pair, double h) const;
  // Power of prescribed motion against friction at the points of the committed state, W.
  double friction_power(const Pair& pair) const;
  // Sends the slip of pairs of two floating bodies from the rank of the first body to that of the second.
  void send_slip();
  // True if a ball, in the frame of a volume, may be nearer to the volume's surface than `gap` [m].
  bool near(size_t volume, const Vec3& centre, double radius, double gap) const;
  bool tunnels(const Pair& pair, const Kinematics& trial) const;
  // Step limits, in body_contact_step_limits.cpp. stiffness: contact in kStiffness.
  Frequencies frequencies(const Pair& pair, const PairFrames& at, const Sum& stiffness) const;
  // Kinetic energy of the relative motion of the bodies, J.
  double relative_energy(const Pair& pair, const PairFrames& at) const;
  // Upper bound of the speed at which any point of one body approaches the other, m/s.
  double fastest(const Pair& pair, const PairFrames& at) const;
  // Smallest gap of corners, edges and balls if it is below `within` [m].
  std::optional<Nearest> nearest(const Pair& pair, const PairFrames& at, double within) const;
  using FrequencyAt = FunctionRef<double(const PairFrames&)>;  // rad/s
  // Largest step from a state, at most `max_step` [s], that resolves the frequency at its end.
  static double resolved_step(const PairFrames& at, double max_step, FrequencyAt frequency_at);
  void limit_by(const Pair& pair, ImpactEvents& to) const;
  // Depth of the deepest point of the faces of one volume in the other, m; in body_contact_penetration.cpp.
  double overlap_depth(size_t volume, const BodyFrame& frame, size_t other,
                       const BodyFrame& other_frame) const;
  // The larger of the two depths of a pair, m.
  double overlap_depth(const Pair& pair, const PairFrames& at) const;
  // m, overlap that is regarded as an error if it exceeds that of corners, edges and balls.
  double allowed_overlap(const Pair& pair) const;
  // Points that pass the middle of the other body from the start of the step to the trial.
  std::optional<advice::BodyPressedThrough> pressed_through(const Pair& pair, const Kinematics& trial) const;
  bool overlaps_within_step(const Pair& pair, const Kinematics& trial) const;
  void check_overlap(double time);

  MPI_Comm comm_;
  const LocalMesh& mesh_;
  std::shared_ptr<const Bodies> bodies_;
  std::vector<BodyVolume> volumes_;
  std::vector<Box> boxes_;                   // of the volumes' surfaces
  std::vector<PairBody> bodies_of_volumes_;  // by volume
  std::vector<Pair> pairs_;
  std::vector<std::string> names_;  // names of the volumes with their bodies
  bool friction_on_ = true;
};

}  // namespace hawser
