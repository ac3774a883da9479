// Contact between lines: tangents equal finite differences in every state, `evaluate` is repeatable, forces
// rotate with the model and sum to zero, and the history is restored from a checkpoint.
#include "terms/line_pairs_cases.hpp"
#include "terms/whole_model.hpp"

namespace hawser::test::line_pairs_test {
namespace {

TEST(LinePairs, Tangents) {
  for (const PairCase& c : pair_cases()) {
    PairModel m(c);
    expect_tangent(*m.system, m.trial, "line on line, " + c.name);
  }
}

TEST(LinePairs, TouchWhereTheCaseHasIt) {
  for (const PairCase& c : pair_cases()) {
    PairModel m(c);
    const State end = state_of(m.system->mesh(), m.trial);
    m.system->commit(end.after_step(m.trial.h));
    EXPECT_EQ(m.contact->active_count() > 0, c.gap < 1e-3) << c.name;
    if (c.gap < 0) {
      EXPECT_GT(m.contact->normal_force(), 5) << c.name;
    }
    const double ratio = m.contact->friction_force() / std::max(m.contact->normal_force(), 1e-9);
    if (c.friction > 0 && c.slip > 0.01) {
      EXPECT_NEAR(ratio, 0.3, 1e-3) << c.name;
    }
    if (c.friction > 0 && c.slip < 1e-3 && c.gap < 0) {
      EXPECT_LT(ratio, 0.2) << c.name;
    }
  }
}

TEST(LinePairs, EvaluatingLeavesNoTrace) {
  for (const PairCase& c : pair_cases()) {
    PairModel m(c);
    const Trial& t = m.trial;
    const LocalMesh& mesh = m.system->mesh();
    const State here = state_of(mesh, t);
    const auto f = residual(*m.system, here, t.h);
    const auto d = direction(*m.system, t, 55);
    for (const double far : {5.0, 500.0})
      residual(*m.system, state_of(mesh, t, far, &d, {1, 1, 1, 0, 0}), t.h);
    EXPECT_EQ(residual(*m.system, here, t.h), f) << c.name;
  }
}

TEST(LinePairs, TurnsWithTheModel) {
  const Placement at{exp_so3({0.9, -1.3, 0.7}), Vec3(2, -1, 3)};
  for (const PairCase& c : pair_cases()) {
    PairModel m(c);
    PairModel turned(c, PETSC_COMM_SELF, at);
    expect_turned(m, turned, at.rotation, 1e-9, c.name);
  }
}

// The forces between lines sum to zero. Cables have no sections that could carry the moment of friction, so
// moments are checked here without friction only; tests/unit/line_pair.cpp checks those of two beams with
// friction.
TEST(LinePairs, ForcesBalance) {
  for (const PairCase& c : pair_cases()) {
    PairModel m(c);
    const LocalMesh& mesh = m.system->mesh();
    const State end = state_of(mesh, m.trial);
    const auto f = residual(*m.system, end, m.trial.h);
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    double size = 0;
    for (int n = 0; n < mesh.owned; ++n) {
      const size_t i = static_cast<size_t>(n);
      const size_t b = 3 * static_cast<size_t>(mesh.block[i]);
      const Eigen::Map<const Vec3> a(f.data() + b);
      force += a;
      moment += end.x[i].cross(a);
      size += a.norm();
      if (mesh.rotates(n)) moment += end.q[i] * Eigen::Map<const Vec3>(f.data() + b + 3);
    }
    EXPECT_LE(force.norm(), 1e-12 * size) << c.name;
    if (c.friction == 0) {
      EXPECT_LE(moment.norm(), 1e-11 * size) << c.name;
    }
  }
}

TEST(LinePairs, HistoryGoesThroughACheckpoint) {
  for (const PairCase& c : pair_cases()) {
    PairModel m(c);
    PairModel copy(c);
    const double h = m.trial.h;
    const State end = state_of(m.system->mesh(), m.trial);
    m.system->commit(end.after_step(h));
    auto records = m.contact->save();
    std::reverse(records.begin(), records.end());
    copy.contact->restore(records);
    for (PairModel* one : {&m, &copy}) {
      one->trial.from = end;
      for (double& u : one->trial.u) u *= 0.1;
      one->system->update_couplings(end.after_step(h), h);
      one->system->prepare(end.after_step(h), h);
    }
    EXPECT_EQ(copy.contact->energy(end.after_step(h)).strain, m.contact->energy(end.after_step(h)).strain);
    EXPECT_EQ(copy.contact->energy(end.after_step(h)).friction,
              m.contact->energy(end.after_step(h)).friction);
    EXPECT_EQ(copy.contact->deepest().depth, m.contact->deepest().depth);
    const State next = state_of(m.system->mesh(), m.trial);
    EXPECT_EQ(residual(*m.system, next, h), residual(*copy.system, next, h)) << c.name;
  }
}

// Lines with a penetration of 0.4 of their radii that pass through each other in a step: the advice names the
// lines, and the pair if the pair has settings of its own.
TEST(LinePairs, AdviceNamesTheLines) {
  for (const bool tuned : {false, true}) {
    PairModel m({.name = "through", .angle = 1.3, .gap = -0.35, .before = -0.08, .tuned = tuned});
    m.mesh.line_names = {};
    for (const char* name : {"hose", "rope"}) m.mesh.line_names.push_back(name);
    const double h = m.trial.h;
    const State& start = m.trial.from;
    const State end = state_of(m.system->mesh(), m.trial);
    m.system->update_couplings(straight_path(m.system->mesh(), start, end, h).after_step(h), h);
    m.system->prepare(start.after_step(h), h);
    const std::string message = advice::clause(m.contact->check_step(end.after_step(h)).because);
    const std::string advice = "Try contact: {between_lines: {";
    EXPECT_NE(message.find(advice + (tuned ? "pairs: [{lines: [hose, rope], normal_stiffness: {per_length: "
                                           : "normal_s")),
              std::string::npos)
        << message;
  }
}

}  // namespace
}  // namespace hawser::test::line_pairs_test
