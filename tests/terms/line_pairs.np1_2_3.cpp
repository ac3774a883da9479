// Contact of lines with lines on several ranks: residual, energy, history and what goes on from it equal
// those on one rank, which every rank computes for itself.
#include "terms/line_pairs_cases.hpp"

namespace hawser::test {
namespace {

double sum(double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return x;
}

TEST(LinePairsRanks, SameAsOnOne) {
  for (const PairCase& c : pair_cases()) {
    PairModel all(c, PETSC_COMM_WORLD), one(c);
    const LocalMesh &a = all.system->mesh(), &b = one.system->mesh();
    const double h = one.trial.h;
    const State end_a = state_of(a, all.trial), end_b = state_of(b, one.trial);
    const auto fa = residual(*all.system, end_a, h), fb = residual(*one.system, end_b, h);
    double size = 0;
    for (double x : fb) size = std::max(size, std::abs(x));
    for (int n = 0; n < a.owned; ++n)
      for (int k = 0; k <= a.rotates(n); ++k)
        for (size_t r = 0; r < 3; ++r) {
          const int g = a.global[static_cast<size_t>(n)];
          EXPECT_NEAR(fa[3 * static_cast<size_t>(a.block[static_cast<size_t>(n)] + k) + r],
                      fb[3 * static_cast<size_t>(b.block[static_cast<size_t>(g)] + k) + r], 1e-12 * size)
              << c.name << ", node " << g;
        }
    double na = 0, nb = 0;
    const MatHandle Ja = tangent(*all.system, all.trial, {1, 3, 7, 0, 0});
    const MatHandle Jb = tangent(*one.system, one.trial, {1, 3, 7, 0, 0});
    check(MatNorm(Ja.get(), NORM_FROBENIUS, &na));
    check(MatNorm(Jb.get(), NORM_FROBENIUS, &nb));
    EXPECT_NEAR(na, nb, 1e-12 * nb) << c.name;

    all.system->commit(end_a.view(h)), one.system->commit(end_b.view(h));
    const Energy x = all.contact->energy(end_a.view(h)), y = one.contact->energy(end_b.view(h));
    for (const auto part : {&Energy::strain, &Energy::friction, &Energy::damping})
      EXPECT_NEAR(sum(x.*part), y.*part, 1e-12 * (std::abs(y.*part) + y.strain)) << c.name;
    EXPECT_EQ(sum(all.contact->touching()), one.contact->touching()) << c.name;
    EXPECT_NEAR(sum(all.contact->normal_force()), one.contact->normal_force(), 1e-12 * size) << c.name;

    // Each rank goes on from the records of its own nodes.
    const auto whole = one.contact->save();
    PairModel again(c, PETSC_COMM_WORLD);
    std::vector<HistoryRecord> records;
    for (const HistoryRecord& r : whole)
      if (std::find(a.global.begin(), a.global.begin() + a.owned, r.node) != a.global.begin() + a.owned)
        records.push_back(r);
    again.contact->restore(records);
    for (PairModel* m : {&all, &again}) {
      m->trial.from = end_a;
      for (double& u : m->trial.u) u *= 0.1;
      m->system->couple(end_a.view(h), h);
      m->system->prepare(end_a.view(h), h);
    }
    const State next = state_of(a, all.trial);
    EXPECT_EQ(residual(*all.system, next, h), residual(*again.system, next, h)) << c.name;
  }
}

}  // namespace
}  // namespace hawser::test
