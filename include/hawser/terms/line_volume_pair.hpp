// Pair of a line element and a volume that it may touch: contact in a trial, data stored at an accepted step,
// and known distances. Plain data, all in the frame of the volume's body.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hawser/kernels/clearance_tube.hpp"
#include "hawser/terms/contact_volumes.hpp"
#include "hawser/terms/surface_contact_points.hpp"

namespace hawser {

// Gap spring at an end of an element. It acts along the normal at the surface point that was nearest at the
// start, wherever the end moves. See docs/theory/contact-models.md.
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

// Facet groups near an axis (facet_groups.hpp) if the surface may have several, and the contact points of the
// last step on each of them. `previous` empty: all points belong to the only group.
struct NearGroups {
  FacetGroups facet_groups;
  std::vector<std::vector<AxisContactPoint>> previous;
};

struct LineVolumePair {
  int element = 0, volume = 0;
  double length = 0, radius = 0;  // m, of the element
  double contact_distance = 0;    // m, distance below which there is a force: radius + smoothing
  ContactShare part;              // part of the axis that takes part in contact with this volume
  std::array<bool, 2> held{};     // whether each end is held
  int levels = 1;                 // halvings in the search for intervals, kernels/contact_intervals.hpp
  // Laws per length for each half of the element; they may differ with contact at nodes.
  std::array<ContactLaw, 2> laws;
  AxisBeside start;                      // axis and pose at the start of the step
  std::vector<AxisContactPoint> points;  // contact points of the last accepted state, by facet group and xi
  std::array<GapSpring, 2> springs;      // at the ends of the element
  bool several = false;                  // several facet groups may be met in this step
  // Intervals in contact at the start of the step, found with additional halvings; nullopt: not searched yet.
  std::optional<std::vector<ContactInterval>> before;
  // Data kept between steps that save time and do not change results: the tube about the axis without points
  // of the volume within `contact_distance`, and the nearest triangles of the last query and of the queries
  // ahead.
  mutable ClearanceTube clearance;
  int hint = -1;
  mutable std::array<int, 3> ahead{-1, -1, -1};
  // Facets near each queried point of the axis, in the order of the queries of a trial; number of queries in
  // this trial.
  mutable std::vector<NearFacets> near_facets;
  mutable size_t asked = 0;
  size_t asked_by_search = 0;  // number of queries in the search for `found`
  // For the trial.
  ContactQuadrature found;
  NearGroups near;  // facet groups for the axis of `found`
  // Contact points from an evaluation of the law without derivatives, with or without velocities, at the
  // motion `found.configuration`. commit() reuses them for the same state.
  enum class Evaluation { none, at_rest, in_motion };
  Evaluation evaluation = Evaluation::none;
  std::vector<AxisContactPoint> evaluated;

  static Evaluation evaluation_of(bool moves) { return moves ? Evaluation::in_motion : Evaluation::at_rest; }
  const ContactLaw& law(double xi) const { return laws[xi > 0.5]; }
  double smoothing() const { return laws[0].normal.smoothing; }
  bool in_contact(const SurfacePoint& p) const { return p.distance <= contact_distance; }
  int facet_groups() const {
    return near.facet_groups.several() ? static_cast<int>(near.facet_groups.of.size()) : 1;
  }
  // Facet group w; null: the whole surface.
  const FacetGroup* group(int w) const {
    return near.facet_groups.several() ? &near.facet_groups.of[w] : nullptr;
  }
  const std::vector<AxisContactPoint>& previous(int w) const {
    return near.previous.empty() ? points : near.previous[w];
  }
};

}  // namespace hawser
