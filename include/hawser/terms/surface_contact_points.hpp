// Plain data of contact between an axis and a surface: the quadrature points found in a trial, and the
// contact points of an accepted step. In the frame of the surface's body; of the bed in space axes.
#pragma once

#include <vector>

#include "hawser/geometry/surface.hpp"
#include "hawser/kernels/axis_shape.hpp"
#include "hawser/kernels/contact_intervals.hpp"
#include "hawser/kernels/contact_point.hpp"
#include "hawser/kernels/motion.hpp"
#include "hawser/kernels/surface_contact_law.hpp"

namespace hawser {

// Contact point with its elastic slip.
struct SurfaceContactPoint : ContactPoint {
  Vec3 slip = Vec3::Zero();  // m
  double peak = 0;           // N or N/m, largest normal force since the point touched; 0 in statics

  SurfaceContactPoint() = default;
  // moves: not in statics, where loads have no order in time and springs of friction follow the normal force.
  SurfaceContactPoint(const ContactForce& c, const Vec3& n, bool moves)
      : slip(c.slip), peak(moves ? c.peak : 0) {
    normal = n;
    force = c.force;
    friction = c.friction;
    normal_force = c.along_normal.force;
    damping_force = c.along_normal.force - c.along_normal.elastic;
    potential = c.along_normal.potential;
  }

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each, const char* force, const char* energy) {
    each("slip", "m", self.slip);
    each("peak of the normal force", force, self.peak);
    ContactPoint::quantities(self, each, force, energy);
  }
};

// Contact point on an axis, kept while it is in contact.
struct AxisContactPoint : SurfaceContactPoint {
  using SurfaceContactPoint::SurfaceContactPoint;
  double xi = 0, from = 0, to = 0;  // position, and limits of the panel, all of which is in contact
  int group = 0;                    // facet group, if the surface has several

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

// Axis and surface pose for which stored results are valid.
struct AxisBeside {
  bool known = false;
  AxisShape shape = no_axis();
  RigidPose pose;

  // True if the positions are equal, regardless of velocities.
  bool same_configuration(const AxisShape& s, const RigidPose& p) const {
    return known && shape.same_axis(s) && pose.position == p.position &&
           pose.rotation.coeffs() == p.rotation.coeffs();
  }
  bool same_motion(const AxisShape& s, const RigidPose& p) const {
    return same_configuration(s, p) && shape.same_motion(s) && pose.velocity == p.velocity &&
           pose.angular_velocity == p.angular_velocity;
  }
};

// Interval of an axis in contact, or a part of one; group: facet group, if the surface has several.
struct ContactPanel : ContactInterval {
  int group = 0;
};

// Quadrature point of a panel, and the surface there.
struct QuadraturePoint {
  double xi = 0, weight = 0;  // -, m
  PanelPoint in_panel;
  size_t panel = 0;
  SurfacePoint surface;
};

// Contact of an axis: panels and their quadrature points, sorted by panel.
struct ContactQuadrature {
  AxisBeside configuration;
  std::vector<ContactPanel> panels;
  std::vector<InactiveInterval> filled;  // parts of panels without contact
  std::vector<QuadraturePoint> quadrature;

  void clear() {
    configuration.known = false;
    panels.clear();
    filled.clear();
    quadrature.clear();
  }
  // Adds panels and their Gauss points for an axis of this length [m]. query(xi): surface point, or nullopt
  // out of contact.
  template <class Query>
  void add_panels(const std::vector<ContactInterval>& intervals, int group, double length,
                  const Query& query) {
    for (const ContactInterval& s : intervals) {
      for (size_t q = 0; q < kContactPoints; ++q) {
        const PanelPoint at = panel_point(q);
        const double xi = s.from + (s.to - s.from) * at.place;
        if (const auto p = query(xi))
          quadrature.push_back({xi, length * (s.to - s.from) * at.weight, at, panels.size(), *p});
      }
      panels.push_back({s, group});
    }
  }
};

}  // namespace hawser
