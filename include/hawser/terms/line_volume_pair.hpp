// An element of a line and a volume that it may touch: where they touch in a trial, what of that an accepted
// step leaves, and what is known of how far apart they are. Plain data, all in the frame of the volume's
// body.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hawser/kernels/clearance_tube.hpp"
#include "hawser/terms/contact_volumes.hpp"
#include "hawser/terms/surface_contact_points.hpp"

namespace hawser {

// A gap spring at an end of an element: where the surface was nearest at the start, and its normal, wherever
// the end goes. See docs/theory/contact-models.md.
struct GapSpring {
  bool paired = false;
  Vec3 anchor = Vec3::Zero(), direction = Vec3::UnitZ();  // m, -

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("paired", "", self.paired);
    each("anchor", "m", self.anchor);
    each("direction", "", self.direction);
  }
};

// Where a surface may have several facet groups (facet_groups.hpp): what of them is near an axis, and which
// of the points of before lay on each: on each facet group, or on the one there is; empty: all that there
// are.
struct NearGroups {
  FacetGroups facet_groups;
  std::vector<std::vector<AxisContactPoint>> previous;
};

struct LineVolumePair {
  int element = 0, volume = 0;
  double length = 0, radius = 0;         // m, of the element
  double contact_distance = 0;           // m, distance below which there is a force: radius + smoothing
  ContactShare part;                     // of the axis: the rest has no contact with this volume
  std::array<bool, 2> held{};            // ends
  int levels = 1;                        // of the search, kernels/contact_intervals.hpp
  std::array<ContactLaw, 2> laws;        // per length, of its halves: at nodes they may differ
  AxisBeside start;                      // at the start of the step
  std::vector<AxisContactPoint> points;  // that touch, of the last accepted state; by facet group and xi
  std::array<GapSpring, 2> springs;      // of its ends
  bool several = false;                  // facet groups may be met in this step
  // Where the axis touched at the start of the step, looked for closely; none: not looked for yet.
  std::optional<std::vector<ContactInterval>> before;
  // Kept from step to step, changes the time and never the answer: where nothing of the volume is within
  // `contact_distance`; nearest triangles of the last query and of those that look ahead.
  mutable ClearanceTube clearance;
  int hint = -1;
  mutable std::array<int, 3> ahead{-1, -1, -1};
  // The facets near each place of the axis that is asked about, in the order in which a trial asks, and the
  // number of places that this trial has asked about.
  mutable std::vector<NearFacets> near_facets;
  mutable size_t asked = 0;
  size_t asked_by_search = 0;  // of these: those of the search for `found`
  // Of the trial.
  ContactQuadrature found;
  NearGroups near;  // of the axis of `found`
  // Contact points by the last evaluation of the law without derivatives, and the state it was of: commit of
  // that state takes them.
  std::vector<AxisContactPoint> evaluated;
  AxisBeside evaluated_at;
  bool evaluated_in_motion = false;  // velocities counted

  const ContactLaw& law(double xi) const { return laws[xi > 0.5]; }
  double smoothing() const { return laws[0].normal.smoothing; }
  bool in_contact(const SurfacePoint& p) const { return p.distance <= contact_distance; }
  int facet_groups() const {
    return near.facet_groups.several() ? static_cast<int>(near.facet_groups.of.size()) : 1;
  }
  // Null: all of the surface.
  const FacetGroup* group(int w) const {
    return near.facet_groups.several() ? &near.facet_groups.of[w] : nullptr;
  }
  const std::vector<AxisContactPoint>& previous(int w) const {
    return near.previous.empty() ? points : near.previous[w];
  }
};

}  // namespace hawser
