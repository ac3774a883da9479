// Finds where the axis of an element touches a volume: panels of the axis and quadrature points on them. With
// the method `line` these are the Gauss points of the intervals in contact. With `nodes` and `gap` they are
// the ends of the element, each with the weight of half the element. See docs/theory/line-volume-contact.md.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hawser/kernels/contact_rates.hpp"
#include "hawser/terms/line_volume_pair.hpp"

namespace hawser {

// Bézier axis in the frame of a body.
BezierAxis bezier_in(const RigidPose& pose, const AxisShape& shape);

class LineVolumeFinder {
 public:
  // volumes: those of the pairs; must outlive the finder.
  LineVolumeFinder(const ContactVolumes& volumes, model::ContactMethod method)
      : volumes_(volumes), method_(method) {}

  bool at_nodes() const { return method_ != model::ContactMethod::line; }
  bool by_gap() const { return method_ == model::ContactMethod::gap; }

  // Contact of the pair in a trial. The result is stored, because residual, tangent and commit() need the
  // same one.
  const ContactQuadrature& find(LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose) const;
  // The same for a pair that is not certainly_clear(), which find() checks first.
  const ContactQuadrature& search(LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose) const;
  // True if the axis certainly does not touch. skip_if_clear() then also deletes the stored contact of the
  // pair.
  bool skip_if_clear(LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose) const;
  static bool certainly_clear(const LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose);
  // Radius [m] of the tube about the axis at the start of the step that is free of contact.
  static double clearance_at_start(const LineVolumePair& pair);
  // Queries the surface, or one facet group of it, for the point xi of a pair, which is at y.
  std::optional<SurfacePoint> query(LineVolumePair& pair, int group, double xi, const Vec3& y, double within,
                                    bool either_side = false) const;
  // True if contact is possible at this point of a pair.
  bool takes_part(const LineVolumePair& pair, double xi) const;
  GapSpring spring_at(int volume, const Vec3& y, double contact_distance) const;

  // State at the start of the step of a point that touches a facet group in the trial: slip from the contact
  // points at that time, or the gap if the point did not touch. rates: derivatives along the axis, on
  // request.
  ContactStart start(LineVolumePair& pair, int group, double xi, ContactRates* rates = nullptr) const;

  // True if only one facet group of the volume can be reached while the element moves by `motion` [m] from
  // the start of the step.
  bool one_facet_group(const LineVolumePair& pair, double motion) const;
  // Facet groups within the contact distance plus `ahead` [m] at the start of the step.
  void facet_groups_ahead(const LineVolumePair& pair, double ahead, FacetGroups& out) const;

 private:
  class Gap;

  void find_along(LineVolumePair& pair, int group, const AxisShape& shape, const RigidPose& pose) const;
  void find_at_nodes(LineVolumePair& pair, int group, const AxisShape& shape, const RigidPose& pose) const;
  // Intervals in contact at the start of the step; empty if there are several facet groups, which may differ
  // between trials.
  const std::vector<ContactInterval>& intervals_at_start(LineVolumePair& pair) const;
  std::vector<ContactInterval> locate(LineVolumePair& pair, int group, const AxisShape& shape,
                                      const RigidPose& pose) const;
  // Updates the contact-free tube about the axis from distances at points on it.
  void update_clearance(LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose,
                        std::vector<ClearancePoint>& places) const;
  void find_facet_groups(LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose) const;
  void assign_previous_points(LineVolumePair& pair) const;
  const Surface& surface(const LineVolumePair& pair) const { return volumes_.surface(pair.volume); }

  const ContactVolumes& volumes_;
  model::ContactMethod method_;
  mutable std::vector<ClearancePoint> places_;  // workspace of a search
};

}  // namespace hawser
