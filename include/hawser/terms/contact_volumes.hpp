// The volumes that lines touch: surfaces, settings, poses of their bodies, current stiffness, and the ends of
// lines that are excluded from contact.
#pragma once

#include <mpi.h>

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "hawser/advice/contact_stiffness.hpp"
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
  bool automatic = false;  // the program chooses the stiffness per length and raises it as needed
  double max_stiffness =
      std::numeric_limits<double>::infinity();  // N/m², upper limit of an automatic stiffness
  // Likewise of what elements that meet the volume end-on request, N/m².
  double max_stiffness_end_on = std::numeric_limits<double>::infinity();
  bool off = false;  // excluded from contact with lines
};

// Lengths at the ends of a line that are excluded from contact with a volume.
struct ExcludedEnds {
  int line = 0, volume = 0;     // volume: index in ContactVolumes
  double end_a = 0, end_b = 0;  // m, from end A and from end B
};

// Part of an interval of a line that takes part in contact with a volume, as fractions of the interval.
struct ActiveInterval {
  double from = 0, to = 1;
  bool all() const { return from <= 0 && to >= 1; }
  bool none() const { return !(from < to); }
  bool has(double xi) const { return xi >= from && xi <= to; }
};

// Contact state of an element in the trial that determines the demand for automatic stiffness
// (docs/theory/contact.md, "Stiffness that follows the run"): penetration, static fraction of its force (0 to
// 1), and speed relative to the volume.
struct PressedPoint {
  double depth = 0, radius = 0;  // m; depth: largest of the element
  double mean_depth = 0;         // m; for a straight element the mean over its length, for a beam the largest
  double static_fraction = 1;
  double speed = 0, mass = 0;  // m/s; kg per unit of the law
  bool end_on = false;         // the element is nearer to the normal than to the surface
  bool held = false;           // by an end of the line, so that stiffness cannot reduce the depth
};

class ContactVolumes {
 public:
  // Throws std::invalid_argument if a volume has no surface, no valid body or no stiffness. comm: the ranks
  // that hold the lines.
  ContactVolumes(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                 std::vector<ContactVolume> volumes, MPI_Comm comm);

  MPI_Comm comm() const { return comm_; }
  int size() const { return static_cast<int>(volumes_.size()); }
  // Settings with the stiffness of the trial.
  const model::Volume& settings(int volume) const { return at(volume).settings; }
  advice::VolumeLaw law_of(int volume) const;
  const Surface& surface(int volume) const { return *at(volume).surface; }
  const Box& box(int volume) const { return boxes_[volume]; }

  // Poses of the volumes at the start of the step, and in the last trial for which pose() was called.
  void pose_start(const Kinematics& state) { pose(state, start_poses_); }
  void pose_trial(const Kinematics& state) { pose(state, poses_); }
  const RigidPose& start_pose(int volume) const { return start_poses_[body(volume)]; }
  const RigidPose& trial_pose(int volume) const { return poses_[body(volume)]; }
  RigidPose pose_of(int volume, const Kinematics& state) const;
  // Poses of all bodies that carry volumes, indexed by body(volume).
  std::vector<RigidPose> poses(const Kinematics& state) const;
  size_t body(int volume) const { return static_cast<size_t>(at(volume).body + 1); }
  // True if the volume's body floats, so that the reaction acts on the body.
  bool floats(int volume) const { return bodies_->floats(at(volume).body); }
  FloatingFrame floating_frame(int volume, const Kinematics& state) const;
  // Lists the pairs of elements and floating bodies that may touch. thickest: largest radius on this rank, m.
  // Returns true on all ranks if the list has changed. Collective.
  bool refresh_couplings(const Kinematics& from, double h, double thickest);
  void list_couplings(Couplings& to) const;
  // True if the list has the element and the floating body of the volume.
  bool coupled(const Element& e, int volume) const;

  // Switches contact of lines with a volume on or off. Called between steps, equally on all ranks.
  void enable(int volume, bool on) { volumes_[volume].off = !on; }
  // Called before the first step, equally on all ranks.
  void exclude_ends(std::vector<ExcludedEnds> ends);
  // Part of the interval [from, to] of a line's arc length [m] that takes part in contact.
  ActiveInterval takes_part(int line, int volume, double from, double to) const;

  // Stiffness of the last accepted state, in the volume's basis.
  double stiffness(int volume) const { return committed_[volume]; }
  // True if an automatic stiffness has its largest value.
  bool has_largest_stiffness(int volume) const {
    return at(volume).automatic && !(stiffness(volume) < at(volume).max_stiffness);
  }
  bool automatic(int volume) const { return at(volume).automatic; }
  bool any_automatic() const;
  // Raises each automatic stiffness to that of a checkpoint, by volume; 0 on ranks that have not read it.
  // Collective if a volume is automatic.
  void restore(std::vector<double> stiffness);
  // AdaptsStiffness::take_raises.
  std::vector<advice::StiffnessRaise> take_raises();
  // Trial stiffness of each volume, the initial value for the demands of require().
  std::vector<double> stiffnesses() const;
  void require(int volume, const NormalLaw& law, const PressedPoint& p, double step,
               std::vector<double>& required) const;
  // Raises each automatic stiffness to the largest demand of all ranks. Returns true on all ranks if any was
  // raised. Collective if a volume is automatic.
  bool raise(std::vector<double>& required);
  // revert_raise() resets the trial stiffness to that of the last accepted state and returns whether any
  // value changed; commit_raise() accepts it.
  bool revert_raise();
  void commit_raise() { committed_ = stiffnesses(); }
  bool raised(int volume) const { return settings(volume).normal_stiffness != stiffness(volume); }
  // True if a line could pass through the volume and leave on its far side; false for a plane.
  bool has_back(int volume) const;
  // Largest penetration for which the volume's law holds, m: the line's radius, or the last row of a force
  // table.
  double depth_limit(int volume, double radius) const;

 private:
  const ContactVolume& at(int volume) const { return volumes_[volume]; }
  // Computes the poses: space first, then the bodies in their order.
  void pose(const Kinematics& state, std::vector<RigidPose>& poses) const;

  const LocalMesh& mesh_;
  std::shared_ptr<const Bodies> bodies_;
  std::vector<ContactVolume> volumes_;  // with the stiffness of the trial
  std::vector<double> committed_;       // stiffness
  std::vector<double> reported_;        // stiffness at the last take_raises()
  std::vector<Box> boxes_;
  std::vector<ExcludedEnds> excluded_ends_;  // sorted by line and volume
  std::vector<RigidPose> poses_, start_poses_;
  MPI_Comm comm_;
  // Element's nodes and body's node that may touch, sorted: those of which this rank owns any.
  std::vector<std::array<int, 3>> near_;
};

}  // namespace hawser
