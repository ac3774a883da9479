// Prescribed motion of a body as the case gives it. Its law is kernels/motion.hpp.
#pragma once

#include <variant>
#include <vector>

#include "hawser/kernels/motion.hpp"
#include "hawser/math/types.hpp"

namespace hawser::model {

// Prescribed motions u(t) for t >= 0. u and its first two derivatives are continuous, except for a table that
// is interpolated by monotone cubics (u and u' are continuous) or linearly (u is).
struct ConstantMotion {
  Vec3 velocity = Vec3::Zero();  // m/s
  Vec3 axis = Vec3::UnitZ();     // unit, space-fixed, through the body's position
  double rate = 0;               // rad/s
  bool operator==(const ConstantMotion&) const = default;
};
struct HarmonicMotion {           // offset(t) = amplitude * sin(2 pi t / period + phase), componentwise
  Vec3 amplitude = Vec3::Zero();  // m
  Vec3 rotation_amplitude = Vec3::Zero();  // rad, rotation vector
  double period = 1;                       // s
  Vec3 phase = Vec3::Zero();               // rad
  Vec3 rotation_phase = Vec3::Zero();      // rad
  bool operator==(const HarmonicMotion&) const = default;
};
struct TableMotion {
  std::vector<double> time;    // s, increasing
  std::vector<Vec3> offset;    // m
  std::vector<Vec3> rotation;  // rad, rotation vector (may be empty)
  BetweenRows between = BetweenRows::spline;
  bool of_waves = false;  // the rows are responses to the case's waves
  bool operator==(const TableMotion&) const = default;
};
using Motion = std::variant<std::monostate, ConstantMotion, HarmonicMotion, TableMotion>;

// Slow motion that is superposed on `motion`: constant offset, harmonic part and table.
struct Drift {
  Vec3 offset = Vec3::Zero(), rotation = Vec3::Zero();  // m; rad, rotation vector
  HarmonicMotion harmonic;
  TableMotion table;
  double ramp = 0;  // s, smooth start; 0: acts from statics on
  bool operator==(const Drift&) const = default;
};

}  // namespace hawser::model
