// Impacts of bodies at default steps and numerical damping: the energy is conserved for corners, edges and
// faces, and the results are the same on any number of ranks.
#include <gtest/gtest.h>

#include "hawser/base/error.hpp"
#include "hawser/run/volumes.hpp"
#include "hawser/terms/body_contact.hpp"
#include "verification/dynamics_rig.hpp"

namespace hawser::test::body_impact {
namespace {

using model::StiffnessBasis;

model::Case two(const Primitive& a, const Primitive& b, StiffnessBasis basis, const Vec3& at) {
  model::Case c;
  c.statics.enabled = false;
  for (const bool second : {false, true}) {
    model::Body body;
    body.name = std::string(1, second ? 'B' : 'A');
    body.mass.emplace();
    body.mass->mass = second ? 2000 : 1000;
    body.mass->inertia = {500, 600, 400};
    body.mass->velocity = {second ? -0.5 : 1, 0, 0};
    if (second) body.position = at;
    c.bodies.push_back(body);
    model::Volume v;
    v.name = std::string(1, second ? 'b' : 'a');
    v.body = body.name;
    v.shape = second ? b : a;
    v.basis = basis;
    v.normal_stiffness = 1e6;
    c.volumes.push_back(v);
  }
  // They touch at 0.07 s, for 0.1 s.
  c.dynamics.enabled = true;
  c.dynamics.duration = 0.5;
  return c;
}

// A box of a tonne, 1 m above the floor.
model::Case falling() {
  model::Case c = two(BoxShape{{0, 0, 0}, {2, 2, 2}}, PlaneShape{{0, 0, 0}, {0, 0, 1}},
                      StiffnessBasis::per_point, Vec3::Zero());
  c.bodies[0].mass->weight = true;
  c.bodies[0].mass->velocity.setZero();
  c.bodies[0].position = {0, 0, 2};
  c.bodies[1].mass.reset();
  c.volumes[1].basis = StiffnessBasis::automatic;
  c.volumes[1].normal_stiffness = 0;
  c.dynamics.duration = 1;
  return c;
}

struct Outcome {
  double energy = 0, strain = 0, momentum = 0;  // energy error, largest strain energy, momentum error
  int steps = 0, touching = 0, rejected = 0;
  std::vector<double> poses;
};

Outcome impact_event(MPI_Comm comm, const model::Case& c) {
  const auto volumes = run::load_volumes(c);
  std::vector<BodySkeleton> skeletons = run::skeletons(c, volumes);
  // Pieces of faces are 20 cm (600 points each) and not 8 cm.
  for (size_t v = 0; v < skeletons.size(); ++v)
    if (c.volumes[v].basis == StiffnessBasis::per_area)
      skeletons[v].features =
          body_skeleton(c.volumes[v], *volumes[v].facets, volumes[v].active, 0.2).features;
  run::Simulation s(comm, c, run::surfaces(volumes), skeletons);
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const auto sum = [&](auto what) {
    MPI_Allreduce(MPI_IN_PLACE, what.data(), static_cast<int>(what.size()), MPI_DOUBLE, MPI_SUM, comm);
    return what;
  };
  struct Now {
    double total, strain;
    Vec3 momentum;
  };
  const auto now = [&] {
    const Energy e = s.system().energy(d.committed_kinematics());
    std::array<double, 5> v{total(e) + e.damping, e.strain, 0, 0, 0};
    for (int b = 0; b < 2; ++b)
      if (c.bodies[static_cast<size_t>(b)].mass)
        if (const auto p = s.body_pose(b, d.committed_kinematics()))
          for (int k = 0; k < 3; ++k)
            v[static_cast<size_t>(2 + k)] += c.bodies[static_cast<size_t>(b)].mass->mass * p->velocity[k];
    v = sum(v);
    return Now{v[0], v[1], {v[2], v[3], v[4]}};
  };
  const Now start = now();
  const bool falls = c.bodies[0].mass->weight;
  const double size = falls ? 9.80665 * 1000 : start.total;  // J
  Outcome out;
  integrate(d, c.dynamics.duration, 0.15, [&](const StepInfo& i) {
    const Now n = now();
    out.energy = std::max(out.energy, std::abs(n.total - start.total) / size);
    out.strain = std::max(out.strain, n.strain / size);
    if (!falls) out.momentum = std::max(out.momentum, (n.momentum - start.momentum).norm() / 1000);
    ++out.steps;
    out.touching += n.strain > 1e-3 * size;
    out.rejected += i.rejected;
  });
  for (int b = 0; b < 2; ++b) {
    const auto p = s.body_pose(b, d.committed_kinematics());
    for (int k = 0; k < 7; ++k)
      out.poses.push_back(!p || !c.bodies[static_cast<size_t>(b)].mass ? 0
                          : k < 3                                      ? p->position[k]
                                                                       : p->rotation.coeffs()[k - 3]);
  }
  out.poses = sum(out.poses);
  return out;
}

TEST(BodyImpact, EnergyComesBackAtDefaultSteps) {
  const SphereShape ball{{0, 0, 0}, 1};
  const BoxShape box{{0, 0, 0}, {2, 2, 2}};
  const CapsuleShape bar{{0, -1, 0}, {0, 1, 0}, 1}, upright{{0, 0, -1}, {0, 0, 1}, 1};
  const std::pair<const char*, model::Case> cases[] = {
      {"balls head on", two(ball, ball, StiffnessBasis::per_point, {2.1, 0, 0})},
      {"balls, aside", two(ball, ball, StiffnessBasis::per_point, {2.1, 0.3, 0})},
      {"corners", two(box, box, StiffnessBasis::per_point, {2.1, 0.3, 0.2})},
      {"edges", two(box, box, StiffnessBasis::per_length, {2.1, 0.3, 0.2})},
      {"faces", two(box, box, StiffnessBasis::per_area, {2.1, 0, 0})},
      {"bars", two(bar, upright, StiffnessBasis::per_length, {2.1, 0.1, 0.1})},
      {"a box on the floor", falling()}};
  for (const auto& [name, c] : cases) {
    int rank = 0, ranks = 1;
    MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
    MPI_Comm_size(PETSC_COMM_WORLD, &ranks);
    const Outcome one = impact_event(PETSC_COMM_SELF, c);
    const Outcome all = ranks > 1 ? impact_event(PETSC_COMM_WORLD, c) : one;
    if (rank == 0)
      printf(
          "%s: %d steps, %d in touch, %d taken again; %.0f %% of the energy in the contact, %.2f %% off; "
          "momentum %.1e\n",
          name, one.steps, one.touching, one.rejected, 100 * one.strain, 100 * one.energy, one.momentum);
    EXPECT_GT(one.strain, 0.5) << name;
    EXPECT_LT(one.energy, 0.01) << name;
    EXPECT_LT(one.momentum, 1e-8) << name;
    EXPECT_GE(one.touching, 10) << name;
    EXPECT_LE(one.rejected, 0.1 * one.steps + 5) << name;
    EXPECT_EQ(one.steps, all.steps) << name;
    for (size_t i = 0; i < one.poses.size(); ++i) EXPECT_NEAR(one.poses[i], all.poses[i], 1e-9) << name;
  }
}

// Two boxes with flush sides: no corner or edge of one enters the other, so contact does not act. The run
// ends with an error that names both volumes.
TEST(BodyImpact, WhatNothingSeesEndsTheRun) {
  const BoxShape box{{0, 0, 0}, {2, 2, 2}};
  for (const StiffnessBasis basis : {StiffnessBasis::per_point, StiffnessBasis::per_length})
    for (const bool swapped : {false, true}) {
      model::Case c = two(box, box, basis, {2.1, 0, 0});
      if (swapped) std::swap(c.volumes[0], c.volumes[1]);
      std::string what;
      try {
        impact_event(PETSC_COMM_WORLD, c);
      } catch (const SolveError& e) {
        what = e.what();
      }
      EXPECT_NE(what.find("volume a of body A"), std::string::npos) << what;
      EXPECT_NE(what.find("volume b of body B"), std::string::npos) << what;
      EXPECT_NE(what.find("m, but their contact points (corners and edges) penetrate by 0 m"),
                std::string::npos)
          << what;
      // The error comes soon: the boxes touch at 0.067 s and move 1.5 cm in 10 ms.
      EXPECT_LT(what.empty() ? 1 : std::stod(what.substr(what.find("t = ") + 4)), 0.1) << what;
    }
}

// Statics reports the overlap of such boxes as well.
TEST(BodyImpact, WhatNothingSeesEndsStatics) {
  const BoxShape box{{0, 0, 0}, {2, 2, 2}};
  for (const double apart : {1.9, 2.1}) {
    model::Case c = two(box, box, StiffnessBasis::per_length, {apart, 0, 0});
    c.statics.enabled = true;
    for (model::Body& b : c.bodies) {
      b.mass->stiffness = Vec3(1e3, 1e3, 1e3);
      b.mass->velocity.setZero();
    }
    const auto volumes = run::load_volumes(c);
    run::Simulation s(PETSC_COMM_WORLD, c, run::surfaces(volumes), run::skeletons(c, volumes));
    std::string what;
    try {
      s.solve_statics();
    } catch (const SolveError& e) {
      what = e.what();
    }
    if (apart > 2)
      EXPECT_EQ(what, "");
    else
      EXPECT_NE(what.find("overlap by 0.1 m"), std::string::npos) << what;
  }
}

// Nearly flush boxes collide and slide over each other while the contact of their edges changes. The energy
// is conserved, and the boxes separate on the sides from which they came.
TEST(BodyImpact, WhatWasMetIsNotForgotten) {
  const BoxShape box{{0, 0, 0}, {1.4, 1.4, 1.4}};
  model::Case c = two(box, box, StiffnessBasis::per_length, {1.5, 0.16, -0.02});
  c.bodies[0].mass->velocity = Vec3(3, 0, 0);
  c.bodies[1].mass->mass = 1000;
  c.bodies[1].mass->velocity = Vec3(-2, -1.94, 1.11);
  c.bodies[1].rotation = Vec3(-0.22, 0.23, 0.62) * M_PI / 180;
  c.dynamics.duration = 0.4;
  const Outcome out = impact_event(PETSC_COMM_WORLD, c);
  EXPECT_GT(out.touching, 10);
  EXPECT_LT(out.energy, 0.01);
  EXPECT_LT(out.poses[0], 1.4);  // they separate on the sides from which they came
  EXPECT_GT(out.poses[7] - out.poses[0], 1);
}

}  // namespace
}  // namespace hawser::test::body_impact
