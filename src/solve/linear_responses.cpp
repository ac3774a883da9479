// Responses to waves. Each complex unknown and equation is two real ones, one after the other:
//   (a + i b)(x + i y) = f + i g   as   [a -b; b a] (x, y) = (f, g)
#include "hawser/solve/linear_responses.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "hawser/advice/responses.hpp"
#include "hawser/base/error.hpp"
#include "hawser/solve/linear_solver.hpp"
#include "hawser/system/depends_on_frequency.hpp"
#include "small_motions.hpp"

namespace hawser {
namespace {

// Calls f(row, columns, values) for each row of this rank.
template <class F>
void for_each_row(Mat A, const F& f) {
  PetscInt first = 0;
  PetscInt end = 0;
  check(MatGetOwnershipRange(A, &first, &end));
  for (PetscInt row = first; row < end; ++row) {
    PetscInt count = 0;
    const PetscInt* columns = nullptr;
    const PetscScalar* values = nullptr;
    check(MatGetRow(A, row, &count, &columns, &values));
    f(row, std::span(columns, static_cast<size_t>(count)), std::span(values, static_cast<size_t>(count)));
    check(MatRestoreRow(A, row, &count, &columns, &values));
  }
}

// Real matrix with room for complex entries with the pattern of A.
MatHandle create_complex(Mat A) {
  PetscInt first = 0;
  PetscInt end = 0;
  check(MatGetOwnershipRange(A, &first, &end));
  std::vector<PetscInt> own;
  std::vector<PetscInt> others;
  for_each_row(A, [&](PetscInt, std::span<const PetscInt> columns, std::span<const double>) {
    const auto is_own = [&](PetscInt column) { return column >= first && column < end; };
    own.push_back(static_cast<PetscInt>(std::count_if(columns.begin(), columns.end(), is_own)));
    others.push_back(static_cast<PetscInt>(columns.size()) - own.back());
  });
  MatHandle Z;
  check(MatCreate(PetscObjectComm(reinterpret_cast<PetscObject>(A)), Z.out()));
  check(MatSetSizes(Z.get(), 2 * (end - first), 2 * (end - first), PETSC_DETERMINE, PETSC_DETERMINE));
  check(MatSetType(Z.get(), MATAIJ));
  check(MatXAIJSetPreallocation(Z.get(), 2, own.data(), others.data(), nullptr, nullptr));
  check(MatSetOption(Z.get(), MAT_NO_OFF_PROC_ENTRIES, PETSC_TRUE));
  return Z;
}

// Adds factor A to Z.
void add(Mat A, Complex factor, Mat Z) {
  std::vector<PetscInt> to;
  std::vector<double> of_two_rows;
  for_each_row(A, [&](PetscInt row, std::span<const PetscInt> columns, std::span<const double> values) {
    const size_t n = 2 * columns.size();
    to.resize(n);
    of_two_rows.resize(2 * n);
    for (size_t i = 0; i < columns.size(); ++i) {
      const Complex z = factor * values[i];
      to[2 * i] = 2 * columns[i];
      to[2 * i + 1] = 2 * columns[i] + 1;
      of_two_rows[2 * i] = of_two_rows[n + 2 * i + 1] = z.real();
      of_two_rows[2 * i + 1] = -z.imag();
      of_two_rows[n + 2 * i] = z.imag();
    }
    const PetscInt rows[2] = {2 * row, 2 * row + 1};
    check(MatSetValues(Z, 2, rows, static_cast<PetscInt>(n), to.data(), of_two_rows.data(), ADD_VALUES));
  });
}

// Sets f to the forces of a wave on the free components.
void set_forces(const System& system, const std::vector<DependsOnFrequency::Excitation>& forces, size_t wave,
                Vec f) {
  const auto& held = system.tied_nodes().held();
  check(VecSet(f, 0));
  PetscScalar* values = nullptr;
  check(VecGetArray(f, &values));
  for (const DependsOnFrequency::Excitation& e : forces)
    for (int k = 0; k < 6; ++k) {
      if (held[e.block + k / 3] >> k % 3 & 1) continue;
      const Complex F = e.by_wave[wave][k];
      values[2 * (3 * e.block + k)] += F.real();
      values[2 * (3 * e.block + k) + 1] += F.imag();
    }
  check(VecRestoreArray(f, &values));
}

std::vector<Complex> complex_values(Vec u) {
  PetscInt size = 0;
  check(VecGetLocalSize(u, &size));
  const PetscScalar* values = nullptr;
  check(VecGetArrayRead(u, &values));
  std::vector<Complex> out;
  for (PetscInt i = 0; i < size; i += 2) out.emplace_back(values[i], values[i + 1]);
  check(VecRestoreArrayRead(u, &values));
  return out;
}

}  // namespace

void linear_responses(System& system, const Kinematics& state, const std::vector<WaveComponent>& waves,
                      FunctionRef<void(size_t, const std::vector<Complex>&)> each) {
  const std::vector<DependsOnFrequency*> terms = system.with<DependsOnFrequency>();
  const auto set_frequency = [&terms](std::optional<double> omega) {
    for (DependsOnFrequency* t : terms) t->set_frequency(omega);
  };
  std::vector<DependsOnFrequency::Excitation> forces;
  for (const DependsOnFrequency* t : terms)
    for (DependsOnFrequency::Excitation& e : t->excitation(waves, state)) forces.push_back(std::move(e));
  const MatHandle K = stiffness_at_rest(system, state).matrix;
  const MatHandle Z = create_complex(K.get());
  VecHandle u;
  VecHandle f;
  KspHandle solver;
  check(KSPCreate(system.comm(), solver.out()));
  check(KSPSetOptionsPrefix(solver.get(), "responses_"));
  solve_directly(solver.get());
  check(KSPSetFromOptions(solver.get()));
  for (size_t i = 0; i < waves.size(); ++i) {
    const double omega = waves[i].omega;
    if (i == 0 || omega != waves[i - 1].omega) {
      set_frequency(omega);
      check(MatZeroEntries(Z.get()));
      add(K.get(), 1, Z.get());
      add(mass_at_rest(system, state).get(), -omega * omega, Z.get());
      add(damping_at_rest(system, state).get(), Complex(0, omega), Z.get());
      check(MatAssemblyBegin(Z.get(), MAT_FINAL_ASSEMBLY));
      check(MatAssemblyEnd(Z.get(), MAT_FINAL_ASSEMBLY));
      check(KSPSetOperators(solver.get(), Z.get(), Z.get()));
      if (i == 0) check(MatCreateVecs(Z.get(), u.out(), f.out()));
    }
    set_forces(system, forces, i, f.get());
    check(KSPSolve(solver.get(), f.get(), u.get()));
    KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
    check(KSPGetConvergedReason(solver.get(), &reason));
    PCFailedReason failure = PC_NOERROR;
    PC pc = nullptr;
    check(KSPGetPC(solver.get(), &pc));
    check(PCGetFailedReason(pc, &failure));
    if (failure == PC_FACTOR_OUTMEMORY) throw SolveError(advice::no_memory_for_responses());
    double size = 0;
    check(VecNorm(u.get(), NORM_INFINITY, &size));
    if (reason < 0 || !std::isfinite(size)) throw SolveError(advice::singular_response(2 * M_PI / omega));
    each(i, complex_values(u.get()));
  }
  set_frequency(std::nullopt);
}

}  // namespace hawser
