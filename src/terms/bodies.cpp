#include "hawser/terms/bodies.hpp"

namespace hawser {
namespace {

struct ToLaw {
  MotionLaw operator()(std::monostate) const { return {}; }
  MotionLaw operator()(const model::ConstantMotion& m) const { return SteadyLaw{m.velocity, m.axis, m.rate}; }
  MotionLaw operator()(const model::HarmonicMotion& m) const {
    return HarmonicLaw{m.amplitude, m.rotation_amplitude, m.period, m.phase, m.rotation_phase};
  }
  MotionLaw operator()(const model::TableMotion& m) const {
    TableLaw law;
    if (!m.offset.empty()) law.offset = SplineMotion(m.time, m.offset);
    if (!m.rotation.empty()) law.rotation = SplineMotion(m.time, m.rotation);
    return law;
  }
};

}  // namespace

RigidMotion rigid_motion(const model::Body& body) {
  return {body.position, body.rotation, std::visit(ToLaw{}, body.motion), body.ramp};
}

Bodies::Bodies(const std::vector<model::Body>& bodies) {
  for (const model::Body& b : bodies) motions_.push_back(rigid_motion(b));
}

}  // namespace hawser
