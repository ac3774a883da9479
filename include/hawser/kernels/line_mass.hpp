// Inertia, weight and dead distributed load of one element, consistent with its shape functions.
//
// Beam: the position between the nodes is Hermite's cubic through both ends with the nodes' unit tangents.
// Velocity, acceleration and virtual displacement follow from it with a constant 4x4 mass matrix in (x1, L
// t1, x2, L t2) (Przemieniecki 1968, section 11.4), where t = Q c turns with the node. Rotary inertia of the
// sections is lumped at the ends. Cable: linear shape with the mass matrix m L [5 1; 1 5]/12, the mean of
// lumped and consistent, whose wave speed error is of fourth order (Goudreau & Taylor 1973, eq. 21).
#pragma once

#include "hawser/math/types.hpp"

namespace hawser {

struct MassSection {
  double length = 0;           // m, unstretched
  double mass_per_length = 0;  // kg/m
  Vec3 rotary = Vec3::Zero();  // kg m, per length, about the element axes (along, 2, 3)
  const Mat3* axes = nullptr;  // element axes in node axes (columns), not owned; null: identical
};

struct MassEnds {
  Vec3 a1 = Vec3::Zero(), a2 = Vec3::Zero();  // m/s²
  Vec3 v1 = Vec3::Zero(), v2 = Vec3::Zero();  // m/s
  Quat q1 = Quat::Identity(), q2 = Quat::Identity();
  Vec3 w1 = Vec3::Zero(), w2 = Vec3::Zero();          // rad/s, material
  Vec3 alpha1 = Vec3::Zero(), alpha2 = Vec3::Zero();  // rad/s², material
  // Accelerations of the columns of the rotation matrices, 1/s², and their derivative by the columns' rates,
  // 1/s. Null: from w and alpha.
  const Mat3 *directors1 = nullptr, *directors2 = nullptr;
  double director_weight = 0;
};

// f = M a + gyroscopic terms - load on (x1, theta1, x2, theta2), moments in material axes.
// load: dead force per unstretched length, weight included, N/m.
void beam_mass_force(const MassSection& s, const MassEnds& e, const Vec3& load, Vec12& f);

// Force and tangents by configuration, velocity and acceleration. Given directors are assumed to change by
// director_weight d(R hat(w)) with the configuration and by R hat(d alpha) with the acceleration. The
// contribution of the velocity is included in the latter (its weight in a step is director_weight times that
// of the velocity).
void beam_mass_tangent(const MassSection& s, const MassEnds& e, const Vec3& load, Vec12& f, Mat12& K,
                       Mat12& C, Mat12& M);

// Kinetic energy of the element, J.
double beam_kinetic_energy(const MassSection& s, const MassEnds& e);

// Work of the dead load up to this configuration, J; minus its potential energy.
double beam_load_work(const MassSection& s, const Vec3& x1, const Quat& q1, const Vec3& x2, const Quat& q2,
                      const Vec3& load);

// Mass matrix of a cable, kg: `diagonal` times the identity for each end, `shared` times it between them.
struct CableMass {
  double diagonal, shared;
};
CableMass cable_mass(const MassSection& s);

// Force on (x1, x2) and kinetic energy of a cable.
void cable_mass_force(const MassSection& s, const Vec3& a1, const Vec3& a2, const Vec3& load, Vec6& f);
double cable_kinetic_energy(const MassSection& s, const Vec3& v1, const Vec3& v2);

}  // namespace hawser
