// Forces of a surface, with friction, on points, balls and the Gauss points of edges and bars fixed to a body
// that moves against it, summed into one force and one moment on that body with their exact tangent. Faces
// are cut into thousands of such points, so all is summed in the axes of the surface, and brought to the
// body's unknowns once.
#pragma once

#include <span>

#include "hawser/kernels/contact_rates.hpp"
#include "hawser/kernels/rigid_body.hpp"
#include "hawser/kernels/surface_contact_law.hpp"
#include "hawser/terms/body_contact.hpp"

namespace hawser {

class BodyContactPoints {
 public:
  // What a Gauss point of an edge has of an end of its panel that moves: the derivative of that end's place
  // xi by a motion of the body, and of the weight and place of the point by it, the latter times the weight.
  struct MovingEnd {
    Vec6 by_motion = Vec6::Zero();
    double weight = 0, place = 0;
  };

  // The body with the points, and the body that the surface belongs to; they outlive it. turned: rotation
  // vector of the former against the latter since the start of the step, rad, axes of the surface. step: its
  // length, s; 0: statics.
  BodyContactPoints(const BodyFrame& body, const BodyFrame& surface, const Vec3& turned, double step,
                    const AxisContactMode& mode);

  // The point in the frame of the surface, of one of the body.
  Vec3 place(const Vec3& y) const { return centre_ + turn_ * (y - body_.centre); }
  // Adds what acts on the body at z, a place in the frame of the surface, `weight` times the law. The body
  // has the given radius there. Returns the contact point; its normal force is zero where nothing touches.
  AxisContactPoint add(const ContactLaw& law, const ContactStart& start, const SurfacePoint& at,
                       const Vec3& z, double radius, double weight);
  // Adds to the tangent what the point that add() returned has of the ends of its panel. slope: m, of the
  // edge, per unit of xi, frame of the surface; rates: of `start` along the edge.
  void add_moving_ends(const ContactLaw& law, const ContactStart& start, const SurfacePoint& at,
                       const Vec3& z, double radius, const AxisContactPoint& point, const Vec3& slope,
                       ContactRates rates, std::span<const MovingEnd> ends);
  // The place xi of an end of a panel, at z, where the gap is constant, by a motion of the body.
  Vec6 end_by_motion(const Vec3& z, const Vec3& normal, const Vec3& slope) const;
  // Adds the sums to the residual f[6] of the body's position and rotation, K and C [6x6], row-major; null:
  // not asked for.
  void to_body(double* f, double* K, double* C) const;

  bool active() const { return active_; }
  double potential() const { return potential_; }          // J
  double damping_power() const { return damping_power_; }  // W
  double depth() const { return depth_; }                  // m, largest penetration

 private:
  ContactTrial trial(const SurfacePoint& at, const Vec3& z, double radius) const;

  const BodyFrame& body_;
  const AxisContactMode mode_;
  Mat3 turn_;     // body axes to those of the surface
  Mat3 to_axes_;  // space axes to those of the surface
  Vec3 centre_;   // m, of the body, frame of the surface
  // In axes of the surface: velocity of the body's centre and rate of turn against the surface, rate of turn
  // of the body and of the surface.
  Vec3 velocity_, turning_, own_turning_, surface_turning_;
  Vec3 turned_;
  double step_;
  Mat3 turned_by_turn_;  // its derivative by a small rotation of the body
  Vec3 force_ = Vec3::Zero(), moment_ = Vec3::Zero();
  Mat6 K_ = Mat6::Zero(), C_ = Mat6::Zero();  // by motions in axes of the surface
  double potential_ = 0, damping_power_ = 0, depth_ = 0;
  bool active_ = false;
};

}  // namespace hawser
