// Contact of an axis with a surface: the law at each point where they touch, summed into forces on the
// control points of the axis, with their exact tangent. The axis is an element of a line, an edge of a body
// or one of its corners. See docs/theory/contact.md.
#pragma once

#include <optional>
#include <vector>

#include "hawser/kernels/axis_roll.hpp"
#include "hawser/kernels/contact_rates.hpp"
#include "hawser/math/function_ref.hpp"
#include "hawser/terms/surface_contact_points.hpp"

namespace hawser {

// What is asked of forces on an axis.
struct AxisContactMode {
  bool moves = false;    // velocities count
  bool tangent = false;  // with derivatives
  bool convex = false;   // these without negative stiffness
};

class AxisContact {
 public:
  // What its finder knows of the axis and the surface.
  struct Pair {
    // The law of a panel, per unit of the weights.
    FunctionRef<ContactLaw(const ContactPanel&)> law;
    // The surface from an end of a panel, some way beyond touch; asked for tangents only.
    FunctionRef<std::optional<SurfacePoint>(const ContactPanel&, double xi)> query;
    // What friction starts from at a place of a panel, and how that changes along the axis on request; asked
    // for laws with friction only.
    FunctionRef<ContactStart(const ContactPanel&, double xi, ContactRates* rates)> start;
  };
  // How far a beam's ends have rolled about its axis since the start of the step, relative to the body, where
  // friction acts at its surface.
  struct Rolls {
    std::array<AxisRoll, 2> ends;
    double angle(double xi) const { return (1 - xi) * ends[0].angle + xi * ends[1].angle; }
  };

  // The axis, and the pose of the surface's body in the trial, outlive it. radius, length: m, of the line; of
  // the axis, of which weights are parts.
  AxisContact(const AxisShape& shape, const RigidPose& pose, double radius, double length,
              const AxisContactMode& mode, std::optional<Rolls> rolls = {});

  // Adds what acts at the places found; points: the contact points go there, if it is given.
  void add(const ContactQuadrature& found, const Pair& pair, std::vector<AxisContactPoint>* points = nullptr);
  // Adds the forces to blocks the positions are attached to: f[3n], K and C (3n)x(3n), row-major; K and C may
  // be null together.
  void to_blocks(const Stencil& stencil, double* f, double* K, double* C);

 private:
  struct Moving;
  struct Sample;
  void add_panel(const ContactQuadrature& found, size_t panel, const Pair& pair,
                 std::vector<AxisContactPoint>* points);
  std::array<Moving, 2> moving_ends(const ContactPanel& s, const Pair& pair) const;
  Sample sample(const QuadraturePoint& q, const ContactPanel& s, const ContactLaw& law, const Pair& pair,
                bool ends_move) const;
  void add_sample(const Sample& p);
  void add_rolling(const Sample& p, const Mat3& by_point);
  void add_to_moving_ends(const ContactLaw& law, Sample& p, const QuadraturePoint& q, double span,
                          std::array<Moving, 2>& ends) const;

  const AxisShape& shape_;
  const RigidPose& pose_;
  double radius_, length_;  // m
  AxisContactMode mode_;
  std::optional<Rolls> rolls_;
  size_t n_;
  Mat3 R_;  // of the pose
  Quat R_inverse_;
  Mat3 spin_;                       // of its angular velocity, body frame
  std::array<Vec3, 2> about_;       // the axes that the ends roll about, space axes
  std::array<double, 2> torque_{};  // N m, of the rolls
  AttachedForces g_;
};

}  // namespace hawser
