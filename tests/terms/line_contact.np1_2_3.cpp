// Contact along elements on several ranks: residual, tangent, energy and history of every case equal those on
// one rank, which every rank computes by itself.
#include "terms/line_contact_cases.hpp"
#include "terms/whole_model.hpp"

namespace hawser::test::line_contact {
namespace {

TEST(LineContactRanks, SameAsOnOne) {
  for (const LineCase& c : line_cases()) {
    LineModel all(c, PETSC_COMM_WORLD);
    LineModel one(c);
    expect_same_on_ranks(all, one, {&Energy::strain, &Energy::friction, &Energy::damping, &Energy::work},
                         1e-13, c.name);
    const LocalMesh& a = all.system->mesh();
    const double h = one.trial.h;
    const State end_a = state_of(a, all.trial);
    const auto mine = all.contact->save();
    const auto whole = one.contact->save();
    EXPECT_EQ(over_ranks(static_cast<double>(mine.size())), static_cast<double>(whole.size())) << c.name;
    for (const CheckpointRecord& r : mine)
      EXPECT_TRUE(std::any_of(whole.begin(), whole.end(),
                              [&](const CheckpointRecord& o) {
                                return o.node == r.node && o.kind == r.kind && o.key == r.key &&
                                       o.values == r.values;
                              }))
          << c.name << ", node " << r.node << ", key " << r.key;

    // Each rank continues from the records of its own nodes.
    LineModel again(c, PETSC_COMM_WORLD);
    std::vector<CheckpointRecord> records;
    for (const CheckpointRecord& r : whole)
      if (std::find(a.global.begin(), a.global.begin() + a.owned, r.node) != a.global.begin() + a.owned)
        records.push_back(r);
    again.contact->restore(records);
    for (LineModel* m : {&all, &again}) {
      m->trial.from = end_a;
      for (double& u : m->trial.u) u *= 0.1;
      m->system->prepare(end_a.after_step(h), h);
    }
    const State next = state_of(a, all.trial);
    EXPECT_EQ(residual(*all.system, next, h), residual(*again.system, next, h)) << c.name;
  }
}

}  // namespace
}  // namespace hawser::test::line_contact
