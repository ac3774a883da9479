// Which direct solver several ranks use, and that its answers are those of one rank.
#include "hawser/solve/gathered_solver.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "hawser/solve/substructure.hpp"
#include "verification/line_pairs_rig.hpp"

namespace hawser::test {
namespace {

// One line, wound in turns that nearly touch.
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

// Long lines side by side, of which two cross.
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
  c.dynamics.duration = 1;
  return c;
}

// The tangent of a step at the start and its solution for a right-hand side that looks the same on any number
// of ranks, by node of the mesh.
struct Solved {
  std::string solver;
  std::vector<Vec3> x;
};

template <class Configure>
Solved solve(MPI_Comm comm, const model::Case& c, const Configure& configure) {
  Simulation s(comm, c);
  System& system = s.system();
  if (system.couple(s.state().view(0), 0) == Coupled::anew) system.spread(s.state());
  EXPECT_TRUE(system.coupled());
  system.prepare(s.state().view(0), 0);
  const LocalMesh& m = system.mesh();
  const MatHandle J = system.create_matrix();
  VecHandle b = system.create_vector(), x = system.create_vector();
  const std::vector<double> zero(3 * static_cast<size_t>(m.blocks()), 0);
  Solved out;
  // Twice, so that the second has new values in an old pattern.
  KspHandle ksp;
  check(KSPCreate(comm, ksp.out()));
  for (const double mass : {1.0, 400.0}) {
    Weights w;
    w.M = mass;
    system.tangent(s.state().view(0), w, zero, false, J.get());
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
  if (out.solver == PCSHELL) {
    const char* name = nullptr;
    check(PCShellGetName(pc, &name));
    out.solver = name;
  }
  std::vector<double> all(3 * m.mesh->nodes.size(), 0), local;
  system.gather(x.get(), local);
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
  for (size_t i = 0; i < a.x.size(); ++i)
    most = std::max(most, (a.x[i] - b.x[i]).norm()), size = std::max(size, b.x[i].norm());
  return most / size;
}

void configured(KSP ksp, const System& system) { configure_linear_solver(ksp, system, "verification_"); }
void gathered(KSP ksp, const System& system) {
  PC pc = nullptr;
  check(KSPSetType(ksp, KSPPREONLY));
  check(KSPGetPC(ksp, &pc));
  use_gathered(pc, system.mesh(), cheapest_order(gather_graph(system)));
}
void substructured(KSP ksp, const System&) {
  PC pc = nullptr;
  check(KSPSetType(ksp, KSPPREONLY));
  check(KSPGetPC(ksp, &pc));
  use_substructuring(pc, cheapest_ordering());
}

class ParallelSolvers : public ::testing::Test {
 protected:
  void SetUp() override { MPI_Comm_size(PETSC_COMM_WORLD, &ranks_); }
  std::string expected(const char* several) const { return ranks_ == 1 ? "lu" : several; }
  int ranks_ = 1;
};

TEST_F(ParallelSolvers, ACoilIsGathered) {
  const Solved one = solve(PETSC_COMM_SELF, coil(), configured);
  const Solved all = solve(PETSC_COMM_WORLD, coil(), configured);
  EXPECT_EQ(all.solver, expected("gathered on every rank"));
  EXPECT_LT(difference(all, one), 1e-10);
  if (ranks_ > 1) {
    EXPECT_LT(difference(solve(PETSC_COMM_WORLD, coil(), substructured), one), 1e-8);
  }
}

// To the last bit the answer of one rank.
TEST_F(ParallelSolvers, SmallModelsAreGathered) {
  const Solved one = solve(PETSC_COMM_SELF, farm(12), configured);
  const Solved all = solve(PETSC_COMM_WORLD, farm(12), configured);
  EXPECT_EQ(all.solver, expected("gathered on every rank"));
  EXPECT_EQ(difference(all, one), 0);
}

TEST_F(ParallelSolvers, LinesThatHardlyTouchAreCut) {
  const Solved one = solve(PETSC_COMM_SELF, farm(30), configured);
  const Solved all = solve(PETSC_COMM_WORLD, farm(30), configured);
  EXPECT_EQ(all.solver, expected("chains cut between ranks"));
  EXPECT_LT(difference(all, one), 1e-10);
  if (ranks_ > 1) {
    EXPECT_LT(difference(solve(PETSC_COMM_WORLD, farm(30), gathered), one), 1e-10);
  }
}

// Numbered as on one rank, whatever the ranks.
TEST_F(ParallelSolvers, TheGatheredGraphIsThatOfOneRank) {
  const auto graph = [](MPI_Comm comm) {
    Simulation s(comm, coil());
    s.system().couple(s.state().view(0), 0);
    return gather_graph(s.system());
  };
  const BlockGraph one = graph(PETSC_COMM_SELF), all = graph(PETSC_COMM_WORLD);
  EXPECT_EQ(one.start, all.start);
  EXPECT_EQ(one.next, all.next);
  EXPECT_GT(one.next.size(), 8U * 182);  // turns see each other
}

}  // namespace
}  // namespace hawser::test
