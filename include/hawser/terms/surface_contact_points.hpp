// Contact of an axis with a surface as plain data: the places that a finder finds in a trial, and the points
// that an accepted step leaves. All in the frame of the surface's body.
#pragma once

#include <vector>

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/axis_shape.hpp"
#include "hawser/kernels/contact_intervals.hpp"
#include "hawser/kernels/contact_point.hpp"
#include "hawser/kernels/motion.hpp"
#include "hawser/kernels/surface_contact_law.hpp"

namespace hawser {

// At a surface, with the elastic slip that is left there.
struct SurfaceContactPoint : ContactPoint {
  Vec3 slip = Vec3::Zero();  // m

  SurfaceContactPoint() = default;
  SurfaceContactPoint(const PointContact& c, const Vec3& n) : slip(c.slip) {
    normal = n;
    force = c.force;
    friction = c.friction;
    normal_force = c.normal.force;
    damping_force = c.normal.force - c.normal.elastic;
    potential = c.normal.potential;
  }

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each, const char* force, const char* energy) {
    each("slip", "m", self.slip);
    ContactPoint::quantities(self, each, force, energy);
  }
};

// A place of an axis that touches, kept while it does.
struct AxisContactPoint : SurfaceContactPoint {
  using SurfaceContactPoint::SurfaceContactPoint;
  double xi = 0, from = 0, to = 0;  // where; its panel: all of it touches
  int group = 0;                    // of the surface, where it has several

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("place", "", self.xi);
    each("from", "", self.from);
    each("to", "", self.to);
    each("facet group", "", self.group);
    each("weight", "m", self.weight);
    each("gap", "m", self.gap);
    SurfaceContactPoint::quantities(self, each, "N/m", "J/m");
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
  bool same_configuration(const AxisShape& s, const RigidPose& p) const {
    return known && shape.same_axis(s) && pose.position == p.position &&
           pose.rotation.coeffs() == p.rotation.coeffs();
  }
  bool same_motion(const AxisShape& s, const RigidPose& p) const {
    return same_configuration(s, p) && shape.same_motion(s) && pose.velocity == p.velocity &&
           pose.angular_velocity == p.angular_velocity;
  }
};

// An interval of an axis that touches, or a part of one; of which facet group of the surface, where it has
// several.
struct ContactPanel : ContactInterval {
  int group = 0;
};

// A place of a panel, and the surface there.
struct QuadraturePoint {
  double xi = 0, weight = 0;   // -, m
  double along = 0, part = 1;  // of the panel: where on it; the weight of the rule
  size_t panel = 0;
  SurfacePoint at;
};

// Where an axis touches: its panels and their places, by panel.
struct ContactQuadrature {
  AxisBeside of;
  std::vector<ContactPanel> panels;
  std::vector<InactiveInterval> filled;  // parts of panels that do not touch
  std::vector<QuadraturePoint> quadrature;

  void clear() {
    of.known = false;
    panels.clear();
    filled.clear();
    quadrature.clear();
  }
  // Adds panels, and their Gauss points, to an axis of that length [m]. query(xi): the surface there, or
  // nothing where it is out of touch.
  template <class Query>
  void add_panels(const std::vector<ContactInterval>& intervals, int group, double length,
                  const Query& query) {
    for (const ContactInterval& s : intervals) {
      for (size_t q = 0; q < ContactRule::kPoints; ++q) {
        const double along = ContactRule::abscissae()[q], part = ContactRule::weight()[q];
        const double xi = s.from + (s.to - s.from) * along;
        if (const auto p = query(xi))
          quadrature.push_back({xi, length * (s.to - s.from) * part, along, part, panels.size(), *p});
      }
      panels.push_back({s, group});
    }
  }
};

}  // namespace hawser
