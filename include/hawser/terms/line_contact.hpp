// Contact of lines with volumes anywhere along their elements: the laws of the `nodes` method per length of
// line, integrated over the stretches of each element's axis that touch. See docs/theory/line-contact.md.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hawser/kernels/axis_shape.hpp"
#include "hawser/kernels/line_contact.hpp"
#include "hawser/terms/volume_contact.hpp"

namespace hawser {

// What contact must know of an element.
struct LineContactElement {
  double radius = 0;             // m, half the contact diameter; 0: the element takes no part
  double mass_per_length = 0;    // kg/m: the effective mass of relative_damping
  Vec3 tangent = Vec3::UnitX();  // of a beam's axis, in the material axes of its nodes
};

class LineContact final : public ForceTerm {
 public:
  // elements: one for each of mesh.elements. Indices are checked, std::invalid_argument otherwise. A
  // stiffness per point counts once an element.
  LineContact(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies, std::vector<ContactVolume> volumes,
              std::vector<LineContactElement> elements);

  // Off in the first stage of statics. While off no slip is kept.
  void enable_friction(bool on) { friction_on_ = on; }

  std::string_view name() const override { return "line contact"; }
  void prepare(const Kinematics& committed, double h) override;
  void evaluate(const Kinematics& trial, Sink& sink) override;
  void commit(const Kinematics& accepted) override;
  Energy energy(const Kinematics& at) const override;
  // contact_force, contact_normal_force, friction_force as the element's shape functions share them out.
  void fields(FieldRegistry& registry) const override;
  std::vector<HistoryRecord> save() const override;
  void restore(const std::vector<HistoryRecord>& records) override;

  // Largest penetration of the elements this rank counts, over the run; `node` is the nearer end.
  Penetration largest_penetration() const;
  int candidates() const { return static_cast<int>(pairs_.size()); }
  // Pairs of an element and a volume that touch, of those this rank counts.
  int touching() const;

 private:
  // What an accepted step leaves at a Gauss point, body frame, forces per length. Kept while it touches.
  struct Point {
    double xi = 0, from = 0, to = 0;                     // place; its panel: all of it touches
    double weight = 0;                                   // m
    Vec3 slip = Vec3::Zero(), normal = Vec3::UnitZ();    // m, -
    Vec3 force = Vec3::Zero(), friction = Vec3::Zero();  // N/m
    double normal_force = 0, damping_force = 0;          // N/m, of which damping
    double potential = 0, gap = 0;                       // J/m, m
  };
  struct Pair {
    int element = 0, volume = 0;
    double touch = 0;  // m, distance below which there is a force: radius + smoothing
    int levels = 1;
    ContactLaw law;               // per length
    AxisShape start = nowhere();  // the axis at the start of the step
    std::vector<Point> history;   // by xi
    // Cache of this step, changes the time and never the answer: no contact nearer than `clear` to `centre`;
    // nearest triangle of the last query.
    Vec3 centre = Vec3::Zero();
    double clear = -1;
    int hint = -1;
  };
  // Sums of an element over the accepted steps.
  struct Account {
    double friction = 0, damping = 0, work = 0;  // J
    double depth = 0, time = 0;                  // m, s: largest penetration
    int volume = -1, end = 0;
  };
  // Of a point that touches in the trial, at the start of the step: from the history, or where it came from.
  struct Origin {
    bool touched = true;
    double xi = 0, gap = 0;        // -, m
    Vec3 gradient = Vec3::Zero();  // of the gap
  };
  struct Moving;
  class Gap;

  std::vector<ContactStretch> locate(Pair& pair, const AxisShape& shape, const RigidPose& pose) const;
  bool sample(Pair& pair, const AxisShape& shape, const RigidPose& pose, double xi, bool moves,
              ContactTrial& trial, double within = 0) const;
  Origin origin(Pair& pair, double xi) const;
  ContactStart start(const Pair& pair, const Origin& from, double xi) const;
  void panel(Pair& pair, const AxisShape& shape, const RigidPose& pose, const ContactStretch& s, bool moves,
             const Sink& sink, AxisShape::Generalised& g) const;
  ContactLaw applied(const Pair& pair) const {
    return {pair.law.normal, friction_on_ ? pair.law.friction : FrictionLaw{}};
  }
  ContactLaw law(size_t element, const model::Volume& v) const;
  void account(Pair& pair, const AxisShape& shape, const std::vector<Point>& next);
  AxisEnds ends(const Kinematics& at, int element) const;
  void pose_bodies(double time, std::vector<RigidPose>& poses) const;
  size_t body(int volume) const {
    return static_cast<size_t>(volumes_[static_cast<size_t>(volume)].body + 1);
  }
  double length(int element) const { return lengths_[static_cast<size_t>(element)]; }

  static AxisShape nowhere() {
    AxisEnds e;
    e.beam = false;
    e.x1 = e.x2 = Vec3::Zero();
    return AxisShape(e);
  }

  const LocalMesh& mesh_;
  std::shared_ptr<const Bodies> bodies_;
  std::vector<ContactVolume> volumes_;
  std::vector<LineContactElement> elements_;
  std::vector<double> lengths_;  // m, of the elements, unstretched
  std::vector<Box> boxes_;       // of the volumes
  std::vector<Pair> pairs_;      // sorted by element and volume
  std::vector<Account> accounts_;
  std::vector<RigidPose> poses_, start_poses_;  // of space and of the bodies, at the trial and at the start
  bool friction_on_ = true;
};

}  // namespace hawser
