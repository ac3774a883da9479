// What contact of lines with volumes has in common, wherever along the line it is looked for: the volumes and
// their laws, where the bodies are, what a place of contact remembers and the account of energies. The ways
// of looking are VolumeContact (at nodes) and LineContact (along elements). See docs/theory/contact.md.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/volume_contact.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/system/force_term.hpp"
#include "hawser/terms/against_body.hpp"
#include "hawser/terms/bodies.hpp"
#include "hawser/terms/touch.hpp"

namespace hawser {

struct ContactVolume {
  std::shared_ptr<const Surface> surface;  // in the body's frame
  int body = -1;                           // index into Bodies; -1: fixed in space
  model::Volume settings;  // basis, stiffness, smoothing, damping, friction; basis not automatic
  bool automatic = false;  // the stiffness is the program's own, per length: raised as far as lines need it
  double most = std::numeric_limits<double>::infinity();  // N/m², but no further
};

// The ends of a line that have no contact with a volume: material, whatever moves.
struct LeftOut {
  int line = 0, volume = 0;     // volume: index into those of the contact
  double end_a = 0, end_b = 0;  // m of line from end A and from end B on
};

struct Penetration {
  double depth = 0;  // m
  int node = -1;     // mesh node, -1: none yet
  int volume = -1;
  double time = 0;  // s
};

// What an accepted step leaves at a place of contact, body frame. Forces are N at a node, N/m along a line.
struct ContactHistory {
  Vec3 slip = Vec3::Zero(), normal = Vec3::UnitZ();    // m, -
  Vec3 force = Vec3::Zero(), friction = Vec3::Zero();  // N or N/m
  double normal_force = 0, damping_force = 0;          // N or N/m, of which damping
  double potential = 0;                                // J or J/m

  // force, energy: their units.
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each, const char* force, const char* energy) {
    each("slip", "m", self.slip), each("normal", "", self.normal);
    each("force", force, self.force), each("friction force", force, self.friction);
    each("normal force", force, self.normal_force), each("damping force", force, self.damping_force);
    each("potential", energy, self.potential);
  }

  ContactHistory() = default;
  ContactHistory(const PointContact& c, const Vec3& n)
      : slip(c.slip),
        normal(n),
        force(c.force),
        friction(c.friction),
        normal_force(c.normal.force),
        damping_force(c.normal.force - c.normal.elastic),
        potential(c.normal.potential) {}
};

// The normal law of a volume. share: what turns its stiffness and its table into those of what touches (a
// node, a length); smoothing [m]: unless the volume says; mass [kg in the same sense]: effective, of the
// damping.
NormalLaw normal_law(const model::Volume& v, double share, double smoothing, double mass);

class Contact : public ForceTerm, public CouplesNodes, public LimitsSteps, public RaisesStiffness {
 public:
  // Off in the first stage of statics. While off no slip is kept.
  void enable_friction(bool on) { friction_on_ = on; }

  // Of what this rank counts: the largest penetration over the run; how much touches now; how much may in
  // the step that is tried.
  virtual Penetration largest_penetration() const = 0;
  virtual int touching() const = 0;
  virtual int candidates() const = 0;
  // Adds what touches in the accepted state, of what this rank counts; volumes are those of volume_name().
  virtual void touches(Touches& out) const = 0;
  int volumes() const { return static_cast<int>(volumes_.size()); }
  // Lines see the bodies that float and carry volumes near them.
  bool recouple(const Kinematics& committed, double h) override;
  void couple(Couplings& to) const override;
  // Before the first step, and the same on all ranks.
  void leave_out(std::vector<LeftOut> ends);
  // In the volume's basis; of an automatic one as far as it has been raised in accepted states, and so far it
  // is raised again when a run goes on from a checkpoint.
  double stiffness(int volume) const { return committed_stiffness_[static_cast<size_t>(volume)]; }
  void raise_to(int volume, double stiffness);
  // Nothing goes through a volume between the ends of a step, nor deeper into one than its law is for.
  Verdict judge(const Kinematics& trial) const override;
  // Where a line is deeper in a volume than its law is for, in words for the user; empty: nowhere. Local.
  std::string deeper_than_allowed(const Kinematics& trial) const;
  const std::string& volume_name(int volume) const {
    return volumes_[static_cast<size_t>(volume)].settings.name;
  }

 protected:
  // Parts of a surface are one wall where they hang together no farther away than this, times the distance at
  // which contact begins: so walls part and come together while the farther of them is out of touch.
  static constexpr double kTogether = 1.1;

  // std::invalid_argument when a volume has no surface, no such body or no stiffness. comm: of those who hold
  // the lines.
  Contact(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies, std::vector<ContactVolume> volumes,
          MPI_Comm comm);

  // Automatic stiffness (docs/theory/contact.md, "Stiffness that follows the run"). A place of a line in the
  // trial: how deep, the part of its force that inertia does not take (0 to 1), how fast it moves relative to
  // the volume.
  struct Pressed {
    double depth = 0, radius = 0;  // m
    double still = 1;
    double speed = 0, mass = 0;  // m/s; kg in the sense of law()
    bool held = false;           // by an end of the line: no stiffness moves it
  };
  bool automatic(int volume) const { return volumes_[static_cast<size_t>(volume)].automatic; }
  // Of each volume what it has, to be asked for more.
  std::vector<double> stiffnesses() const;
  void ask(int volume, const NormalLaw& law, const Pressed& p, double step,
           std::vector<double>& wanted) const;
  // To the most that any rank asks for; whether that is more than before, the same on all ranks. Collective
  // where a volume is automatic.
  bool raise(std::vector<double>& wanted);
  // Trial stiffness is that of the last accepted state, or becomes it; whether that changed anything.
  bool forget_raise();
  void keep_raise();
  bool raised(int volume) const {
    const size_t k = static_cast<size_t>(volume);
    return volumes_[k].settings.normal_stiffness != committed_stiffness_[k];
  }
  // m, how deep a volume's law is for: the radius, or what its table tells.
  double deepest(int volume, double radius) const;
  // Where a line is deeper than that in the trial that was evaluated last.
  struct TooDeep {
    int node = -1, volume = -1;  // of the mesh; -1: nowhere
    double depth = 0, radius = 0;
  };
  virtual TooDeep too_deep(const Kinematics& trial) const = 0;
  // Whether something goes through a volume between the ends of the step (tunnelling).
  virtual bool tunnels(const Kinematics& trial) const = 0;
  virtual const Mesh& lines() const = 0;

  // share: what turns the stiffness basis of the volume into the method's own (N/m a node, N/m² a length);
  // diameter [m] of the line there; mass: effective, of the damping, in the same sense.
  static ContactLaw law(const model::Volume& v, double share, double diameter, double mass);
  // With friction or not.
  ContactLaw applied(const ContactLaw& l) const {
    return {l.normal, friction_on_ ? l.friction : FrictionLaw{}};
  }

  // A step is not to get a place of a line deeper into a surface than half its radius [m].
  static void limit_depth(double radius, const Approach& at, Strikes& to);
  // Whether that place strikes (kernels/impact.hpp): what inertia takes deeper than the ramp of the law and
  // 0.2 % of the radius. share: of the place, what turns mass, in the sense of law(), into kg.
  static std::optional<Strike> strikes(const NormalLaw& law, double mass, double share, double radius,
                                       const Approach& at);
  // J, made where it parts in the step: `was` is of when that began, since when it has moved along the normal
  // by `away` [m], at that speed [m/s] now.
  static double made(const NormalLaw& law, double mass, double share, double radius,
                     const ContactHistory& was, double away, double speed);
  // Whether a step of h [s] follows it, so that it need not be asked.
  static bool follows(const NormalLaw& law, double mass, double h);
  // Whether it can, and whether limit_depth can tell of it, at that speed and acceleration, `gap` [m] away or
  // more.
  static bool may_strike(const NormalLaw& law, double mass, double radius, double speed, double acceleration);
  static bool may_limit(double radius, double gap, double speed, const Strikes& to) {
    return speed * to.most > (1 - 1e-9) * (std::max(gap, 0.0) + 0.5 * radius);
  }

  // Whether a ball of `radius` about y is as free as all was found to be within `clear` of `centre`. A Newton
  // iteration that diverges leaves these so far away that rounding is larger than the model: hence the
  // margin.
  static bool still_clear(double clear, const Vec3& centre, const Vec3& y, double radius) {
    return clear > 0 && (y - centre).norm() + radius < (1 - 1e-9) * clear;
  }

  // Of the stretch [from, to] of a line's arc [m] what touches a volume if it is near enough, as a share of
  // the stretch; none: nothing.
  struct Share {
    double from = 0, to = 1;
    bool all() const { return from <= 0 && to >= 1; }
    bool none() const { return !(from < to); }
    bool has(double xi) const { return xi >= from && xi <= to; }
  };
  Share takes_part(const Mesh& mesh, int line, int volume, double from, double to) const;

  // Space first, then the bodies in their order.
  void pose_bodies(const Kinematics& at, std::vector<RigidPose>& poses) const;
  // Of a body that is met on this rank.
  RigidPose pose_of(int volume, const Kinematics& at) const {
    const int body = volumes_[static_cast<size_t>(volume)].body;
    return body < 0 ? RigidPose{} : bodies_->pose(body, at);
  }
  FloatingFrame floating_frame(int volume, const Kinematics& at) const;
  // Whether the volume rides on a body that floats, so that what acts on the line acts on the body as well.
  bool floats(int volume) const { return bodies_->floats(volumes_[static_cast<size_t>(volume)].body); }
  // m, the largest radius of a line on this rank: how near is near.
  virtual double thickest() const = 0;
  size_t body(int volume) const {
    return static_cast<size_t>(volumes_[static_cast<size_t>(volume)].body + 1);
  }

  // What is to be asked of the volumes' surfaces, all points of one in one call: a mesh answers many much
  // faster than one by one, and the answers are the same.
  class Questions {
   public:
    void add(int volume, size_t who, const SurfaceQuestion& question);
    // what(who, answer) for all, and none are left.
    template <class What>
    void ask(const std::vector<ContactVolume>& volumes, What&& what) {
      for (size_t k = 0; k < of_.size(); ++k) {
        if (of_[k].empty()) continue;
        answers_.resize(of_[k].size());
        volumes[k].surface->query(of_[k], answers_);
        for (size_t i = 0; i < answers_.size(); ++i) what(who_[k][i], answers_[i]);
        of_[k].clear(), who_[k].clear();
      }
    }

   private:
    std::vector<std::vector<SurfaceQuestion>> of_;  // each volume
    std::vector<std::vector<size_t>> who_;
    std::vector<std::optional<SurfacePoint>> answers_;
  };

  // Sums of a node or an element over the accepted steps.
  struct Account {
    double friction = 0, damping = 0, work = 0;  // J
    double depth = 0, time = 0;                  // m, s: largest penetration
    int volume = -1, end = 0;                    // of an element: which end is nearer

    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("friction", "J", self.friction), each("damping", "J", self.damping);
      each("work", "J", self.work);
      each("largest penetration", "m", self.depth), each("time of it", "s", self.time);
      each("volume", "", self.volume), each("end", "", self.end);
    }

    bool empty() const { return !(depth > 0 || friction != 0 || damping != 0 || work != 0); }
    void reaches(double deep, double at, int into, int near = 0) {
      if (deep > depth) depth = deep, time = at, volume = into, end = near;
    }
  };
  // One end of a step of the trapezoid: forces of the history p, which act with the body turned by R, on the
  // way y0 -> y1 (body frame); share: of it and of the place. The motion splits exactly into that of the
  // body's material and that relative to it:
  // x1 - x0 = [p1 - p0 + (R1 - R0)(y0 + y1)/2] + (R0 + R1)/2 (y1 - y0).
  struct StepOfBody {
    Mat3 R0, R1;
    Vec3 shift;
    bool prescribed;  // else what it gives the line it loses itself: nothing is brought in
    StepOfBody(const RigidPose& before, const RigidPose& after, bool prescribes);
  };
  static void add_work(Account& sum, const StepOfBody& b, const ContactHistory& p, const Mat3& R,
                       const Vec3& y0, const Vec3& y1, double share);

  std::shared_ptr<const Bodies> bodies_;
  std::vector<ContactVolume> volumes_;  // with the stiffness of the trial
  std::vector<double> committed_stiffness_;
  std::vector<Box> boxes_;                      // of the volumes
  std::vector<LeftOut> left_out_;               // sorted by line and volume
  std::vector<RigidPose> poses_, start_poses_;  // of space and of the bodies, at the trial and at the start
  bool friction_on_ = true;

  const LocalMesh& local_;

 private:
  MPI_Comm comm_;
  std::vector<std::array<int, 3>> near_;  // nodes of an element and of a body that may meet, of all ranks
};

}  // namespace hawser
