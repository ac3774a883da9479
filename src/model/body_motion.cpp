#include "hawser/model/body_motion.hpp"

namespace hawser::model {
namespace {

HarmonicLaw law_of(const HarmonicMotion& m) {
  return {m.amplitude, m.rotation_amplitude, m.period, m.phase, m.rotation_phase};
}

TableLaw law_of(const TableMotion& m) {
  TableLaw law;
  if (!m.offset.empty()) law.offset = SplineMotion(m.time, m.offset);
  if (!m.rotation.empty()) law.rotation = SplineMotion(m.time, m.rotation);
  return law;
}

struct ToLaw {
  MotionLaw operator()(std::monostate) const { return {}; }
  MotionLaw operator()(const ConstantMotion& m) const { return SteadyLaw{m.velocity, m.axis, m.rate}; }
  MotionLaw operator()(const HarmonicMotion& m) const { return law_of(m); }
  MotionLaw operator()(const TableMotion& m) const { return law_of(m); }
};

}  // namespace

DriftLaw drift_law(const Drift& d) {
  return {d.offset, d.rotation, law_of(d.harmonic), law_of(d.table), d.ramp};
}

RigidMotion rigid_motion(const Body& body) {
  RigidMotion m(body.position, body.rotation, std::visit(ToLaw{}, body.motion), body.ramp);
  if (body.drift) m.set_drift(drift_law(*body.drift));
  return m;
}

}  // namespace hawser::model
