// Conversion of the motion and drift of a body to the time functions of kernels/motion.hpp, and the times at
// which the velocity of a motion table jumps.
#include "hawser/model/body_motion.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "hawser/math/so3.hpp"

namespace hawser::model {
namespace {

HarmonicLaw law_of(const HarmonicMotion& m) {
  return {m.amplitude, m.rotation_amplitude, m.period, m.phase, m.rotation_phase};
}

struct ToLaw {
  MotionLaw operator()(std::monostate) const { return {}; }
  MotionLaw operator()(const ConstantMotion& m) const { return SteadyLaw{m.velocity, m.axis, m.rate}; }
  MotionLaw operator()(const HarmonicMotion& m) const { return law_of(m); }
  MotionLaw operator()(const TableMotion& m) const { return table_law(m); }
};

}  // namespace

double heading(const Body& body) {
  const Vec3 bow = exp_so3(body.rotation) * Vec3::UnitX();
  return std::atan2(bow.y(), bow.x());
}

double hydrodynamic_heading(const Body& body) {
  const auto& given = body.mass->hydrodynamics->heading;
  return given ? *given : heading(body);
}

Vec3 hydrodynamic_place(const Body& body, double surface) {
  const BodyHydrodynamics& h = *body.mass->hydrodynamics;
  return h.place ? *h.place : Vec3(body.position.x(), body.position.y(), surface + h.in_file.z());
}

TableLaw table_law(const TableMotion& m) {
  TableLaw law;
  if (!m.offset.empty()) law.offset = RowCurve(m.time, m.offset, m.between);
  if (!m.rotation.empty()) law.rotation = RowCurve(m.time, m.rotation, m.between);
  return law;
}

DriftLaw drift_law(const Drift& d) {
  return {d.offset, d.rotation, law_of(d.harmonic), table_law(d.table), d.ramp};
}

RigidMotion rigid_motion(const Body& body) {
  RigidMotion m(body.position, body.rotation, std::visit(ToLaw{}, body.motion), body.ramp);
  if (body.drift) m.set_drift(drift_law(*body.drift));
  return m;
}

namespace {

// Rows near t = 0, enough for the exact start of the curve to rounding: the influence of a row on a spline
// decays by at least a half from row to row (tridiagonal equations with a diagonal twice the off-diagonal
// sum).
TableMotion near_start(const TableMotion& t) {
  constexpr std::ptrdiff_t kRows = 64;
  const auto size = static_cast<std::ptrdiff_t>(t.time.size());
  const auto at = std::lower_bound(t.time.begin(), t.time.end(), 0.0) - t.time.begin();
  const auto first = std::max<std::ptrdiff_t>(at - kRows, 0);
  const auto last = std::min(at + kRows, size);
  TableMotion out;
  out.between = t.between;
  const auto take = [&](const auto& from, auto& to) {
    if (!from.empty()) to.assign(from.begin() + first, from.begin() + last);
  };
  take(t.time, out.time);
  take(t.offset, out.offset);
  take(t.rotation, out.rotation);
  return out;
}

}  // namespace

RigidPose pose_at_start(const Body& body) {
  Body b;
  b.position = body.position;
  b.rotation = body.rotation;
  b.ramp = body.ramp;
  const auto* table = std::get_if<TableMotion>(&body.motion);
  b.motion = table ? Motion(near_start(*table)) : body.motion;
  if (body.drift) {
    b.drift = Drift{body.drift->offset, body.drift->rotation, body.drift->harmonic,
                    near_start(body.drift->table), body.drift->ramp};
  }
  return rigid_motion(b).at(0);
}

std::vector<double> velocity_jumps(const std::vector<Body>& bodies) {
  std::vector<double> out;
  const auto add = [&](const TableMotion& t) {
    if (t.between == BetweenRows::linear) out.insert(out.end(), t.time.begin(), t.time.end());
  };
  for (const Body& b : bodies) {
    if (const auto* t = std::get_if<TableMotion>(&b.motion)) add(*t);
    if (b.drift) add(b.drift->table);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace hawser::model
