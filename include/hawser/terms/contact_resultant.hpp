// Where something touches in the accepted state, and the force there: what is drawn of contact. One resultant
// stands for all integration points of an element in one facet group of a volume, of two elements, or of an
// eighth of a body's volume with another's.
#pragma once

#include <cmath>
#include <vector>

#include "hawser/kernels/contact_point.hpp"

namespace hawser {

// Each is reported by one rank only, the one that counts it. The pair as in ActiveContact.
struct ContactResultant {
  int line = -1, other_line = -1, volume = -1, other_volume = -1;
  Vec3 place = Vec3::Zero();  // m, space axes
  Vec3 force = Vec3::Zero();  // N, space axes, friction with it; on `line`, without one on `volume`
};
using ContactResultants = std::vector<ContactResultant>;

// The sum of forces f_i, and the mean of their places by the sizes s_i of the normal forces:
// sum s_i x_i / sum s_i. It is inside the hull of the places, so from a surface of radius R as far as the
// places are apart, L, squared, over 8 R at most.
class ResultantSum {
 public:
  // place, m, and axes: of the caller's choice, the same for all of a sum; turn: from the point's axes to
  // them. weight: as of the point; negative ones count with their size for the place.
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
