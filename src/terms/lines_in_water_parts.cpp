// The class LinesInWater: flow force on an element if it had more nodes (docs/theory/element-length.md).
#include "hawser/terms/lines_in_water.hpp"

namespace hawser {

// The parts lie on the chord and move with it, so that only the water motion makes a difference. The surface
// is linear over the whole piece for the same reason: a floating line follows the surface whatever its shape.
LinesInWater::FlowError LinesInWater::flow_error(const Kinematics& state, const WetElement& p,
                                                 int parts) const {
  FlowError out;
  if (p.idle) return out;
  constexpr int kFiner = 4;
  const size_t i = static_cast<size_t>(p.element.first);
  const size_t j = static_cast<size_t>(p.element.second);
  const Water first = water(state, i);
  const Water second = water(state, j);
  struct Cut {
    Vec3 x, v, a;
    Water water;
  };
  const auto cut = [&](int k) {
    const double s = static_cast<double>(k) / (kFiner * parts);
    const auto between = [s](const Vec3& a, const Vec3& b) { return Vec3((1 - s) * a + s * b); };
    Cut c{between(state.x[i], state.x[j]), between(state.v[i], state.v[j]), between(state.a[i], state.a[j]),
          k == 0 ? first : second};
    if (k == 0 || k == kFiner * parts) return c;
    c.water = sea_.without_waves_at(c.x.z(), state.time);
    if (has_waves() && state.moves())
      c.water = c.water + sea_.waves_at(between(wave_place(state, i), wave_place(state, j)), state.time);
    c.water.surface = (1 - s) * first.surface + s * second.surface;
    return c;
  };
  const auto force = [&](const Cut& a, const Cut& b, int pieces) {
    WaterSection part = p.section;
    part.length /= pieces;
    return straight_flow_force(part, {a.x, b.x, a.v, b.v, a.a, b.a, a.water, b.water}, p.beam);
  };
  Cut from = cut(0);
  for (int part = 0; part < parts; ++part) {
    Vec3 fine = Vec3::Zero();
    Cut last = from;
    for (int k = 1; k <= kFiner; ++k) {
      const Cut next = cut(kFiner * part + k);
      const Vec3 f = force(last, next, kFiner * parts);
      fine += f;
      out.force += f.norm();
      last = next;
    }
    out.error += (force(from, last, parts) - fine).norm();
    from = last;
  }
  out.crossed = (state.x[i].z() - first.surface) * (state.x[j].z() - second.surface) < 0;
  return out;
}

}  // namespace hawser
