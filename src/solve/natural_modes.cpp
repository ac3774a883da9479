// Stiffness and mass as matrices of free components, and their lowest eigenpairs by shift and invert.
#include "hawser/solve/natural_modes.hpp"

#include <fmt/format.h>
#include <petscmat.h>
#include <slepceps.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/base/gather.hpp"
#include "hawser/base/handle.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "hawser/solve/stability.hpp"

namespace hawser {
namespace {

// Eigenvalues are looked for about this one, omega² of a period of 1000 s below zero: there K - target M is
// regular also where the system can move freely.
constexpr double kTarget = -4e-5;  // rad²/s²
constexpr double kTolerance = 1e-10;
constexpr int kMostEigenIterations = 2000;
constexpr int kMore = 4;       // modes that are looked for beyond those that are wanted
constexpr long kMost = 8;      // times as many at the most
constexpr double kGap = 1e-6;  // of an eigenvalue: those that are nearer to each other are repeated
// Translations, over rotations times the size of the system, below which they are rounding.
constexpr double kInPlace = 1e-7;

class Slepc {
 public:
  Slepc() { check(SlepcInitializeNoArguments()); }  // PETSc is up already, and stays
  ~Slepc() { SlepcFinalize(); }
  Slepc(const Slepc&) = delete;
  Slepc& operator=(const Slepc&) = delete;
};

using Solver = Handle<EPS, EPSDestroy>;

// The symmetric part of a tangent, with `held` on the diagonal of held components, where the tangent has 1.
MatHandle symmetric(System& system, const Kinematics& at, const Weights& weights, double held) {
  const MatHandle J = system.create_matrix();
  const std::vector<double> zero(3 * static_cast<size_t>(system.mesh().blocks()), 0);
  system.tangent(at, weights, zero, false, J.get());
  MatHandle A = symmetric_part(J.get());
  const auto& is_held = system.tied_nodes().held();
  for (int b = 0; b < system.mesh().owned_blocks; ++b)
    for (int c = 0; c < 3; ++c) {
      if (!(is_held[b] >> c & 1)) continue;
      const PetscInt row = 3 * system.mesh().global_block[b] + c;
      check(MatSetValue(A.get(), row, row, held - 1, ADD_VALUES));
    }
  check(MatAssemblyBegin(A.get(), MAT_FINAL_ASSEMBLY));
  check(MatAssemblyEnd(A.get(), MAT_FINAL_ASSEMBLY));
  check(MatSetOption(A.get(), MAT_SYMMETRIC, PETSC_TRUE));
  return A;
}

long free_components(const System& system) {
  long free = 0;
  for (int b = 0; b < system.mesh().owned_blocks; ++b)
    for (int c = 0; c < 3; ++c) free += !(system.tied_nodes().held()[b] >> c & 1);
  MPI_Allreduce(MPI_IN_PLACE, &free, 1, MPI_LONG, MPI_SUM, system.comm());
  return free;
}

// m, of the box about all nodes.
double size_of(const System& system, const Kinematics& at) {
  Vec3 low = Vec3::Constant(HUGE_VAL), high = -low;
  for (size_t n = 0; n < static_cast<size_t>(system.mesh().owned); ++n)
    low = low.cwiseMin(at.x[n]), high = high.cwiseMax(at.x[n]);
  all_reduce(system.comm(), MPI_MIN, low);
  all_reduce(system.comm(), MPI_MAX, high);
  return (high - low).norm();
}

// Of the nodes, by the unknowns: a node that is tied goes with its frame, dx = dX - R hat(y) theta.
void move_nodes(const System& system, const Kinematics& at, const std::vector<double>& u, NaturalMode& mode) {
  const LocalMesh& mesh = system.mesh();
  const auto block = [&](int b) { return Vec3(u.data() + 3 * b); };
  const size_t nodes = mesh.block.size();
  mode.shape.assign(nodes, Vec3::Zero()), mode.rotation.assign(nodes, Vec3::Zero());
  for (size_t n = 0; n < nodes; ++n) {
    mode.shape[n] = block(mesh.block[n]);
    if (mesh.rotates(static_cast<int>(n))) mode.rotation[n] = at.q[n] * block(mesh.block[n] + 1);
  }
  for (const int i : system.tied_nodes().to_frames()) {
    const TiedNode& s = system.tied_nodes().list()[i];
    const int frame = mesh.block[s.frame];
    mode.shape[s.node] = block(frame) + at.q[s.frame] * block(frame + 1).cross(s.at);
  }
  double most[2] = {0, 0};
  for (size_t n = 0; n < static_cast<size_t>(mesh.owned); ++n) {
    most[0] = std::max(most[0], mode.shape[n].norm());
    most[1] = std::max(most[1], mode.rotation[n].norm());
  }
  all_reduce(system.comm(), MPI_MAX, most);
  const bool in_place = most[0] < kInPlace * most[1] * size_of(system, at);
  for (size_t n = 0; n < nodes; ++n) {
    mode.shape[n] = in_place ? Vec3(Vec3::Zero()) : Vec3(mode.shape[n] / most[0]);
    mode.rotation[n] /= in_place ? most[1] : most[0];
  }
}

// Those that converge, of the `count` nearest to the target, lowest first.
std::vector<NaturalMode> nearest_modes(System& system, const Kinematics& at, Mat K, Mat M, int count) {
  Solver solver;
  check(EPSCreate(system.comm(), solver.out()));
  EPS eps = solver.get();
  check(EPSSetOptionsPrefix(eps, "modes_"));
  check(EPSSetOperators(eps, K, M));
  check(EPSSetProblemType(eps, EPS_GHEP));
  check(EPSSetDimensions(eps, count, PETSC_DEFAULT, PETSC_DEFAULT));
  check(EPSSetTolerances(eps, kTolerance, kMostEigenIterations));
  check(EPSSetTarget(eps, kTarget));
  check(EPSSetWhichEigenpairs(eps, EPS_TARGET_MAGNITUDE));
  ST st = nullptr;
  check(EPSGetST(eps, &st));
  check(STSetType(st, STSINVERT));
  KSP ksp = nullptr;
  check(STGetKSP(st, &ksp));
  check(KSPSetType(ksp, KSPPREONLY));
  PC pc = nullptr;
  check(KSPGetPC(ksp, &pc));
  check(PCSetType(pc, PCLU));
  check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
  check(EPSSetFromOptions(eps));
  check(EPSSolve(eps));
  PetscInt found = 0;
  check(EPSGetConverged(eps, &found));
  std::vector<NaturalMode> out;
  const VecHandle u = system.create_vector();
  std::vector<double> local;
  for (PetscInt i = 0; i < found; ++i) {
    NaturalMode mode;
    check(EPSGetEigenpair(eps, i, &mode.squared, nullptr, u.get(), nullptr));
    system.gather(u.get(), local);
    move_nodes(system, at, local, mode);
    out.push_back(std::move(mode));
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const NaturalMode& a, const NaturalMode& b) { return a.squared < b.squared; });
  return out;
}

// How many eigenvalues of K - lambda M lie below `squared`, by Sylvester's law of inertia (Parlett 1980,
// section 3-3); -1: not known.
int eigenvalues_below(Mat K, Mat M, double squared) {
  MatHandle shifted;
  check(MatDuplicate(K, MAT_COPY_VALUES, shifted.out()));
  check(MatAXPY(shifted.get(), -squared, M, DIFFERENT_NONZERO_PATTERN));
  return negative_pivots(shifted.get());
}

// Whether between the target and the first gap behind the `count` lowest of these modes there are no others.
bool complete(Mat K, Mat M, const std::vector<NaturalMode>& modes, size_t count) {
  size_t last = count - 1;
  const auto gap = [&](size_t i) { return modes[i + 1].squared - modes[i].squared; };
  while (last + 1 < modes.size() && !(gap(last) > kGap * std::abs(modes[last + 1].squared))) ++last;
  if (last + 1 >= modes.size()) return false;
  const double end = modes[last].squared + 0.5 * gap(last);
  const auto found = std::count_if(modes.begin(), modes.end(), [&](const NaturalMode& m) {
    return m.squared > kTarget && m.squared < end;
  });
  const int above = eigenvalues_below(K, M, end), below = eigenvalues_below(K, M, kTarget);
  return above < 0 || below < 0 || found >= above - below;
}

}  // namespace

std::vector<NaturalMode> natural_modes(System& system, const Kinematics& at, int count) {
  const Slepc slepc;
  const long free = free_components(system);
  count = static_cast<int>(std::min<long>(count, free));
  if (count == 0) return {};
  // Held components get stiffness 1 and no mass: their eigenvalues are infinite and do not appear among the
  // lowest.
  const MatHandle K = symmetric(system, at, {1, 0, 0}, 1), M = symmetric(system, at, {0, 0, 1}, 0);
  // A Krylov space meets each direction of a repeated eigenvalue, of equal lines, by rounding only: some may
  // be missing at first.
  for (long ask = std::min<long>(count + kMore, free);; ask = std::min(2 * ask, free)) {
    std::vector<NaturalMode> modes = nearest_modes(system, at, K.get(), M.get(), static_cast<int>(ask));
    const size_t wanted = count;
    if (modes.size() < wanted)
      throw SolveError("modes: {} of {} eigenvalues have converged: ask for fewer", modes.size(), count);
    const bool no_more = ask == free || std::ssize(modes) < ask;
    if (!no_more && !complete(K.get(), M.get(), modes, wanted)) {
      if (ask > kMost * (count + kMore))
        throw SolveError("modes: there are more natural frequencies than were found: ask for another number");
      continue;
    }
    modes.resize(wanted);
    return modes;
  }
}

}  // namespace hawser
