// The symmetric part of a tangent whose rows are distributed over ranks, and the number of its negative
// eigenvalues.
#include "hawser/solve/stability.hpp"

#include <gtest/gtest.h>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::test::stability {
namespace {

// A straight beam between ends 100 m apart, in tension or compression, in a current, whose drag has an
// unsymmetric tangent.
model::Case beam(const char* length) {
  return io::read_case_text(std::string(R"(hawser: 1
environment: {water: {depth: 200}, current: {speed: 2, direction_deg: 60}}
line_types: {pipe: {outer_diameter: 0.3, mass_per_length: 90, EA: 1e8, EI: 1e6, GJ: 1e6}}
lines:
  pipe:
    sections: [{type: pipe, length: )") +
                                length + R"(, elements: 60}]
    end_a: {anchor: [0, 0, -20]}
    end_b: {anchor: [100, 0, -20]}
    start: straight
contact: {between_lines: false}
)",
                            "stability.yaml");
}

struct Tangent {
  Tangent(MPI_Comm comm, const model::Case& c) : sim(comm, c), J(sim.system().create_matrix()) {
    const Kinematics at = sim.state().at_rest();
    const std::vector<double> zero(3 * static_cast<size_t>(sim.local().blocks()), 0);
    const VecHandle r = sim.system().create_vector();
    sim.system().prepare(at, 0);
    sim.system().residual(at, r.get());
    sim.system().tangent(at, {}, zero, false, J.get());
  }
  run::Simulation sim;
  MatHandle J;
};

double mallocs(Mat a) {
  MatInfo info;
  check(MatGetInfo(a, MAT_GLOBAL_MAX, &info));
  return info.mallocs;
}

double norm(Vec v) {
  PetscReal size = 0;
  check(VecNorm(v, NORM_2, &size));
  return size;
}

// A row of a beam has six blocks. A preallocation of fewer makes PETSc move the whole matrix again and again.
TEST(Stability, SymmetricPartHasThePatternOfTheTangent) {
  Tangent t(PETSC_COMM_WORLD, beam("99.9"));
  const MatHandle blocks = symmetric_blocks(t.J.get());
  const MatHandle rows = symmetric_part(t.J.get());
  EXPECT_EQ(mallocs(blocks.get()), 0);
  EXPECT_EQ(mallocs(rows.get()), 0);
  VecHandle x = t.sim.system().create_vector();
  VecHandle y;
  VecHandle z;
  VecHandle s;
  for (VecHandle* v : {&y, &z, &s}) check(VecDuplicate(x.get(), v->out()));
  check(VecSetRandom(x.get(), nullptr));
  check(MatMult(t.J.get(), x.get(), y.get()));
  check(MatMultTranspose(t.J.get(), x.get(), z.get()));
  check(VecAXPY(z.get(), -1, y.get()));
  EXPECT_GT(norm(z.get()), 1e-9 * norm(y.get())) << "the tangent should not be symmetric";
  check(VecAXPY(y.get(), 0.5, z.get()));  // (J + J') x / 2
  for (const MatHandle* m : {&blocks, &rows}) {
    check(MatMult(m->get(), x.get(), s.get()));
    check(VecAXPY(s.get(), -1, y.get()));
    EXPECT_LE(norm(s.get()), 1e-13 * norm(y.get()));
  }
}

// The number of negative eigenvalues, computed with and without the attempt at a Cholesky factorisation, is
// the same on all ranks and on one.
TEST(Stability, NegativeEigenvaluesAreTheSameOnAllRanks) {
  for (const char* length : {"99.9", "101"}) {
    const model::Case c = beam(length);
    Tangent all(PETSC_COMM_WORLD, c);
    Tangent one(PETSC_COMM_SELF, c);
    const int negative = negative_eigenvalues(one.J.get());
    EXPECT_EQ(negative > 0, std::string(length) == "101");
    EXPECT_EQ(negative_eigenvalues(one.J.get(), MatrixPattern::chains), negative);
    EXPECT_EQ(negative_eigenvalues(all.J.get()), negative);
    EXPECT_EQ(negative_eigenvalues(all.J.get(), MatrixPattern::chains), negative);
  }
}

}  // namespace
}  // namespace hawser::test::stability
