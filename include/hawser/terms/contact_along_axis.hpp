// Contact of an axis with a surface: sums the contact law over the points in contact into forces on the
// control points of the axis, with their exact tangent. The axis is an element of a line. See
// docs/theory/contact.md.
#pragma once

#include <optional>
#include <vector>

#include "hawser/kernels/axis_roll.hpp"
#include "hawser/kernels/contact_rates.hpp"
#include "hawser/math/function_ref.hpp"
#include "hawser/terms/surface_contact_points.hpp"

namespace hawser {

// Options of the evaluation of forces on an axis.
struct AxisContactMode {
  bool moves = false;    // include velocities
  bool tangent = false;  // include derivatives
  bool convex = false;   // derivatives without negative stiffness
};

class AxisContact {
 public:
  // Data of the axis and the surface that the finder of the contact provides.
  struct PanelFunctions {
    // The law of a panel, per unit of the weights.
    FunctionRef<ContactLaw(const ContactPanel&)> law;
    // Surface point at an end of a panel, also slightly beyond contact; called for tangents only.
    FunctionRef<std::optional<SurfacePoint>(const ContactPanel&, double xi)> query;
    // State of friction at the start of the step at a point of a panel, and on request its derivatives along
    // the axis; called for laws with friction only.
    FunctionRef<ContactStart(const ContactPanel&, double xi, ContactRates* rates)> start;
  };
  // Roll of a beam's ends about its axis since the start of the step, relative to the body, for friction that
  // acts at the beam's surface.
  struct Rolls {
    std::array<AxisRoll, 2> ends;
    double angle(double xi) const { return (1 - xi) * ends[0].angle + xi * ends[1].angle; }
  };

  // The axis, and the pose of the surface's body in the trial, must outlive this object. radius: of the line,
  // m. length: of the axis, m, to which the quadrature weights refer.
  AxisContact(const AxisShape& shape, const RigidPose& pose, double radius, double length,
              const AxisContactMode& mode, std::optional<Rolls> rolls = {});

  // Adds minus the contact forces on the line (its residual) at the quadrature points of `contact`. `points`,
  // if given, receives the contact points.
  void add(const ContactQuadrature& contact, const PanelFunctions& functions,
           std::vector<AxisContactPoint>* points = nullptr);
  // Adds the residual to the blocks to which the positions are attached: f (3n), K and C (3n x 3n), which
  // may both be null.
  void to_blocks(const Stencil& stencil, BlockVector& f, BlockMatrix* K, BlockMatrix* C);

 private:
  struct Moving;
  struct Sample;
  void add_panel(const ContactQuadrature& contact, size_t panel, const PanelFunctions& functions,
                 std::vector<AxisContactPoint>* points);
  std::array<Moving, 2> moving_ends(const ContactPanel& s, const PanelFunctions& functions) const;
  Sample sample(const QuadraturePoint& q, const ContactPanel& s, const ContactLaw& law,
                const PanelFunctions& functions, bool ends_move) const;
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
  Mat3 spin_;                       // hat of the body's angular velocity, body frame
  std::array<Vec3, 2> about_;       // axes about which the ends roll, space axes
  std::array<double, 2> torque_{};  // N m, on the rolls of the ends
  AttachedForces g_;
};

}  // namespace hawser
