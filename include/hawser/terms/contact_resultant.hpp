// Contact forces of the accepted state, reduced to few points for drawing. A resultant is the sum over the
// integration points of an element in one facet group of a volume, of a pair of line elements, or of an
// eighth of a body's volume against the volume of another body.
#pragma once

#include <cmath>
#include <vector>

#include "hawser/kernels/contact_point.hpp"

namespace hawser {

// Only the rank that counts the contact reports it. Indices of lines and volumes as in ActiveContact.
struct ContactResultant {
  int line = -1, other_line = -1, volume = -1, other_volume = -1;
  Vec3 place = Vec3::Zero();  // m, space axes
  Vec3 force = Vec3::Zero();  // N, space axes, with friction; acts on `line`, or on `volume` if line is -1
};
using ContactResultants = std::vector<ContactResultant>;

// Sum of the forces f_i of contact points x_i, and their mean place sum s_i x_i / sum s_i, weighted by the
// magnitudes s_i of the normal forces. Points that span a length L on a surface of radius R have their mean
// place within L²/(8 R) of the surface.
class ResultantSum {
 public:
  // place: m, in axes chosen by the caller, the same for all points of a sum. turn: rotation from the axes of
  // p to those axes. sign: -1 reverses the force. A negative quadrature weight enters the place with its
  // magnitude.
  void add(const Vec3& place, const ContactPoint& p, const Mat3& turn, double sign = 1) {
    const double size = std::abs(p.weight) * p.normal_force;
    size_ += size;
    place_ += size * place;
    force_ += sign * p.weight * (turn * p.force);
  }
  bool any() const { return size_ > 0; }
  Vec3 place() const { return place_ / size_; }
  const Vec3& force() const { return force_; }

 private:
  double size_ = 0;
  Vec3 place_ = Vec3::Zero(), force_ = Vec3::Zero();
};

}  // namespace hawser
