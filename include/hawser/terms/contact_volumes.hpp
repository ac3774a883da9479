// The volumes that lines touch: their surfaces and settings, the poses of their bodies, their current
// stiffness, and the ends of lines that are excluded from contact with them.
#pragma once

#include <mpi.h>

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "hawser/advice/step_findings.hpp"
#include "hawser/geometry/surface.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/system/couplings.hpp"
#include "hawser/terms/against_body.hpp"
#include "hawser/terms/bodies.hpp"
#include "hawser/terms/contact_laws.hpp"

namespace hawser {

struct ContactVolume {
  std::shared_ptr<const Surface> surface;  // in the body's frame
  int body = -1;                           // index into Bodies; -1: fixed in space
  model::Volume settings;  // basis, stiffness, smoothing, damping, friction; basis not automatic
  bool automatic = false;  // the stiffness is the program's own, per length: raised as far as lines need it
  double most = std::numeric_limits<double>::infinity();  // N/m², but no further
  bool off = false;                                       // lines do not touch it
};

// The ends of a line that are excluded from contact with a volume, as lengths of the material.
struct ExcludedEnds {
  int line = 0, volume = 0;     // volume: index into those of the contact
  double end_a = 0, end_b = 0;  // m of line from end A and from end B on
};

// The part of an interval of a line that takes part in contact with a volume, as a share of the interval;
// none: no part does.
struct ContactShare {
  double from = 0, to = 1;
  bool all() const { return from <= 0 && to >= 1; }
  bool none() const { return !(from < to); }
  bool has(double xi) const { return xi >= from && xi <= to; }
};

// A place of a line in the trial, as an automatic stiffness sees it (docs/theory/contact.md, "Stiffness that
// follows the run"): how deep, the part of its force that inertia does not take (0 to 1), how fast it moves
// relative to the volume.
struct PressedPoint {
  double depth = 0, radius = 0;  // m; the deepest of the element
  double mean_depth = 0;         // m, of a straight element the mean over its length, of a beam the deepest
  double static_share = 1;
  double speed = 0, mass = 0;  // m/s; kg in the sense of the law
  bool held = false;           // by an end of the line: no stiffness moves it
};

class ContactVolumes {
 public:
  // std::invalid_argument when a volume has no surface, no such body or no stiffness. comm: of those who hold
  // the lines.
  ContactVolumes(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                 std::vector<ContactVolume> volumes, MPI_Comm comm);

  int size() const { return static_cast<int>(volumes_.size()); }
  // With the stiffness of the trial.
  const model::Volume& settings(int volume) const { return at(volume).settings; }
  advice::VolumeLaw law_of(int volume) const;
  const Surface& surface(int volume) const { return *at(volume).surface; }
  const Box& box(int volume) const { return boxes_[volume]; }

  // Poses of the volumes at the start of the step, and in the last trial for which pose() was called.
  void pose_start(const Kinematics& at) { pose(at, start_poses_); }
  void pose_trial(const Kinematics& at) { pose(at, poses_); }
  const RigidPose& start_pose(int volume) const { return start_poses_[body(volume)]; }
  const RigidPose& trial_pose(int volume) const { return poses_[body(volume)]; }
  RigidPose pose_of(int volume, const Kinematics& at) const;
  // Of all bodies that carry volumes, by body(volume).
  std::vector<RigidPose> poses(const Kinematics& at) const;
  size_t body(int volume) const { return static_cast<size_t>(at(volume).body + 1); }
  // Whether its body floats, so that the reaction to the force on the line acts on the body.
  bool floats(int volume) const { return bodies_->floats(at(volume).body); }
  FloatingFrame floating_frame(int volume, const Kinematics& at) const;
  // Couples lines with floating bodies whose volumes are near; thickest: m, largest radius on this rank.
  bool recouple(const Kinematics& committed, double h, double thickest);
  void couple(Couplings& to) const;

  // Between steps, and the same on all ranks: whether lines touch it from then on.
  void enable(int volume, bool on) { volumes_[volume].off = !on; }
  // Before the first step, and the same on all ranks.
  void exclude_ends(std::vector<ExcludedEnds> ends);
  // Of the interval [from, to] of a line's arc [m].
  ContactShare takes_part(int line, int volume, double from, double to) const;

  // Stiffness in the volume's basis, of the last accepted state. A checkpoint stores it, so that a restart
  // raises an automatic one to it.
  double stiffness(int volume) const { return committed_[volume]; }
  void raise_to(int volume, double stiffness);
  bool automatic(int volume) const { return at(volume).automatic; }
  // The trial stiffness of each volume, from which the demand for more is computed.
  std::vector<double> stiffnesses() const;
  void require(int volume, const NormalLaw& law, const PressedPoint& p, double step,
               std::vector<double>& wanted) const;
  // Raises each to the largest demand of all ranks. Returns whether any rose, equal on all ranks. Collective
  // where a volume is automatic.
  bool raise(std::vector<double>& wanted);
  // Resets the trial stiffness to that of the last accepted state, or accepts it; whether any value changed.
  bool revert_raise();
  void commit_raise() { committed_ = stiffnesses(); }
  bool raised(int volume) const { return settings(volume).normal_stiffness != stiffness(volume); }
  // Whether a line could pass through the volume and come out on its far side; not of a plane.
  bool has_back(int volume) const;
  // m, largest penetration for which a volume's law holds: the radius, or the last row of its table.
  double deepest(int volume, double radius) const;

 private:
  const ContactVolume& at(int volume) const { return volumes_[volume]; }
  // Index into the poses: space first, then the bodies in their order.
  void pose(const Kinematics& at, std::vector<RigidPose>& poses) const;

  const LocalMesh& mesh_;
  std::shared_ptr<const Bodies> bodies_;
  std::vector<ContactVolume> volumes_;  // with the stiffness of the trial
  std::vector<double> committed_;       // stiffness
  std::vector<Box> boxes_;
  std::vector<ExcludedEnds> excluded_ends_;  // sorted by line and volume
  std::vector<RigidPose> poses_, start_poses_;
  MPI_Comm comm_;
  std::vector<std::array<int, 3>> near_;  // nodes of an element and of a body that may meet, of all ranks
};

}  // namespace hawser
