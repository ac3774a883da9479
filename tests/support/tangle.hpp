// Lines that cross each other, and a force term between any of their elements that are near each other: for
// tests of candidates, ghosts and matrix patterns.
#pragma once

#include <random>

#include "hawser/terms/line_candidates.hpp"
#include "support/rig.hpp"

namespace hawser::test {

// Linear springs that push the midpoints of two elements apart when they are nearer than the sum of the
// radii.
class MiddleSprings final : public ForceTerm, public CouplesNodes, public LimitsSteps {
 public:
  MiddleSprings(MPI_Comm comm, const LocalMesh& mesh, double radius, double stiffness,
                CandidateSettings settings = {})
      : list(comm, mesh, ContactRadii({radius, radius}), std::move(settings)), mesh_(mesh), k_(stiffness) {}

  LineCandidates list;
  // Steps longer than this [s] are rejected in this interval of time.
  double refuse = 1e30, refuse_from = 0, refuse_to = 0;
  int located = 0;

  std::string_view checkpoint_key() const override { return "middle springs"; }
  bool refresh_couplings(const Kinematics& committed, double h) override { return list.update(committed, h); }
  void list_couplings(Couplings& to) const override { list.list_couplings(to); }
  void renumber() override {
    list.locate();
    ++located;
  }
  void limit_step(const Kinematics&, ImpactEvents&) override {}
  Verdict check_step(const Kinematics& t) const override {
    if (!list.covers(t)) return {Verdict::Kind::prepare_again, advice::BeyondContactSearch{}};
    const bool refused = t.step > refuse && t.time > refuse_from && t.time < refuse_to;
    return refused ? Verdict{Verdict::Kind::shorter, advice::ImpactNotResolved{}} : Verdict{};
  }
  void evaluate(const Kinematics& state, Assembler& assembler) override {
    for (const CandidatePair& p : list.pairs()) {
      const Spring s = spring(state, p);
      if (!(s.shorter > 0)) continue;
      Vec12 f;
      Mat12 K;
      const Mat3 nn = s.normal * s.normal.transpose();
      const Mat3 k = 0.25 * k_ * (nn - s.shorter / s.distance * (Mat3::Identity() - nn));
      for (int i = 0; i < 4; ++i) {
        const double sign = i < 2 ? 1 : -1;
        f.segment<3>(3 * i) = -0.5 * sign * k_ * s.shorter * s.normal;
        for (int j = 0; j < 4; ++j) K.block<3, 3>(3 * i, 3 * j) = sign * (j < 2 ? 1 : -1) * k;
      }
      assembler.add(s.blocks, f, K);
    }
  }
  Energy energy(const Kinematics& state) const override {
    Energy e;
    for (const CandidatePair& p : list.pairs())
      if (p.counted) {
        const double x = std::max(spring(state, p).shorter, 0.0);
        e.strain += 0.5 * k_ * x * x;
      }
    return e;
  }

 private:
  struct Spring {
    int blocks[4];
    Vec3 normal;
    double distance, shorter;
  };
  Spring spring(const Kinematics& state, const CandidatePair& p) const {
    const ContactSegment& a = list.segments()[static_cast<size_t>(p.a)];
    const ContactSegment& b = list.segments()[static_cast<size_t>(p.b)];
    const auto x = [&](int n) { return state.x[static_cast<size_t>(n)]; };
    const auto block = [&](int n) { return mesh_.block[static_cast<size_t>(n)]; };
    Spring s{{block(a.first), block(a.second), block(b.first), block(b.second)}, {}, 0, 0};
    const Vec3 d = 0.5 * (x(a.first) + x(a.second)) - 0.5 * (x(b.first) + x(b.second));
    s.distance = d.norm();
    s.normal = d / s.distance;
    s.shorter = a.radius + b.radius - s.distance;
    return s;
  }
  const LocalMesh& mesh_;
  double k_;
};

// Random walks, alternately of beams and cables, in a room of 12 m.
inline model::Case tangle(int lines, int elements, double length = 1) {
  model::Case c;
  c.environment.gravity = 0;
  c.line_types = {beam_type(1e6, 1e3, 1e3), cable_type(1e6, 1)};
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < lines; ++i) {
    model::Line l;
    l.name = "line" + std::to_string(i);
    l.sections.push_back({c.line_types[static_cast<size_t>(i % 2)].name, length * elements, elements, 1});
    l.start = model::Start::points;
    Vec3 at = 6 * Vec3(unit(rng), unit(rng), unit(rng));
    Vec3 way = Vec3(unit(rng), unit(rng), unit(rng));
    l.end_a = anchor(at);
    for (int k = 0; k <= elements; ++k) {
      l.points.push_back(at);
      way = (way + 0.5 * Vec3(unit(rng), unit(rng), unit(rng)) - 0.05 * at).normalized();
      at += length * way;
    }
    c.lines.push_back(l);
  }
  c.dynamics.duration = 1;
  return c;
}

}  // namespace hawser::test
