// An element of a line and a volume that it may touch: where they touch in a trial, what of that an accepted
// step leaves, and what is known of how far apart they are. Plain data, all in the frame of the volume's
// body.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/axis_shape.hpp"
#include "hawser/kernels/contact_stretches.hpp"
#include "hawser/kernels/free_tube.hpp"
#include "hawser/kernels/motion.hpp"
#include "hawser/terms/contact_history.hpp"
#include "hawser/terms/contact_volumes.hpp"

namespace hawser {

// A place of the axis that touches, forces per length; kept while it does.
struct ContactPoint : ContactHistory {
  using ContactHistory::ContactHistory;
  double xi = 0, from = 0, to = 0;  // where; its panel: all of it touches
  double weight = 0, gap = 0;       // m

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("place", "", self.xi), each("from", "", self.from), each("to", "", self.to);
    each("weight", "m", self.weight), each("gap", "m", self.gap);
    ContactHistory::quantities(self, each, "N/m", "J/m");
  }
};

// A gap spring at an end of an element: where the surface was nearest at the start, and its normal, wherever
// the end goes. See docs/theory/contact-models.md.
struct GapSpring {
  bool paired = false;
  Vec3 anchor = Vec3::Zero(), direction = Vec3::UnitZ();  // m, -

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("paired", "", self.paired), each("anchor", "m", self.anchor);
    each("direction", "", self.direction);
  }
};

inline AxisShape no_axis() {
  AxisEnds e;
  e.beam = false;
  e.x1 = e.x2 = Vec3::Zero();
  return AxisShape(e);
}

// An axis beside a body, as they were when something was found out about them.
struct AxisBeside {
  bool known = false;
  AxisShape shape = no_axis();
  RigidPose pose;

  // The same places, whatever their velocities.
  bool same_places(const AxisShape& s, const RigidPose& p) const {
    return known && shape.same_axis(s) && pose.position == p.position &&
           pose.rotation.coeffs() == p.rotation.coeffs();
  }
  bool same_motion(const AxisShape& s, const RigidPose& p) const {
    return same_places(s, p) && shape.same_motion(s) && pose.velocity == p.velocity &&
           pose.angular_velocity == p.angular_velocity;
  }
};

// A place of a panel, and the surface there.
struct ContactPlace {
  double xi = 0, weight = 0;   // -, m
  double along = 0, part = 1;  // of the panel: where on it; the weight of the rule
  size_t panel = 0;
  SurfacePoint at;
};

// Where an axis touches: its panels and their places, by panel.
struct ContactPlaces {
  AxisBeside of;
  std::vector<ContactStretch> panels;
  std::vector<ContactHollow> filled;  // parts of panels that do not touch
  std::vector<ContactPlace> places;
  void clear() { of.known = false, panels.clear(), filled.clear(), places.clear(); }
};

// Where a surface may have several walls (surface_walls.hpp): what of them is near an axis, and which of the
// points of before lay on each: on each wall, or on the one there is; empty: the pair's own.
struct SeenWalls {
  SurfaceWalls walls;
  std::vector<std::vector<ContactPoint>> past;
};

// Of an element and a volume, shared by its pairs, one a wall; what was seen of the last axis is kept.
struct ElementWalls {
  std::vector<std::vector<ContactPoint>> committed;  // of each pair
  AxisBeside of;
  std::shared_ptr<const SeenWalls> seen;
  FreeTube free;  // as of the pair
  int hint = -1;
};

// An element and a volume; or one of its walls, of which there may be as many as there are pairs.
struct LineVolumePair {
  int element = 0, volume = 0, slot = 0;
  double length = 0, radius = 0;     // m, of the element
  double touch = 0;                  // m, distance below which there is a force: radius + smoothing
  ContactShare part;                 // of the axis: the rest has no contact with this volume
  std::array<bool, 2> held{};        // ends
  int levels = 1;                    // of the search, kernels/contact_stretches.hpp
  std::array<ContactLaw, 2> laws;    // per length, of its halves: at nodes they may differ
  AxisBeside start;                  // at the start of the step
  std::vector<ContactPoint> points;  // that touch, of the last accepted state; by xi
  std::array<GapSpring, 2> springs;  // of its ends
  // Where the axis touched at the start of the step, looked for closely; none: not looked for yet.
  std::optional<std::vector<ContactStretch>> before;
  // Kept from step to step, changes the time and never the answer: where nothing of the volume is within
  // `touch`; nearest triangles of the last query and of those that look ahead; whether there is one wall only
  // about a chord, where that was asked.
  mutable FreeTube free;
  int hint = -1;
  mutable std::array<int, 3> ahead{-1, -1, -1};
  std::array<Vec3, 2> one_chord{Vec3::Zero(), Vec3::Zero()};
  double one_reach = -1;  // m
  bool one = false;
  std::shared_ptr<ElementWalls> walls;  // none: there is one wall in this step
  // Of the trial.
  ContactPlaces found;
  std::shared_ptr<const SeenWalls> seen;  // of the axis of `found`
  // Contact points by the last evaluation of the law without derivatives, and the state it was of: commit of
  // that state takes them.
  std::vector<ContactPoint> evaluated;
  AxisBeside evaluated_at;
  bool evaluated_in_motion = false;  // velocities counted

  const ContactLaw& law(double xi) const { return laws[xi > 0.5]; }
  double smoothing() const { return laws[0].normal.smoothing; }
  bool sees(const SurfacePoint& p) const { return p.distance <= touch; }
  // The wall it is about; none: all of the surface, and of a further pair nothing.
  const SurfaceWall* wall() const {
    const size_t k = static_cast<size_t>(slot);
    return seen && seen->walls.several() && k < seen->walls.of.size() ? &seen->walls.of[k] : nullptr;
  }
  FreeTube& room() const { return walls ? walls->free : free; }
  bool idle() const { return slot > 0 && !wall(); }
  const std::vector<ContactPoint>& past() const {
    return seen && !seen->past.empty() ? seen->past[static_cast<size_t>(slot)] : points;
  }
};

}  // namespace hawser
