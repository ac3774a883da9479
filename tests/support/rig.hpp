// Cases of one line built in code, for verification against references from outside the program.
#pragma once

#include <gtest/gtest.h>

#include "hawser/math/so3.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::test {

using run::Simulation;

// A beam type of negligible weight, from which a case sets further properties.
inline model::LineType beam_type(double EA, double EI, double GJ, double mass = 1) {
  model::LineType t;
  t.name = "beam";
  t.outer_diameter = t.contact_diameter = 0.1;
  t.mass_per_length = mass;
  t.EA = EA;
  t.EI2 = t.EI3 = EI;
  t.GJ = GJ;
  t.rotary_inertia = Vec3::Constant(1e-4);
  return t;
}

inline model::LineType cable_type(double EA, double mass) {
  model::LineType t = beam_type(EA, 0, 0, mass);
  t.name = "cable";
  t.kind = model::LineKind::cable;
  return t;
}

inline model::End anchor(const Vec3& at) {
  model::End e;
  e.kind = model::EndKind::anchor;
  e.at = at;
  return e;
}

inline model::End clamp(const Vec3& at, const Vec3& direction) {
  model::End e = anchor(at);
  e.clamped = true;
  e.direction = direction;
  return e;
}

// One line of one type from end A to end B, without gravity.
inline model::Case one_line(const model::LineType& type, double length, int elements, const model::End& a,
                            const model::End& b) {
  model::Case c;
  c.environment.gravity = 0;
  c.line_types.push_back(type);
  model::Line l;
  l.name = "line";
  l.sections.push_back({type.name, length, elements, 1});
  l.end_a = a;
  l.end_b = b;
  c.lines.push_back(l);
  c.dynamics.duration = 1;
  return c;
}

}  // namespace hawser::test
