// Contact of two lines at one pair of points: force, couple, remaining elastic slip, and exact derivatives.
// Pure. All quantities are per length of the line along which the contact is integrated.
#pragma once

#include "hawser/kernels/contact_law.hpp"
#include "hawser/kernels/friction_law.hpp"
#include "hawser/math/types.hpp"

namespace hawser {

struct LinePairLaw {
  double radii = 0;      // m, sum of both radii
  NormalLaw normal;      // per length
  FrictionLaw friction;  // isotropic
};

// x: point on the axis of one line; y: its nearest point on the axis of the other.
struct LinePairPoint {
  Vec3 away = Vec3::UnitZ();   // m, D = x - y
  Vec3 along = Vec3::UnitX();  // m, T: tangent of the other line at y, any length
  Vec3 moved = Vec3::Zero();   // m, M: displacement of x's surface along y's in the step
  double rate = 0;             // m/s, of the gap
  double slip[2] = {0, 0};     // m, elastic slip at the start: along T and along n x T
  // State at the start of the step of material that did not touch then (line_pair_closing.hpp). slope:
  // tangent of x's own line, m.
  bool is_new = false;
  Vec3 away_before = Vec3::UnitZ(), slope = Vec3::UnitX(), slope_before = Vec3::UnitX(),
       along_before = Vec3::UnitX();
};

struct LinePairForce {
  // Columns of `by`: D, T, M, rate, slip; for new material also D before, slope, slope before, T before.
  static constexpr int kAway = 0, kAlong = 3, kMoved = 6, kRate = 9, kSlip = 10, kAwayBefore = 12,
                       kSlope = 15, kSlopeBefore = 18, kAlongBefore = 21, kInputs = 24;

  NormalForce along_normal;
  double gap = 0;                // m
  Vec3 force = Vec3::Zero();     // N/m, on x: normal and friction; the opposite force acts on y
  Vec3 friction = Vec3::Zero();  // N/m
  Vec3 couple = Vec3::Zero();    // N, force x D; acts on the sections, distributed by the radii
  double slip[2] = {0, 0};       // m, elastic slip that remains: along T and n x T
  bool slides = false;
  Eigen::Matrix<double, 3, kInputs> by;  // derivatives of force; filled on request
};

// Trial slip: the previous slip, carried along in the frame (T, n x T) of the other line, plus the part of M
// in the tangent plane (in a step in which the lines came into contact, only the part after that). Friction
// acts at the surfaces: the forces t at x and -t at y and the couple -D x t together have no moment.
LinePairForce line_pair_force(const LinePairLaw& law, const LinePairPoint& at, bool derivatives);

}  // namespace hawser
