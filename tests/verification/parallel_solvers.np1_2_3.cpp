// Partition of lines between ranks and the direct solver this selects; solutions are those of one rank.
#include <limits>

#include "hawser/base/mpi.hpp"
#include "hawser/run/node_owners.hpp"
#include "hawser/solve/interface_parts.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "hawser/solve/lu.hpp"
#include "hawser/solve/substructure.hpp"
#include "verification/line_pairs_rig.hpp"

namespace hawser::test::parallel_solvers {
namespace {

// One line wound in turns that nearly touch.
model::Case coil() {
  constexpr int elements = 90, turn = 15;
  model::Case c;
  c.environment.gravity = 9.81;
  model::LineType type = beam_type(1e6, 1e3, 1e3, 5);
  c.line_types = {type};
  model::Line l;
  l.name = "coil";
  for (int k = 0; k <= elements; ++k) {
    const double a = 2 * M_PI * k / turn;
    l.points.push_back({std::cos(a), std::sin(a), 0.105 * k / turn});
  }
  l.start = model::Start::points;
  l.sections.push_back({type.name, elements * (l.points[1] - l.points[0]).norm(), elements, 1});
  l.end_a = anchor(l.points.front());
  c.lines.push_back(l);
  touch(c, 1e7, 1e-3);
  c.dynamics.duration = 1;
  return c;
}

// Parallel lines, so many that the cut through all of them is long, although no line is near itself.
model::Case mat() {
  model::Case c;
  model::LineType type = beam_type(1e6, 1e3, 1e3, 5);
  c.line_types = {type};
  for (int i = 0; i < 40; ++i) {
    const Vec3 from(0, 0.105 * i, 0);
    c.lines.push_back(straight_line("line" + std::to_string(i), type.name, 40, 40, anchor(from),
                                    anchor(from + Vec3(40, 0, 0))));
  }
  touch(c, 1e7, 1e-3);
  c.dynamics.duration = 1;
  return c;
}

// Long parallel lines, two of which cross.
model::Case farm(int lines) {
  model::Case c;
  model::LineType type = beam_type(1e6, 1e3, 1e3, 5);
  c.line_types = {type};
  for (int i = 0; i < lines; ++i) {
    const bool across = i == 1;
    const Vec3 from = across ? Vec3(10, -10, 0.105) : Vec3(0, 10.0 * i, 0);
    const Vec3 to = from + (across ? Vec3(0, 40, 0) : Vec3(40, 0, 0));
    c.lines.push_back(straight_line("line" + std::to_string(i), type.name, 40, 40, anchor(from), anchor(to)));
  }
  touch(c, 1e7, 1e-3);
  c.contact.between_lines.self = false;
  c.dynamics.duration = 1;
  return c;
}

// Tangent of a step at the start and its solution, by node of the mesh; the right-hand side does not depend
// on the number of ranks.
struct Solved {
  std::string solver;
  std::vector<Vec3> x;
};

template <class Configure>
Solved solve(MPI_Comm comm, const model::Case& c, const Configure& configure) {
  Simulation s(comm, c);
  System& system = s.system();
  if (system.update_couplings(s.state().at_rest(), 0) == CouplingChange::layout_changed)
    system.update_ghosts(s.state());
  EXPECT_TRUE(system.coupled());
  system.prepare(s.state().at_rest(), 0);
  const LocalMesh& m = system.mesh();
  const MatHandle J = system.create_matrix();
  VecHandle b = system.create_vector();
  VecHandle x = system.create_vector();
  const std::vector<double> zero(3 * static_cast<size_t>(m.blocks()), 0);
  Solved out;
  // Two solutions: the second has new values in the same pattern.
  KspHandle ksp;
  check(KSPCreate(comm, ksp.out()));
  for (const double mass : {1.0, 400.0}) {
    Weights w;
    w.M = mass;
    system.tangent(s.state().at_rest(), w, zero, false, J.get());
    PetscScalar* p = nullptr;
    check(VecGetArray(b.get(), &p));
    for (int n = 0; n < m.owned; ++n)
      for (int k = 0; k < (m.rotates(n) ? 6 : 3); ++k)
        p[3 * m.block[static_cast<size_t>(n)] + k] = std::sin(3.7 * m.global[static_cast<size_t>(n)] + k);
    check(VecRestoreArray(b.get(), &p));
    check(KSPSetOperators(ksp.get(), J.get(), J.get()));
    if (mass == 1) configure(ksp.get(), system);
    check(KSPSolve(ksp.get(), b.get(), x.get()));
  }
  PC pc = nullptr;
  check(KSPGetPC(ksp.get(), &pc));
  PCType type = nullptr;
  check(PCGetType(pc, &type));
  out.solver = type;
  const char* name = nullptr;
  if (out.solver == PCSHELL) {
    check(PCShellGetName(pc, &name));
    out.solver = name;
  }
  std::vector<double> all(3 * static_cast<size_t>(m.mesh->nodes()), 0);
  std::vector<double> local;
  system.gather_with_ghosts(x.get(), local);
  for (int n = 0; n < m.owned; ++n)
    for (size_t k = 0; k < 3; ++k)
      all[3 * static_cast<size_t>(m.global[static_cast<size_t>(n)]) + k] =
          local[3 * static_cast<size_t>(m.block[static_cast<size_t>(n)]) + k];
  MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_SUM, comm);
  for (size_t i = 0; i < all.size(); i += 3) out.x.emplace_back(all[i], all[i + 1], all[i + 2]);
  return out;
}

double difference(const Solved& a, const Solved& b) {
  double most = 0, size = 0;
  for (size_t i = 0; i < a.x.size(); ++i) {
    most = std::max(most, (a.x[i] - b.x[i]).norm());
    size = std::max(size, b.x[i].norm());
  }
  return most / size;
}

void configured(KSP ksp, const System& system) { configure_linear_solver(ksp, system, "verification_"); }
void substructured(KSP ksp, const System&) {
  PC pc = nullptr;
  check(KSPSetType(ksp, KSPPREONLY));
  check(KSPGetPC(ksp, &pc));
  use_substructuring(pc, MatrixPattern::coupled, std::numeric_limits<int>::max());
}

class ParallelSolvers : public ::testing::Test {
 protected:
  void SetUp() override { MPI_Comm_size(PETSC_COMM_WORLD, &ranks_); }
  std::string expected(const char* several) const { return ranks_ == 1 ? "LU of nonzero blocks" : several; }
  int ranks_ = 1;
};

// A long and two short lines. A line that may touch itself is not cut; here it is longer than a rank's share
// and has a rank of its own.
TEST_F(ParallelSolvers, ALineThatMayTouchItselfIsNotCut) {
  model::Case c = one_line(cable_type(1e6, 1), 100, 100, anchor({0, 0, 0}), anchor({100, 0, 0}));
  for (const double y : {50.0, 100.0}) {
    model::Line l = c.lines[0];
    l.name = y < 60 ? "short" : "other";
    l.sections[0].length = l.sections[0].elements = 20;
    l.end_a = anchor({0, y, 0});
    l.end_b = anchor({20, y, 0});
    c.lines.push_back(l);
  }
  const auto shared_out = [&c](int ranks) {
    const Simulation one(PETSC_COMM_SELF, c);
    return run::node_owners(PETSC_COMM_SELF, c, one.mesh(), one.bodies(), ranks).of_nodes();
  };
  const auto whole = [](const std::vector<int>& owner) {
    return std::count(owner.begin(), owner.begin() + 101, owner[0]) == 101;
  };
  for (const int ranks : {2, 3, 8}) {
    const std::vector<int> owner = shared_out(ranks);
    EXPECT_TRUE(whole(owner)) << ranks;
    EXPECT_EQ(std::count(owner.begin(), owner.end(), owner[0]), 101) << ranks;
  }
  c.contact.between_lines.self = false;
  EXPECT_FALSE(whole(shared_out(2)));
  // A line shorter than a rank's share has a rank together with others.
  c.contact.between_lines.self = true;
  const model::Line coil = c.lines[0];
  const model::Line other = c.lines[1];
  c.lines = {coil, other, other, other, other, other};
  EXPECT_TRUE(whole(shared_out(2)));
}

// An uncut line is solved by one rank, so the solution is the same to the last bit.
TEST_F(ParallelSolvers, ACoilIsNotCut) {
  const Solved one = solve(PETSC_COMM_SELF, coil(), configured);
  const Solved all = solve(PETSC_COMM_WORLD, coil(), configured);
  EXPECT_EQ(all.solver, expected("lines cut between ranks"));
  EXPECT_EQ(difference(all, one), 0);
}

TEST_F(ParallelSolvers, LinesThatHardlyTouchAreCut) {
  const Solved one = solve(PETSC_COMM_SELF, farm(5), configured);
  const Solved all = solve(PETSC_COMM_WORLD, farm(5), configured);
  EXPECT_EQ(all.solver, expected("lines cut between ranks"));
  EXPECT_LT(difference(all, one), 1e-10);
  EXPECT_EQ(difference(all, one) > 0, ranks_ > 1);
}

TEST_F(ParallelSolvers, WhereManyTouchAcrossTheCutMumpsSolves) {
  const Solved one = solve(PETSC_COMM_SELF, mat(), configured);
  const Solved all = solve(PETSC_COMM_WORLD, mat(), configured);
  if (ranks_ > 1) {
    EXPECT_EQ(all.solver, "MUMPS, as the cuts are long");
  }
  EXPECT_LT(difference(all, one), 1e-10);
  if (ranks_ > 1) {
    EXPECT_LT(difference(solve(PETSC_COMM_WORLD, mat(), substructured), one), 1e-8);
  }
}

// Residual of a solution with all stored blocks of the matrix.
double residual_of(KSP ksp, Mat A) {
  VecHandle b, x, r;
  check(MatCreateVecs(A, x.out(), b.out()));
  check(VecDuplicate(b.get(), r.out()));
  check(VecSet(b.get(), 1));
  check(KSPSetOperators(ksp, A, A));
  check(KSPSolve(ksp, b.get(), x.get()));
  check(MatMult(A, x.get(), r.get()));
  check(VecAXPY(r.get(), -1, b.get()));
  PetscReal norm = 0;
  check(VecNorm(r.get(), NORM_INFINITY, &norm));
  return norm;
}

// Parallel chains without contact; every rank has a piece of each. Rows are ordered by rank, chain, position.
MatHandle chains_cut_by_all(int chains, int stretch) {
  const int ranks = ranks_of(PETSC_COMM_WORLD);
  const int rank = rank_of(PETSC_COMM_WORLD);
  const int mine = chains * stretch;
  const auto number = [=](int chain, int k) {
    return static_cast<PetscInt>((k / stretch) * mine + chain * stretch + k % stretch);
  };
  MatHandle A;
  check(MatCreateBAIJ(PETSC_COMM_WORLD, 3, 3 * mine, 3 * mine, PETSC_DETERMINE, PETSC_DETERMINE, 3, nullptr,
                      1, nullptr, A.out()));
  for (int chain = 0; chain < chains; ++chain)
    for (int k = rank * stretch; k < (rank + 1) * stretch; ++k)
      for (int other = std::max(0, k - 1); other <= std::min(ranks * stretch - 1, k + 1); ++other) {
        double block[9];
        for (int c = 0; c < 9; ++c)
          block[c] =
              k == other ? (c % 4 == 0 ? 3.0 + 0.01 * chain : 0.2) : -std::cos(chain + k + 2.0 * other + c);
        const PetscInt row = number(chain, k);
        const PetscInt column = number(chain, other);
        check(MatSetValuesBlocked(A.get(), 1, &row, 1, &column, block, INSERT_VALUES));
      }
  check(MatAssemblyBegin(A.get(), MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(A.get(), MAT_FINAL_ASSEMBLY));
  return A;
}

// The shared unknowns exceed the limit of one dense system, but each chain is a small system of its own.
TEST_F(ParallelSolvers, ChainsThatDoNotTouchAreSolvedEachForItself) {
  if (ranks_ == 1) return;
  constexpr int kChains = 90;
  const MatHandle A = chains_cut_by_all(kChains, 4);
  const InterfaceParts interface(A.get());
  EXPECT_EQ(interface.largest(), 6 * (ranks_ - 1));
  EXPECT_EQ(interface.parts().size(), kChains);
  for (const InterfacePart& part : interface.parts()) EXPECT_EQ(part.rows.size(), 4);
  int solved = static_cast<int>(interface.solved().size());
  EXPECT_EQ(all_reduce(PETSC_COMM_WORLD, MPI_SUM, solved), kChains);
  EXPECT_GT(6 * kChains, kMaxShared);
  for (const int most : {kMaxShared, 0}) {
    KspHandle ksp;
    PC pc = nullptr;
    check(KSPCreate(PETSC_COMM_WORLD, ksp.out()));
    check(KSPSetType(ksp.get(), KSPPREONLY));
    check(KSPGetPC(ksp.get(), &pc));
    use_substructuring(pc, MatrixPattern::chains, most);
    EXPECT_LT(residual_of(ksp.get(), A.get()), 1e-12);
    const char* name = nullptr;
    check(PCShellGetName(pc, &name));
    EXPECT_STREQ(name, most ? "lines cut between ranks" : "MUMPS, as the cuts are long");
  }
}

// All blocks are in the pattern and off-diagonal blocks are zero at first; then more of them become nonzero,
// then fewer; finally a matrix of another pattern.
TEST_F(ParallelSolvers, BlocksComeIntoUseAndGoOutOfIt) {
  const auto matrix = [](PetscInt n) {
    MatHandle A;
    check(MatCreateSeqBAIJ(PETSC_COMM_SELF, 3, 3 * n, 3 * n, n, nullptr, A.out()));
    return A;
  };
  const auto put = [](Mat A, PetscInt i, PetscInt j, double size) {
    double block[9];
    for (int k = 0; k < 9; ++k) block[k] = size * (k % 4 == 0 ? 4 : std::sin(k + i + 2.0 * j));
    check(MatSetValuesBlocked(A, 1, &i, 1, &j, block, INSERT_VALUES));
  };
  const auto done = [](Mat A) {
    check(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
  };
  KspHandle ksp;
  PC pc = nullptr;
  check(KSPCreate(PETSC_COMM_SELF, ksp.out()));
  check(KSPSetType(ksp.get(), KSPPREONLY));
  check(KSPGetPC(ksp.get(), &pc));
  use_lu(pc, MatrixPattern::coupled);

  const MatHandle A = matrix(5);
  for (PetscInt i = 0; i < 5; ++i)
    for (PetscInt j = 0; j < 5; ++j) put(A.get(), i, j, i == j ? 2 : 0);
  for (const double beside : {0.0, 0.3, 0.7}) {
    for (PetscInt i = 0; i < 4; ++i) {
      put(A.get(), i, i + 1, beside);
      put(A.get(), i + 1, i, -beside);
    }
    done(A.get());
    EXPECT_LT(residual_of(ksp.get(), A.get()), 1e-13) << beside;
  }
  for (const double corner : {0.5, 0.0}) {
    put(A.get(), 0, 4, corner);
    put(A.get(), 3, 1, corner);
    done(A.get());
    EXPECT_LT(residual_of(ksp.get(), A.get()), 1e-13) << corner;
  }
  check(KSPReset(ksp.get()));
  const MatHandle B = matrix(7);
  for (PetscInt i = 0; i < 7; ++i) {
    put(B.get(), i, i, 2);
    put(B.get(), i, (3 * i + 1) % 7, 0.4);
  }
  done(B.get());
  EXPECT_LT(residual_of(ksp.get(), B.get()), 1e-13);
}

}  // namespace
}  // namespace hawser::test::parallel_solvers
