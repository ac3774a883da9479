// Pair of a line element and a volume that it may touch: its settings, the start of the step, contact in a
// trial, and a cache of known distances. Plain data, all in the frame of the volume's body.
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

// At the start of a step.
struct PairStart {
  AxisShape shape = no_axis();
  RigidPose pose;
  std::vector<AxisContactPoint> points;  // contact points of the last accepted state, by facet group and xi
  std::array<GapSpring, 2> springs;      // at the ends of the element
  bool several_groups = false;           // several facet groups may be met in this step
  // Intervals in contact, found with additional halvings; nullopt: not searched yet.
  std::optional<std::vector<ContactInterval>> intervals;
};

// Contact in a trial.
struct PairTrial {
  ContactQuadrature contact;
  NearGroups near;  // facet groups for the axis of `contact`
  // Contact points from an evaluation of the law without derivatives, with or without velocities, at the
  // motion `contact.configuration`. commit() reuses them for the same state.
  enum class Evaluation { none, at_rest, in_motion };
  Evaluation evaluation = Evaluation::none;
  std::vector<AxisContactPoint> evaluated;
};

// Data kept between trials and steps that save time and do not change results: the tube about the axis
// without points of the volume within the contact distance, and the nearest triangles of the last query and
// of the queries ahead.
struct PairCache {
  ClearanceTube clearance;
  int hint = -1;
  std::array<int, 3> ahead{-1, -1, -1};
  NearFacetLists near_facets;
};

struct LineVolumePair {
  using Evaluation = PairTrial::Evaluation;

  int element = 0, volume = 0;
  double length = 0, radius = 0;  // m, of the element
  double contact_distance = 0;    // m, distance below which there is a force: radius + smoothing
  ActiveInterval part;            // part of the axis that takes part in contact with this volume
  std::array<bool, 2> held{};     // whether each end is held
  int levels = 1;                 // halvings in the search for intervals, kernels/contact_intervals.hpp
  // Laws per length for each half of the element; they may differ with contact at nodes.
  std::array<ContactLaw, 2> laws;

  PairStart start;
  PairTrial trial;
  PairCache cache;

  static Evaluation evaluation_of(bool moves) { return moves ? Evaluation::in_motion : Evaluation::at_rest; }
  const ContactLaw& law(double xi) const { return laws[xi > 0.5]; }
  double smoothing() const { return laws[0].normal.smoothing; }
  bool in_contact(const SurfacePoint& p) const { return p.distance <= contact_distance; }
  int facet_groups() const {
    return trial.near.facet_groups.several() ? static_cast<int>(trial.near.facet_groups.list.size()) : 1;
  }
  // Facet group w; null: the whole surface.
  const FacetGroup* group(int w) const {
    return trial.near.facet_groups.several() ? &trial.near.facet_groups.list[w] : nullptr;
  }
  const std::vector<AxisContactPoint>& previous(int w) const {
    return trial.near.previous.empty() ? start.points : trial.near.previous[w];
  }
};

}  // namespace hawser
