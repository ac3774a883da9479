// Elastic catenary of several sections, each under a uniform dead load per unstretched length: start shape of
// a hanging line, without seabed. Closed form in three dimensions, see docs/theory/catenary.md.
#pragma once

#include <vector>

#include "hawser/math/types.hpp"

namespace hawser {

struct CatenarySection {
  double length = 0;             // m, unstretched
  Vec3 load = Vec3::Zero();      // N/m, weight and lateral loads per unstretched length
  double EA = 0;                 // N
  Vec3 end_load = Vec3::Zero();  // N, point load at the section's far end (a clump weight, a buoy)
  double free_strain = 0;        // strain without tension (thermal expansion)
};

class CatenaryShape {
 public:
  CatenaryShape(const Vec3& end_a, const Vec3& tension_a, std::vector<CatenarySection> sections);

  // Position [m] and tension vector [N] (along the line from A to B) at unstretched arc length s [m] from A;
  // at the joint of two sections just before it.
  Vec3 position(double s) const;
  Vec3 tension(double s) const;
  double length() const { return start_.back(); }
  Vec3 end_b() const { return position_.back(); }
  Vec3 tension_a() const { return tension_.front(); }  // force of the line on anchor A
  Vec3 tension_b() const { return last_tension_; }     // minus the force of the line on end B

 private:
  size_t section(double s) const;
  std::vector<CatenarySection> sections_;
  std::vector<double> start_;             // m, arc length at the start of each section, and the total length
  std::vector<Vec3> position_, tension_;  // at start_
  Vec3 last_tension_ = Vec3::Zero();
};

// Line held at both ends. Newton's method on the complementary energy, which is convex in the tension at A,
// so the solution is unique and found from any start. Throws std::invalid_argument if a length or EA is not
// positive, and for a slack line without load, whose shape is undetermined.
CatenaryShape catenary(const Vec3& end_a, const Vec3& end_b, const std::vector<CatenarySection>& sections);

// Line with one free end, which streams from the held end.
CatenaryShape catenary_free_b(const Vec3& end_a, const std::vector<CatenarySection>& sections);
CatenaryShape catenary_free_a(const Vec3& end_b, const std::vector<CatenarySection>& sections);

// r(length) - r(0) of one section whose tension at its start is `tension`, and on request its derivative by
// `tension` (symmetric, positive).
Vec3 catenary_chord(const Vec3& tension, const Vec3& load, double length, double EA,
                    Mat3* derivative = nullptr, double free_strain = 0);

}  // namespace hawser
