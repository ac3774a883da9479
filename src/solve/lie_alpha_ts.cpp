// The TS type "liealpha" and the TSAdapt type "verdict". This is the only file that uses PETSc's private TS
// structures. A step is solved by SNES; TSAdaptChoose then decides whether the trial is accepted and the
// length of the next trial, or step. An accepted step is committed afterwards. Dynamics computes the steps,
// because the configuration differs from the unknown (rotations) and TSALPHA2 of PETSc 3.18 is of first
// order. Events are part of the verdict: docs/decisions/027-events-in-the-verdict.md.
#include <petsc/private/tsimpl.h>

#include "hawser/advice/run.hpp"
#include "hawser/base/error.hpp"
#include "hawser/solve/dynamics.hpp"

namespace hawser {
namespace {

constexpr char kType[] = "liealpha", kVerdict[] = "verdict";

Dynamics& dynamics(TS ts) { return *static_cast<Dynamics*>(ts->data); }

// Runs `body`. If it throws, the TS ends, and Dynamics::run() throws the same exception.
template <class Body>
void guarded(TS ts, const Body& body) {
  if (dynamics(ts).error().capture(body)) ts->reason = TS_DIVERGED_STEP_REJECTED;
}

PetscErrorCode step(TS ts) {
  PetscFunctionBegin;
  Dynamics& d = dynamics(ts);
  PetscBool accepted = PETSC_FALSE;
  guarded(ts, [&] { ts->time_step = d.begin_step(); });
  while (!ts->reason && !accepted) {
    PetscReal next = ts->time_step;
    guarded(ts, [&] { ts->snes_its += d.try_step(ts->time_step); });
    if (ts->reason) break;
    PetscCall(TSAdaptChoose(ts->adapt, ts, ts->time_step, nullptr, &next, &accepted));
    ts->time_step = next;
    if (!accepted) ++ts->reject;
  }
  if (accepted) ts->ptime = d.trial_time();
  PetscFunctionReturn(0);
}

PetscErrorCode choose(TSAdapt, TS ts, PetscReal h, PetscInt* scheme, PetscReal* next, PetscBool* accept,
                      PetscReal* error, PetscReal*, PetscReal*) {
  PetscFunctionBegin;
  *scheme = 0;
  *next = h;
  *accept = PETSC_FALSE;
  *error = -1;
  guarded(ts, [&] {
    const Dynamics::Decision decision = dynamics(ts).decide();
    *next = decision.h;
    *accept = decision.accepted ? PETSC_TRUE : PETSC_FALSE;
  });
  PetscFunctionReturn(0);
}

PetscErrorCode post_step(TS ts) {
  PetscFunctionBegin;
  if (ts->reason >= 0)
    guarded(ts, [&] {
      if (!dynamics(ts).end_step()) ts->reason = TS_CONVERGED_USER;
    });
  PetscFunctionReturn(0);
}

PetscErrorCode create_verdict(TSAdapt adapt) {
  PetscFunctionBegin;
  adapt->ops->choose = choose;
  PetscFunctionReturn(0);
}

PetscErrorCode create(TS ts) {
  PetscFunctionBegin;
  ts->ops->step = step;
  ts->default_adapt_type = kVerdict;
  ts->usessnes = PETSC_TRUE;
  PetscFunctionReturn(0);
}

}  // namespace

void lie_alpha_attach(TS ts, Dynamics* dynamics) {
  static const bool registered = [] {
    check(TSRegister(kType, create));
    check(TSAdaptRegister(kVerdict, create_verdict));
    return true;
  }();
  (void)registered;
  check(TSSetType(ts, kType));
  ts->data = dynamics;
  check(TSSetPostStep(ts, post_step));
  // Dynamics::next_try() makes steps end at stops and at the end of the run, so PETSc need not.
  check(TSSetExactFinalTime(ts, TS_EXACTFINALTIME_STEPOVER));
  check(TSSetErrorIfStepFails(ts, PETSC_FALSE));
}

void lie_alpha_options(TS ts) {
  check(TSSetFromOptions(ts));
  TSAdapt adapt = nullptr;
  check(TSGetAdapt(ts, &adapt));
  const auto must_be = [](void* object, const char* type, const char* option) {
    PetscBool same = PETSC_FALSE;
    check(PetscObjectTypeCompare(static_cast<PetscObject>(object), type, &same));
    if (!same) throw InputError(advice::petsc_option_is_fixed(option, type));
  };
  must_be(ts, kType, "ts_type");
  must_be(adapt, kVerdict, "ts_adapt_type");
  SNES snes = nullptr;
  check(TSGetSNES(ts, &snes));
  must_be(snes, SNESNEWTONLS, "snes_type");
}

}  // namespace hawser
