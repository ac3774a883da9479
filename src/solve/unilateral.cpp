#include "hawser/solve/unilateral.hpp"

#include <fmt/format.h>
#include <petscsnes.h>

#include <algorithm>
#include <exception>

#include "hawser/base/error.hpp"
#include "hawser/system/imbalance.hpp"

namespace hawser {
namespace {

using SnesHandle = Handle<SNES, SNESDestroy>;

// Unknowns of a rank: the increments of its blocks, then a multiplier for each of its constraints.
class Complementarity {
 public:
  Complementarity(System& system, State& state) : system_(system), base_(state), trial_(state) {
    u_ = system.create_vector();
    check(VecDuplicate(u_.get(), r_.out()));
    J_ = system.create_matrix();
    read(base_);
    free_ = 3 * system.mesh().owned_blocks;
    const PetscInt own = free_ + static_cast<PetscInt>(constraints_.size());
    check(VecCreateMPI(system.comm(), own, PETSC_DETERMINE, x_.out()));
    check(VecDuplicate(x_.get(), f_.out()));
    int size = 1;
    MPI_Comm_size(system.comm(), &size);
    const PetscInt *old = nullptr, *now = nullptr;
    check(VecGetOwnershipRanges(u_.get(), &old));
    check(VecGetOwnershipRanges(x_.get(), &now));
    old_.assign(old, old + size + 1), now_.assign(now, now + size + 1);
    check(VecGetOwnershipRange(x_.get(), &first_, nullptr));
    check(MatCreate(system.comm(), A_.out()));
    check(MatSetSizes(A_.get(), own, own, PETSC_DETERMINE, PETSC_DETERMINE));
    check(MatSetType(A_.get(), MATAIJ));
    check(MatSeqAIJSetPreallocation(A_.get(), 30, nullptr));
    check(MatMPIAIJSetPreallocation(A_.get(), 30, nullptr, 30, nullptr));
    check(MatSetOption(A_.get(), MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_FALSE));
  }

  UnilateralReport run(const StaticsSettings& settings, State& state) {
    VecHandle low, high;
    check(VecDuplicate(x_.get(), low.out()));
    check(VecDuplicate(x_.get(), high.out()));
    check(VecSet(low.get(), PETSC_NINFINITY));
    check(VecSet(high.get(), PETSC_INFINITY));
    check(VecSet(x_.get(), 0));
    PetscScalar *l = nullptr, *x = nullptr;
    check(VecGetArray(low.get(), &l));
    check(VecGetArray(x_.get(), &x));
    for (size_t i = 0; i < constraints_.size(); ++i)
      l[free_ + static_cast<PetscInt>(i)] = 0, x[free_ + static_cast<PetscInt>(i)] = constraints_[i].force;
    check(VecRestoreArray(low.get(), &l));
    check(VecRestoreArray(x_.get(), &x));

    SnesHandle snes;
    check(SNESCreate(system_.comm(), snes.out()));
    check(SNESSetOptionsPrefix(snes.get(), "unilateral_"));
    check(SNESSetType(snes.get(), SNESVINEWTONRSLS));
    check(SNESSetFunction(snes.get(), f_.get(), function, this));
    check(SNESSetJacobian(snes.get(), A_.get(), A_.get(), jacobian, this));
    check(SNESVISetVariableBounds(snes.get(), low.get(), high.get()));
    SNESLineSearch search = nullptr;
    check(SNESGetLineSearch(snes.get(), &search));
    check(SNESLineSearchSetType(search, SNESLINESEARCHL2));
    KSP ksp = nullptr;
    PC pc = nullptr;
    check(SNESGetKSP(snes.get(), &ksp));
    check(KSPSetType(ksp, KSPPREONLY));
    check(KSPGetPC(ksp, &pc));
    check(PCSetType(pc, PCLU));  // a saddle point: a factorisation that pivots
    check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
    // Against the size of what the forces are made of, as in statics with springs.
    system_.residual(base_.view(0), r_.get());
    const ResidualNorms before = system_.norms(r_.get());
    check(
        SNESSetTolerances(snes.get(), settings.tolerance * before.force_scale, 1e-14, 0, kMost, 100 * kMost));
    check(SNESSetFromOptions(snes.get()));
    const PetscErrorCode code = SNESSolve(snes.get(), nullptr, x_.get());
    if (error_) std::rethrow_exception(error_);
    check(code);
    SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
    PetscInt iterations = 0;
    check(SNESGetConvergedReason(snes.get(), &reason));
    check(SNESGetIterationNumber(snes.get(), &iterations));
    take(x_.get());
    system_.residual(trial_.view(0), r_.get());
    UnilateralReport report;
    report.iterations = static_cast<int>(iterations);
    report.norms = system_.norms(r_.get());
    if (reason < 0)
      throw SolveError(fmt::format("statics with exact contact: {}: {}", SNESConvergedReasons[reason],
                                   imbalance(system_, r_.get(), report.norms)));
    read(trial_);
    int counts[2] = {static_cast<int>(constraints_.size()), 0};
    for (size_t i = 0; i < constraints_.size(); ++i) {
      counts[1] += multipliers_[i] > 0;
      report.deepest = std::max(report.deepest, -constraints_[i].gap);
    }
    MPI_Allreduce(MPI_IN_PLACE, counts, 2, MPI_INT, MPI_SUM, system_.comm());
    MPI_Allreduce(MPI_IN_PLACE, &report.deepest, 1, MPI_DOUBLE, MPI_MAX, system_.comm());
    report.constraints = counts[0], report.active = counts[1];
    state.x = trial_.x, state.q = trial_.q;
    for (const auto& t : system_.terms()) t->set_multipliers({});
    return report;
  }

 private:
  static constexpr int kMost = 200;

  void read(const State& s) {
    constraints_.clear(), share_.clear();
    for (const auto& t : system_.terms()) {
      t->constraints(s.view(0), constraints_);
      share_.push_back(constraints_.size());
    }
  }

  // Configuration and multipliers of the unknowns.
  void take(Vec x) {
    const PetscScalar* p = nullptr;
    PetscScalar* u = nullptr;
    check(VecGetArrayRead(x, &p));
    check(VecGetArray(u_.get(), &u));
    std::copy(p, p + free_, u);
    check(VecRestoreArray(u_.get(), &u));
    multipliers_.assign(p + free_, p + free_ + static_cast<PetscInt>(constraints_.size()));
    check(VecRestoreArrayRead(x, &p));
    system_.gather(u_.get(), local_);
    retract(system_.mesh(), base_, local_.data(), trial_);
    size_t begin = 0;
    for (size_t t = 0; t < share_.size(); ++t) {
      if (share_[t] > begin)
        system_.terms()[t]->set_multipliers(std::span(multipliers_).subspan(begin, share_[t] - begin));
      begin = share_[t];
    }
  }

  PetscInt composite(PetscInt row) const {
    const auto rank = std::upper_bound(old_.begin(), old_.end(), row) - old_.begin() - 1;
    return row - old_[static_cast<size_t>(rank)] + now_[static_cast<size_t>(rank)];
  }

  static PetscErrorCode function(SNES, Vec x, Vec f, void* self) {
    PetscFunctionBegin;
    auto& c = *static_cast<Complementarity*>(self);
    try {
      c.take(x);
      c.system_.residual(c.trial_.view(0), c.r_.get());
      c.read(c.trial_);
      const PetscScalar* r = nullptr;
      PetscScalar* p = nullptr;
      check(VecGetArrayRead(c.r_.get(), &r));
      check(VecGetArray(f, &p));
      std::copy(r, r + c.free_, p);
      for (size_t i = 0; i < c.constraints_.size(); ++i)
        p[c.free_ + static_cast<PetscInt>(i)] = c.constraints_[i].stiffness * c.constraints_[i].gap;
      check(VecRestoreArray(f, &p));
      check(VecRestoreArrayRead(c.r_.get(), &r));
    } catch (...) {
      c.error_ = std::current_exception();
      PetscFunctionReturn(PETSC_ERR_LIB);
    }
    PetscFunctionReturn(0);
  }

  static PetscErrorCode jacobian(SNES, Vec x, Mat, Mat A, void* self) {
    PetscFunctionBegin;
    auto& c = *static_cast<Complementarity*>(self);
    try {
      c.take(x);
      c.read(c.trial_);
      c.assemble(A);
    } catch (...) {
      c.error_ = std::current_exception();
      PetscFunctionReturn(PETSC_ERR_LIB);
    }
    PetscFunctionReturn(0);
  }

  // [K - lambda H, -n; k n', 0]
  void assemble(Mat A) {
    system_.tangent(trial_.view(0), {}, local_, false, J_.get());
    check(MatZeroEntries(A));
    PetscInt begin = 0, end = 0;
    check(MatGetOwnershipRange(J_.get(), &begin, &end));
    std::vector<PetscInt> columns;
    for (PetscInt row = begin; row < end; ++row) {
      PetscInt n = 0;
      const PetscInt* cols = nullptr;
      const PetscScalar* values = nullptr;
      check(MatGetRow(J_.get(), row, &n, &cols, &values));
      columns.assign(cols, cols + n);
      for (PetscInt& k : columns) k = composite(k);
      const PetscInt to = composite(row);
      check(MatSetValues(A, 1, &to, n, columns.data(), values, INSERT_VALUES));
      check(MatRestoreRow(J_.get(), row, &n, &cols, &values));
    }
    const auto& held = system_.supports().held();
    for (size_t i = 0; i < constraints_.size(); ++i) {
      const ForceTerm::Constraint& c = constraints_[i];
      const PetscInt row = first_ + free_ + static_cast<PetscInt>(i);
      check(MatSetValue(A, row, row, 0, INSERT_VALUES));
      for (int k = 0; k < 3; ++k) {
        const bool fixed = !held.empty() && (held[static_cast<size_t>(c.block)] >> k & 1);
        const PetscInt at = first_ + 3 * c.block + k;
        check(MatSetValue(A, row, at, fixed ? 0 : c.stiffness * c.normal[k], INSERT_VALUES));
        check(MatSetValue(A, at, row, fixed ? 0 : -c.normal[k], INSERT_VALUES));
      }
    }
    check(MatAssemblyBegin(A, MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(A, MAT_FINAL_ASSEMBLY));
  }

  System& system_;
  State base_, trial_;
  VecHandle u_, r_, x_, f_;
  MatHandle J_, A_;
  std::vector<ForceTerm::Constraint> constraints_;
  std::vector<size_t> share_;  // where the constraints of each term end
  std::vector<double> multipliers_, local_;
  std::vector<PetscInt> old_, now_;  // rows of the ranks without and with multipliers
  PetscInt free_ = 0, first_ = 0;
  std::exception_ptr error_;
};

}  // namespace

UnilateralReport solve_unilateral(System& system, const StaticsSettings& settings, State& state) {
  const UnilateralReport report = Complementarity(system, state).run(settings, state);
  system.commit(state.view(0));
  return report;
}

}  // namespace hawser
