// The class LineVolumeContact: adds contact of lines with volumes (triangle meshes and exact shapes) to
// residual and tangent. The force acts on the element's nodes, the reaction on the floating body. evaluate()
// calls, for each near pair:
//   normal_force()            N(g, r) of gap and rate: kernels/contact_law.hpp
//   surface_contact()         force f at a point, df/dx, df/dv: kernels/surface_contact_law.cpp
//   AxisContact::add_panel()  F_j = -sum of w H_j f over the Gauss points of a panel (the residual) with K_jk
//                             and C_jk, also through moving ends: contact_along_axis.cpp
//   Stencil::to_blocks()      chain rule from points x + R y of the axis to positions x and rotations R of
//                             the nodes; for cables the identity: kernels/stencil.cpp
#include <limits>

#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {

std::optional<AxisContact::Rolls> LineVolumeContact::rolls(const Pair& pair, const AxisShape& shape) const {
  if (!settings(pair).rolling || shape.count() != AxisShape::kMaxPositions || !friction_on_ ||
      !pair.laws[0].friction.active())
    return std::nullopt;
  const Quat before = pair.start.pose.rotation.conjugate();
  const Quat after = volumes_.trial_pose(pair.volume).rotation.conjugate();
  AxisContact::Rolls r;
  for (size_t i = 0; i < 2; ++i)
    r.ends[i] = axis_roll(before * pair.start.shape.turn(i), after * shape.turn(i), Vec3::UnitX());
  return r;
}

// Contact points are kept for commit() only from an evaluation without derivatives. With derivatives friction
// has other round-off, and commit() would depend on which evaluation came last.
AxisContact LineVolumeContact::contact(Pair& pair, const AxisShape& shape,
                                       const AxisContactMode& mode) const {
  const RigidPose& pose = volumes_.trial_pose(pair.volume);
  const auto law = [&](const ContactPanel& s) { return applied(pair.law(0.5 * (s.from + s.to))); };
  const auto query = [&](const ContactPanel& s, double xi) {
    return finder_.query(pair, s.group, xi, pose.to_body(shape.point(xi)), pair.contact_distance + 1e-9);
  };
  const auto start = [&](const ContactPanel& s, double xi, ContactRates* rates) {
    return finder_.start(pair, s.group, xi, rates);
  };
  AxisContact c(shape, pose, pair.radius, pair.length, mode, rolls(pair, shape));
  pair.trial.evaluated.clear();
  c.add(pair.trial.contact, {law, query, start}, mode.tangent ? nullptr : &pair.trial.evaluated);
  pair.trial.evaluation = mode.tangent ? Pair::Evaluation::none : Pair::evaluation_of(mode.moves);
  return c;
}

// Most pairs are far apart and need no search.
void LineVolumeContact::find_near_pairs(const Kinematics& trial) {
  near_.clear();
  for (size_t i = 0; i < pairs_.size(); ++i) {
    Pair& pair = pairs_[i];
    const AxisShape shape(ends(trial, pair.element));
    const RigidPose& pose = volumes_.trial_pose(pair.volume);
    if (finder_.skip_if_clear(pair, shape, pose)) continue;
    near_.push_back({i, shape});
    finder_.search(pair, shape, pose);
  }
}

void LineVolumeContact::evaluate(const Kinematics& trial, Assembler& assembler) {
  volumes_.pose_trial(trial);
  find_near_pairs(trial);
  const bool tangent = assembler.needs_tangent();
  const bool moves = trial.moves();
  for (const Near& near : near_) {
    Pair& pair = pairs_[near.pair];
    if (pair.trial.contact.panels.empty()) continue;
    const bool beam = near.shape.count() == AxisShape::kMaxPositions;
    Stencil stencil;
    near.shape.attach(stencil);
    const Eigen::Index size = 3 * stencil.blocks;
    BlockVector f = BlockVector::Zero(size);
    BlockMatrix K, C;
    if (tangent) {
      K.setZero(size, size);
      C.setZero(size, size);
    }
    contact(pair, near.shape, {moves, tangent, assembler.convex()})
        .to_blocks(stencil, f, tangent ? &K : nullptr, tangent ? &C : nullptr);
    const LocalElement& e = local(pair);
    const int a = mesh_.block[e.first];
    const int b = mesh_.block[e.second];
    const int blocks[4] = {a, beam ? a + 1 : b, b, b + 1};
    const size_t count = stencil.blocks;
    if (!volumes_.floats(pair.volume)) {
      assembler.add({blocks, count}, f, K, moves ? DerivativeView(C) : DerivativeView());
      continue;
    }
    if (!volumes_.coupled(mesh_.element(e), pair.volume)) {
      // Newton's iteration has moved line or body further than the couplings reach. To PETSc such a state is
      // outside the domain of the residual; the step is tried again with a smaller increment.
      f.setConstant(std::numeric_limits<double>::quiet_NaN());
      assembler.add({blocks, count}, f, K, moves ? DerivativeView(C) : DerivativeView());
      continue;
    }
    std::array<LineBlock, 4> line;
    for (size_t i = 0; i < count; ++i) {
      const size_t n = i < (beam ? 2U : 1U) ? e.first : e.second;
      line[i] = {blocks[i], beam && i % 2 == 1, trial.x[n], trial.v[n], trial.q[n].toRotationMatrix()};
    }
    const LineBlocks touching = beam ? LineBlocks(std::span(line)) : LineBlocks(std::span(line).first<2>());
    add_against_body(assembler, touching, volumes_.floating_frame(pair.volume, trial), e.counted, f,
                     tangent ? &K : nullptr, tangent && moves ? &C : nullptr);
  }
}

}  // namespace hawser
