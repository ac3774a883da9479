// Contact between lines on several ranks: residual, energy, history and the motion after a restart equal
// those on one rank, which every rank computes by itself.
#include "terms/line_pairs_cases.hpp"
#include "terms/whole_model.hpp"

namespace hawser::test::line_pairs {
namespace {

TEST(LinePairsRanks, SameAsOnOne) {
  for (const PairCase& c : pair_cases()) {
    PairModel all(c, PETSC_COMM_WORLD);
    PairModel one(c);
    const double size =
        expect_same_on_ranks(all, one, {&Energy::strain, &Energy::friction, &Energy::damping}, 1e-12, c.name);
    EXPECT_NEAR(over_ranks(all.contact->normal_force()), one.contact->normal_force(), 1e-12 * size) << c.name;

    // Each rank continues from the records of its own nodes.
    const LocalMesh& a = all.system->mesh();
    const double h = one.trial.h;
    const State end_a = state_of(a, all.trial);
    const auto whole = one.contact->save();
    PairModel again(c, PETSC_COMM_WORLD);
    std::vector<CheckpointRecord> records;
    for (const CheckpointRecord& r : whole)
      if (std::find(a.global.begin(), a.global.begin() + a.owned, r.node) != a.global.begin() + a.owned)
        records.push_back(r);
    again.contact->restore(records);
    // The pairs may change after a long step, so their nodes are added to the state.
    const auto goes_on = [&](PairModel& m) {
      State end = end_a;
      if (m.system->update_couplings(end.after_step(h), h) == CouplingChange::layout_changed)
        m.system->update_ghosts(end);
      m.system->prepare(end.after_step(h), h);
      State next = end;
      next.time += h;
      for (size_t n = 0; n < next.x.size(); ++n) next.x[n] += 0.1 * h * end.v[n];
      return residual(*m.system, next, h);
    };
    EXPECT_EQ(goes_on(all), goes_on(again)) << c.name;
  }
}

}  // namespace
}  // namespace hawser::test::line_pairs
