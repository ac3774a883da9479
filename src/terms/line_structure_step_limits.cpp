// The class LineStructure: steps in which a cable comes taut faster than they resolve.
#include <algorithm>
#include <cmath>

#include "hawser/kernels/tension_peak.hpp"
#include "hawser/terms/line_structure.hpp"

namespace hawser {
namespace {

// Tension [N] of the spring of a cable, without its damper, and its slope by strain [N]; 0 if it is slack.
ResponseCurve::Value spring(const LineStructure::Cable& c, const Kinematics& state) {
  const Vec3 chord = state.x[c.element.second] - state.x[c.element.first];
  const double strain = chord.norm() / c.section.length - 1 - c.section.free_strain;
  return strain > 0 ? c.section.axial(strain) : ResponseCurve::Value{};
}

}  // namespace

void LineStructure::update_peaks(const Kinematics& from) {
  for (Cable& c : cables_) {
    c.peak.before = spring(c, from).force;
    c.peak.largest = std::max(c.peak.largest, c.peak.before);
  }
}

// Only a tension above all earlier ones of its element is a peak that counts, so that repeated snap loads of
// equal size divide few steps. A step shorter than the wave's time through the element cannot resolve more
// than the element does.
void LineStructure::unresolved(const Kinematics& trial, UnresolvedImpacts& to) {
  for (const Cable& c : cables_) {
    if (!c.element.counted || c.idle) continue;
    const ResponseCurve::Value now = spring(c, trial);
    if (!(now.force > c.peak.largest) || resolves_peak(c.peak.before, now.force)) continue;
    // The passage is that at the initial stiffness.
    if (trial.step > c.peak.passage * std::sqrt(c.section.EA / now.slope)) to.too_fast = true;
  }
}

}  // namespace hawser
