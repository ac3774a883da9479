// The class LinesInWater: fully submerged cables, four at a time. Their force is in
// kernels/morison_submerged.cpp.
#include <algorithm>

#include "hawser/kernels/line_water.hpp"
#include "hawser/terms/feeders.hpp"
#include "hawser/terms/lines_in_water.hpp"

namespace hawser {

void LinesInWater::group() {
  const auto cables =
      std::count_if(pieces_.begin(), pieces_.end(), [](const WetElement& p) { return !p.beam; });
  quads_.reserve((static_cast<size_t>(cables) + 3) / 4);
  for (size_t p = 0; p < pieces_.size(); ++p) {
    if (pieces_[p].beam) {
      beams_.push_back(static_cast<int>(p));
      continue;
    }
    if (quads_.empty() || quads_.back().count == 4) quads_.emplace_back();
    CableQuad& q = quads_.back();
    for (int lane = q.count; lane < 4; ++lane) {
      q.piece[lane] = static_cast<int>(p);
      q.first[lane] = pieces_[p].element.first;
      q.second[lane] = pieces_[p].element.second;
      q.sections.set(lane, pieces_[p].section);
    }
    ++q.count;
  }
}

// In groups of four an idle element has length 0.
void LinesInWater::update_from_feeders(double FedLine::*length) {
  if (!feeders_) return;
  feeders_->update_lengths(mesh_, length, pieces_);
  for (CableQuad& q : quads_)
    for (int lane = 0; lane < 4; ++lane) {
      const WetElement& p = pieces_[static_cast<size_t>(q.piece[lane])];
      WaterSection s = p.section;
      if (p.idle) s.length = 0;
      q.sections.set(lane, s);
    }
}

// Change of the buoyancy potential by feeders, J: that of the change of length, mean of the positions before
// and after.
double LinesInWater::fed_buoyancy(const Kinematics& state) const {
  Water still_water;
  still_water.surface = sea_.surface;
  double sum = 0;
  const State& old = feeders_->before();
  if (old.x.size() != state.x.size()) return 0;
  Kinematics before = state;
  before.x = old.x;
  before.q = old.q;
  for (const WetElement& p : pieces_) {
    if (!p.element.counted || p.idle) continue;
    const FedLine* fed = feeders_->find(p.element.global);
    if (!fed || fed->before == fed->length) continue;
    WaterSection s = p.section;
    s.length = fed->before;
    for (const Kinematics& k : {before, state}) {
      const WaterEnds e = ends(p, k, still_water, still_water);
      sum += 0.5 * (water_potential(p.section, e, p.beam) - water_potential(s, e, p.beam));
    }
  }
  return sum;
}

CablesInWater4 LinesInWater::motion(const CableQuad& q, const Kinematics& k) const {
  CablesInWater4 m;
  const bool moves = moving();
  for (int end = 0; end < 2; ++end) {
    const int* node = end ? q.second : q.first;
    const size_t n[4] = {static_cast<size_t>(node[0]), static_cast<size_t>(node[1]),
                         static_cast<size_t>(node[2]), static_cast<size_t>(node[3])};
    const auto take = [&n](const auto& vector_of_node, wide::Lanes4* to) {
      const Vec3& a = vector_of_node(n[0]);
      const Vec3& b = vector_of_node(n[1]);
      const Vec3& c = vector_of_node(n[2]);
      const Vec3& d = vector_of_node(n[3]);
      for (int i = 0; i < 3; ++i) to[i] = wide::Lanes4{a[i], b[i], c[i], d[i]};
    };
    take([&](size_t i) -> const Vec3& { return k.x[i]; }, m.x[end]);
    take([&](size_t i) -> const Vec3& { return k.v[i]; }, m.v[end]);
    take([&](size_t i) -> const Vec3& { return k.a[i]; }, m.a[end]);
    m.surface[end] = wide::all(sea_.surface);
    if (!moves) continue;
    take([&](size_t i) -> const Vec3& { return water_[i].velocity; }, m.velocity[end]);
    take([&](size_t i) -> const Vec3& { return water_[i].by_height; }, m.by_height[end]);
    take([&](size_t i) -> const Vec3& { return water_[i].acceleration; }, m.acceleration[end]);
    m.surface[end] =
        wide::Lanes4{water_[n[0]].surface, water_[n[1]].surface, water_[n[2]].surface, water_[n[3]].surface};
  }
  return m;
}

// Elements that are not fully submerged are evaluated singly, and all elements far from the static solution:
// the result for an element must not depend on its group, which differs between ranks.
void LinesInWater::add_quad(const CableQuad& q, const Kinematics& trial, Assembler& assembler) const {
  const CablesInWater4 m = motion(q, trial);
  const unsigned wet = assembler.convex() ? 0 : submerged(q.sections, m);
  std::array<Vec6, 4> f;
  std::array<Mat6, 4> J;
  const Weights& w = assembler.weights();
  if (wet && assembler.needs_tangent())
    submerged_tangent(q.sections, m, moving(), w.K, w.C, w.M, f, J);
  else if (wet)
    submerged_force(q.sections, m, moving(), f);
  for (int i = 0; i < q.count; ++i) {
    const WetElement& p = pieces_[static_cast<size_t>(q.piece[i])];
    if (p.idle) continue;
    const int a = mesh_.block[static_cast<size_t>(p.element.first)];
    const int b = mesh_.block[static_cast<size_t>(p.element.second)];
    const bool added = wet >> i & 1 && assembler.add_weighted(a, b, f[i], J[i]);
    if (!added) add_element(p, trial, assembler);
  }
}

// Flow forces of fully submerged cables, without buoyancy. The flow leaves buoyancy unchanged only if both
// the water surface and the still water level are above the whole element.
unsigned LinesInWater::flow_of_quad(const CableQuad& q, const Kinematics& state, WaterForce* out) const {
  CablesInWater4 m = motion(q, state);
  for (wide::Lanes4& s : m.surface) s = s < sea_.surface ? s : wide::all(sea_.surface);
  const unsigned wet = submerged(q.sections, m);
  if (!wet) return 0;
  std::array<Vec6, 4> f;
  submerged_force(q.sections, m, moving(), f);
  for (int i = 0; i < q.count; ++i)
    for (int end = 0; end < 2; ++end) {
      out[i].force[2 * end + 1].setZero();
      out[i].force[2 * end] = -f[i].segment<3>(3 * end);
      out[i].force[2 * end].z() -= 0.5 * q.sections.length[i] * q.sections.buoyancy[i];
    }
  return wet;
}

}  // namespace hawser
