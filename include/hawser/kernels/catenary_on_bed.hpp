// Elastic catenary of several sections from an anchor on a plane seabed to an end above it, partly lying on
// the bed with Coulomb friction. Closed form, see docs/theory/catenary.md. For one section: Jonkman (2007),
// Dynamics Modeling and Loads Analysis of an Offshore Floating Wind Turbine, 2.5.
#pragma once

#include <optional>
#include <vector>

#include "hawser/kernels/catenary.hpp"

namespace hawser {

class CatenaryOnBed {
 public:
  // Position [m] and tension vector [N] (from A to B) at unstretched arc length s [m] from A.
  Vec3 position(double s) const;
  Vec3 tension(double s) const;
  Vec3 tension_a() const { return tension(0); }
  Vec3 tension_b() const { return hanging_->tension_b(); }
  double grounded() const { return grounded_; }  // m, unstretched length on the bed

 private:
  friend std::optional<CatenaryOnBed> catenary_on_bed(const Vec3&, const Vec3&,
                                                      const std::vector<CatenarySection>&, double, double);
  struct LaidPart {
    double start, end;    // m, arc length
    double x_end, T_end;  // m from A, and N, at the end of the piece
    double drag, EA;      // N/m, friction; N
    double free_strain;
    double tension(double s) const;
    double stretched(double s) const;  // m, from s to the end
  };
  Vec3 anchor_ = Vec3::Zero(), direction_ = Vec3::UnitX();
  double grounded_ = 0;
  std::vector<LaidPart> pieces_;
  std::optional<CatenaryShape> hanging_;  // from the touchdown point
};

// `slope`: tangent of the bed's inclination, rising from the anchor towards end B. `friction`: loss of
// tension along the bed towards the anchor per weight on the bed, mu cos + sin of the inclination. Returns
// nullopt if no such shape exists: a load that is not vertical, an end that is not above the anchor, a line
// so long that it hangs straight down, a section that floats.
std::optional<CatenaryOnBed> catenary_on_bed(const Vec3& anchor, const Vec3& end_b,
                                             const std::vector<CatenarySection>& sections, double friction,
                                             double slope = 0);

}  // namespace hawser
