// Finds where the axis of an element touches a volume: panels of the axis, and the places on them that stand
// for them. Of the method `line` those are the Gauss points of the intervals that touch, of `nodes` and `gap`
// the ends of the element, each for its half of it. See docs/theory/line-volume-contact.md.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hawser/kernels/contact_rates.hpp"
#include "hawser/terms/line_volume_pair.hpp"

namespace hawser {

// The axis in the frame of a body.
BezierAxis bezier_in(const RigidPose& pose, const AxisShape& shape);

class LineVolumeFinder {
 public:
  // volumes: those that pairs name; they outlive the finder.
  LineVolumeFinder(const ContactVolumes& volumes, model::ContactMethod method)
      : volumes_(volumes), method_(method) {}

  bool at_nodes() const { return method_ != model::ContactMethod::line; }
  bool by_gap() const { return method_ == model::ContactMethod::gap; }

  // Where the pair touches in a trial. Kept, since residual, tangent and commit ask for the same one after
  // the other.
  const ContactQuadrature& find(LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose) const;
  // Whether the axis is out of touch for sure; then nothing is found.
  bool clear(LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose) const;
  static bool is_clear(const LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose);
  // m: of the tube about the axis at the start of the step in which nothing is met.
  static double clearance_at_start(const LineVolumePair& pair);
  // The surface, or one facet group of it, from the point xi of a pair, which is at y.
  std::optional<SurfacePoint> query(const LineVolumePair& pair, int group, double xi, const Vec3& y,
                                    double within, bool either_side = false) const;
  // Whether there may be contact at this place of a pair.
  bool takes_part(const LineVolumePair& pair, double xi) const;
  GapSpring spring_at(int volume, const Vec3& y, double contact_distance) const;

  // Of a point that touches a facet group in the trial, at the start of the step: from what touched then, or
  // where it came from. rates: of that along the axis, on request.
  ContactStart start(const LineVolumePair& pair, int group, double xi, ContactRates* rates = nullptr) const;

  // What may be met of a volume while the element moves by `motion` [m] from the start of the step: whether
  // it is one facet group.
  bool one_facet_group(const LineVolumePair& pair, double motion) const;
  // The facet groups within `ahead` [m] of the distance of contact at the start of the step.
  void facet_groups_ahead(const LineVolumePair& pair, double ahead, FacetGroups& out) const;

 private:
  class Gap;

  void find_along(LineVolumePair& pair, int group, const AxisShape& shape, const RigidPose& pose) const;
  void find_at_nodes(LineVolumePair& pair, int group, const AxisShape& shape, const RigidPose& pose) const;
  // Where it touched at the start of the step; of one of several facet groups, which may be another each
  // trial, nothing.
  const std::vector<ContactInterval>& intervals_at_start(LineVolumePair& pair) const;
  std::vector<ContactInterval> locate(LineVolumePair& pair, int group, const AxisShape& shape,
                                      const RigidPose& pose) const;
  // What is known free of the volume at places of the axis goes for the tube about it.
  void update_clearance(const LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose,
                        std::vector<ClearancePoint>& places) const;
  void find_facet_groups(LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose) const;
  void assign_previous_points(LineVolumePair& pair) const;
  const Surface& surface(const LineVolumePair& pair) const { return volumes_.surface(pair.volume); }

  const ContactVolumes& volumes_;
  model::ContactMethod method_;
  mutable std::vector<ClearancePoint> places_;  // while a trial is looked at
};

}  // namespace hawser
