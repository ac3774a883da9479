// The term suite on several ranks: residual, tangent, norms, energy and history of every model equal those of
// the same model on one rank, which every rank computes by itself.
#include "support/taylor_cases.hpp"

namespace hawser::test::suite_ranks {
namespace {

double sum(MPI_Comm comm, double x) {
  MPI_Allreduce(MPI_IN_PLACE, &x, 1, MPI_DOUBLE, MPI_SUM, comm);
  return x;
}

// The 3 x 3 block of the matrix at a row and a column of global blocks.
Mat3 block(Mat J, int row, int column) {
  const PetscInt r[3] = {3 * row, 3 * row + 1, 3 * row + 2};
  const PetscInt c[3] = {3 * column, 3 * column + 1, 3 * column + 2};
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> m;
  check(MatGetValues(J, 3, r, 3, c, m.data()));
  return m;
}

struct Both {
  std::unique_ptr<SuiteModel> all, one;  // on all ranks; on this rank alone
  explicit Both(const SuiteCase& c) : all(c.build(PETSC_COMM_WORLD, {})), one(c.build(PETSC_COMM_SELF, {})) {}
};

TEST(SuiteRanks, ResidualAndTangent) {
  for (const SuiteCase& c : all_cases()) {
    const Both m(c);
    System& all = *m.all->system;
    System& one = *m.one->system;
    const LocalMesh& a = all.mesh();
    const LocalMesh& b = one.mesh();  // node n of `one` is mesh node n
    const double h = m.one->trial.h;
    VecHandle ra = all.create_vector();
    VecHandle rb = one.create_vector();
    all.residual(at_end(state_of(a, m.all->trial), h), ra.get());
    one.residual(at_end(state_of(b, m.one->trial), h), rb.get());
    const auto fa = rows(ra.get());
    const auto fb = rows(rb.get());
    const double size = one.norms(rb.get()).force_scale + one.norms(rb.get()).moment_scale;
    const Weights w{1, 3, 7, 0, 0};
    const MatHandle Ja = tangent(all, m.all->trial, w);
    const MatHandle Jb = tangent(one, m.one->trial, w);
    double na = 0, nb = 0;
    check(MatNorm(Ja.get(), NORM_FROBENIUS, &na));
    check(MatNorm(Jb.get(), NORM_FROBENIUS, &nb));
    EXPECT_NEAR(na, nb, 1e-13 * nb) << c.name;
    const auto blocks = [](const LocalMesh& l, int n) { return l.block[static_cast<size_t>(n)]; };
    const auto global = [](const LocalMesh& l, int block) {
      return l.global_block[static_cast<size_t>(block)];
    };
    int compared = 0;
    for (int n = 0; n < a.owned; ++n) {
      const int g = a.global[static_cast<size_t>(n)];
      for (int k = 0; k <= a.rotates(n); ++k) {
        const size_t i = 3 * static_cast<size_t>(blocks(a, n) + k);
        const size_t j = 3 * static_cast<size_t>(blocks(b, g) + k);
        for (size_t r = 0; r < 3; ++r)
          EXPECT_NEAR(fa[i + r], fb[j + r], 1e-14 * size) << c.name << ", node " << g;
      }
      for (int o = 0; o < a.nodes(); ++o) {
        const int go = a.global[static_cast<size_t>(o)];
        if (std::abs(g - go) > 1 || (g < 4) != (go < 4)) continue;
        for (int k = 0; k <= a.rotates(n); ++k)
          for (int q = 0; q <= a.rotates(o); ++q, ++compared) {
            const Mat3 x = block(Ja.get(), global(a, blocks(a, n) + k), global(a, blocks(a, o) + q));
            const Mat3 y = block(Jb.get(), global(b, blocks(b, g) + k), global(b, blocks(b, go) + q));
            EXPECT_LT((x - y).norm(), 1e-14 * nb) << c.name << ", nodes " << g << " and " << go;
          }
      }
    }
    EXPECT_EQ(sum(PETSC_COMM_WORLD, compared), 40 + 10) << c.name;  // 4 + 6 pairs of beams, of cables
    const ResidualNorms x = all.norms(ra.get());
    const ResidualNorms y = one.norms(rb.get());
    EXPECT_NEAR(x.force, y.force, 1e-13 * size) << c.name;
    EXPECT_NEAR(x.moment, y.moment, 1e-13 * size) << c.name;
  }
}

TEST(SuiteRanks, TangentByDifferences) {
  for (const SuiteCase& c : all_cases()) {
    const auto m = c.build(PETSC_COMM_WORLD, {});
    const Weights w{1, 3, 7, 0, 0};
    const auto d = direction(*m->system, m->trial, 42);
    const auto f = [&](double step) {
      return residual(*m->system, state_of(m->system->mesh(), m->trial, step, &d, w), m->trial.h);
    };
    const auto Jd = multiply(*m->system, tangent(*m->system, m->trial, w).get(), d);
    const auto p = f(0.02);
    const auto q = f(-0.02);
    const auto r = f(0.04);
    const auto s = f(-0.04);
    double off = 0, size = 0;
    for (size_t i = 0; i < Jd.size(); ++i) {
      off += std::pow((8 * (p[i] - q[i]) - (r[i] - s[i])) / 0.24 - Jd[i], 2);
      size += Jd[i] * Jd[i];
    }
    EXPECT_LT(std::sqrt(sum(PETSC_COMM_WORLD, off)), 1e-6 * std::sqrt(sum(PETSC_COMM_WORLD, size))) << c.name;
  }
}

TEST(SuiteRanks, EnergyAndHistory) {
  for (const SuiteCase& c : all_cases()) {
    const Both m(c);
    System& all = *m.all->system;
    System& one = *m.one->system;
    const double h = m.one->trial.h;
    const State end_a = state_of(all.mesh(), m.all->trial);
    const State end_b = state_of(one.mesh(), m.one->trial);
    all.commit(at_end(end_a, h));
    one.commit(at_end(end_b, h));
    const Energy x = all.energy(at_end(end_a, h));
    const Energy y = one.energy(at_end(end_b, h));
    const double size = y.kinetic + y.strain + std::abs(y.potential) + 1;
    for (const auto part : {&Energy::kinetic, &Energy::strain, &Energy::potential, &Energy::friction,
                            &Energy::damping, &Energy::work})
      EXPECT_NEAR(sum(PETSC_COMM_WORLD, x.*part), y.*part, 1e-13 * size) << c.name;
    for (size_t t = 0; t < all.terms().size(); ++t) {
      auto mine = all.terms()[t]->save();
      auto whole = one.terms()[t]->save();
      const auto sums = [](const std::vector<CheckpointRecord>& records) {
        double s = 0;
        for (const auto& r : records)
          for (double v : r.values) s += v;
        return s;
      };
      EXPECT_NEAR(sum(PETSC_COMM_WORLD, sums(mine)), sums(whole), 1e-12 * (1 + std::abs(sums(whole))))
          << c.name;
      const std::string name(all.terms()[t]->checkpoint_key());
      if (name == "structure" || name == "mass" || name == "hydrodynamics")
        continue;            // the sums of a rank, stored at any of its nodes
      if (name == "seabed")  // its sums have the second kind
        for (auto* records : {&mine, &whole})
          std::erase_if(*records, [](const CheckpointRecord& r) { return r.kind == 1; });
      EXPECT_EQ(sum(PETSC_COMM_WORLD, static_cast<double>(mine.size())), static_cast<double>(whole.size()))
          << c.name << ", " << name;
      for (const CheckpointRecord& r : mine) {
        const auto same = std::find_if(whole.begin(), whole.end(), [&](const CheckpointRecord& o) {
          return o.node == r.node && o.kind == r.kind && o.key == r.key;
        });
        EXPECT_TRUE(same != whole.end() && same->values == r.values)
            << c.name << ", " << name << ", node " << r.node;
      }
    }
  }
}

}  // namespace
}  // namespace hawser::test::suite_ranks
