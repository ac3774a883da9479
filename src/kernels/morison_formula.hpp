// Morison's equation per metre of a fully wet line, for one element (Scalar: double, Vector: wide::Row) or
// four at once (Scalar: wide::Lanes4, Vector: Triple of them). Symbols as in docs/theory/water.md. Internal
// to the kernels.
#pragma once

#include <cmath>

#include "hawser/math/wide3.hpp"

namespace hawser::morison_formula {

// Drag for the relative velocity u = u_water - v and the unit tangent t: with u_t = u.t and u_n = u - u_t t
//   f_d = c_n |u_n| u_n + c_t |u_t| u_t t,   c_n = ½ρ C_d,n D,   c_t = ½ρ C_d,t πD   [kg/m²],
// with D the drag diameter, and with P = I - t t' its derivatives by u and by a rotation of t
//   S = c_n/|u_n| u_n u_n' + c_n |u_n| I + (2 c_t |u_t| - c_n |u_n|) t t',
//   T = ((2 c_t |u_t| - c_n |u_n|) t - c_n u_t/|u_n| u_n) u_n' + u_t (c_t |u_t| - c_n |u_n|) P.
template <class Scalar, class Vector>
struct Drag {
  Vector t;
  Scalar along;          // u_t
  Vector across;         // u_n
  Scalar normal, axial;  // c_n |u_n|, c_t |u_t|
  Scalar over_speed;     // c_n / |u_n|; 0 if u_n = 0

  Drag(const Vector& u, const Vector& tangent, Scalar c_n, Scalar c_t) : t(tangent) {
    using std::abs, std::sqrt, wide::abs, wide::dot, wide::sqrt;
    along = dot(u, t);
    across = u - along * t;
    const Scalar speed = sqrt(dot(across, across));
    normal = c_n * speed;
    axial = c_t * abs(along);
    over_speed = speed > 0 ? c_n / speed : Scalar{};
  }
  Vector force() const { return normal * across + (axial * along) * t; }
  Scalar lengthwise() const { return 2 * axial - normal; }                               // of t t' in S
  Vector by_across() const { return lengthwise() * t - (along * over_speed) * across; }  // of u_n' in T
  Scalar by_turn() const { return along * (axial - normal); }                            // of P in T
};

// Added mass times the acceleration y, (m_n P + m_t t t') y, with m_n and m_t - m_n [kg/m].
template <class Scalar, class Vector>
Vector added_mass(Scalar m_n, Scalar difference, const Vector& t, const Vector& y) {
  using wide::dot;
  return m_n * y + (difference * dot(t, y)) * t;
}

}  // namespace hawser::morison_formula
