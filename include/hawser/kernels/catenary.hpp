// Elastic catenary of several sections, each under a uniform dead load per unstretched length: the start
// shape of a hanging line. No seabed. Closed form in three dimensions, see docs/theory/catenary.md.
#pragma once

#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct CatenarySection {
  double length = 0;             // m, unstretched
  Vec3 load = Vec3::Zero();      // N/m, weight and lateral loads per unstretched length
  double EA = 0;                 // N
  Vec3 end_load = Vec3::Zero();  // N, point load at the section's far end (a clump weight, a buoy)
  double free_strain = 0;        // without tension: thermal expansion
};

class CatenaryShape {
 public:
  CatenaryShape(const Vec3& end_a, const Vec3& tension_a, std::vector<CatenarySection> sections);

  // Position [m] and tension vector [N] (along the line from A to B) at unstretched arc length s [m] from A.
  // At the joint of two sections: just before it.
  Vec3 position(double s) const;
  Vec3 tension(double s) const;
  double length() const { return start_.back(); }
  Vec3 end_b() const { return position_.back(); }
  Vec3 tension_a() const { return tension_.front(); }  // the line pulls anchor A with this force
  Vec3 tension_b() const { return last_tension_; }     // and end B with minus this one

 private:
  size_t section(double s) const;
  std::vector<CatenarySection> sections_;
  std::vector<double> start_;             // arc length where a section starts, and the whole length
  std::vector<Vec3> position_, tension_;  // there
  Vec3 last_tension_ = Vec3::Zero();
};

// Both ends held. Newton on the line's complementary energy, which is convex in the tension at A, so the
// answer is unique and found from any start. Throws std::invalid_argument for lengths or EA that are not
// positive, and for a slack line without load (its shape is not determined).
CatenaryShape catenary(const Vec3& end_a, const Vec3& end_b, const std::vector<CatenarySection>& sections);

// One end free: the line streams from the other one.
CatenaryShape catenary_free_b(const Vec3& end_a, const std::vector<CatenarySection>& sections);
CatenaryShape catenary_free_a(const Vec3& end_b, const std::vector<CatenarySection>& sections);

// r(length) - r(0) of one section whose tension at its start is `tension`, and, when wanted, its derivative
// by `tension` (symmetric, positive).
Vec3 catenary_chord(const Vec3& tension, const Vec3& load, double length, double EA,
                    Mat3* derivative = nullptr, double free_strain = 0);

}  // namespace hawser
