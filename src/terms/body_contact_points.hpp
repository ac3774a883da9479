// Contact forces, with friction, of a surface on points, balls and Gauss points fixed to a moving body,
// summed into one force and moment on that body with their exact tangent. Faces consist of thousands of
// points, so the sums are formed in axes of the surface and transferred to the body's unknowns once.
#pragma once

#include <span>

#include "hawser/kernels/contact_rates.hpp"
#include "hawser/kernels/rigid_body.hpp"
#include "hawser/kernels/surface_contact_law.hpp"
#include "hawser/terms/body_contact.hpp"

namespace hawser {

class BodyContactPoints {
 public:
  // Contribution of a moving end of a panel to a Gauss point: derivative of the end's position xi by a motion
  // of the body, and derivatives by xi of the point's weight, and of its position times the weight.
  struct MovingEnd {
    Vec6 by_motion = Vec6::Zero();
    double weight = 0, place = 0;
  };

  // body: the body with the points; surface: the body of the surface; both must outlive this object. turned:
  // rotation vector of the former relative to the latter since the start of the step, rad, axes of the
  // surface. step: its length, s; 0: statics.
  BodyContactPoints(const BodyFrame& body, const BodyFrame& surface, const Vec3& turned, double step,
                    const AxisContactMode& mode);

  // Converts a point of the body to the frame of the surface.
  Vec3 place(const Vec3& y) const { return centre_ + turn_ * (y - body_.centre); }
  // Adds `weight` times the contact force at z, frame of the surface, where the body has the given radius.
  // Returns the contact point, with zero normal force if there is no contact.
  AxisContactPoint add(const ContactLaw& law, const ContactStart& start, const SurfacePoint& at,
                       const Vec3& z, double radius, double weight);
  // Adds the contribution of moving panel ends to the tangent for the point that add() returned. slope: of
  // the edge, m per unit of xi, frame of the surface; rates: of `start` along the edge.
  void add_moving_ends(const ContactLaw& law, const ContactStart& start, const SurfacePoint& at,
                       const Vec3& z, double radius, const AxisContactPoint& point, const Vec3& slope,
                       ContactRates rates, std::span<const MovingEnd> ends);
  // Derivative of the position xi of a panel end at z, where the gap is constant, by a motion of the body.
  Vec6 end_by_motion(const Vec3& z, const Vec3& normal, const Vec3& slope) const;
  // Adds the sums to the residual f[6] of the body's position and rotation, and to K and C [6x6] if not
  // null.
  void to_body(BlockVector& f, BlockMatrix* K, BlockMatrix* C) const;

  bool active() const { return active_; }
  double potential() const { return potential_; }  // J
  double depth() const { return depth_; }          // m, largest penetration
  const TouchingPoints& touching() const { return touching_; }

 private:
  ContactTrial trial(const SurfacePoint& at, const Vec3& z, double radius) const;

  const BodyFrame& body_;
  const AxisContactMode mode_;
  Mat3 turn_;            // body axes to surface axes
  Mat3 to_axes_;         // space axes to surface axes
  Vec3 centre_;          // m, centre of the body, frame of the surface
  Vec3 surface_centre_;  // m, centre of the body of the surface, in its frame
  // In axes of the surface: velocity of the body's centre and angular velocity relative to the surface,
  // angular velocity of the body.
  Vec3 velocity_, turning_, body_turning_;
  Mat3 surface_velocity_slope_;  // 1/s, of minus the velocity of the surface by position
  Vec3 turned_;
  double step_;
  Mat3 turned_by_turn_;  // derivative of turned_ by a small rotation of the body
  Vec3 force_ = Vec3::Zero(), moment_ = Vec3::Zero();
  Mat6 K_ = Mat6::Zero(), C_ = Mat6::Zero();  // by motions in axes of the surface
  double potential_ = 0, depth_ = 0;
  TouchingPoints touching_;
  bool active_ = false;
};

}  // namespace hawser
