// The TS type "liealpha": the only file that looks into PETSc's private TS structure. A step is delegated to
// Dynamics, because configuration and unknown differ (rotations) and TSALPHA2 of PETSc 3.18 is first order.
#include <petsc/private/tsimpl.h>

#include "hawser/solve/dynamics.hpp"

namespace hawser {
namespace {

PetscErrorCode step(TS ts) {
  PetscFunctionBegin;
  StepInfo info;
  auto& dynamics = *static_cast<Dynamics*>(ts->data);
  const bool go_on = dynamics.ts_step(ts->max_time, info);
  ts->ptime = dynamics.committed().s.time;
  ts->time_step = dynamics.control().proposal();
  ts->snes_its += info.iterations;
  if (!go_on) ts->reason = TS_CONVERGED_USER;
  PetscFunctionReturn(0);
}
PetscErrorCode nothing(TS) { return 0; }
PetscErrorCode view(TS, PetscViewer) { return 0; }
PetscErrorCode options(TS, PetscOptionItems*) { return 0; }

PetscErrorCode create(TS ts) {
  PetscFunctionBegin;
  ts->ops->step = step;
  ts->ops->setup = nothing;
  ts->ops->reset = nothing;
  ts->ops->destroy = nothing;
  ts->ops->setfromoptions = options;
  ts->ops->view = view;
  ts->default_adapt_type = TSADAPTNONE;
  ts->usessnes = PETSC_TRUE;
  PetscFunctionReturn(0);
}

}  // namespace

void register_lie_alpha() {
  static bool done = false;
  if (!done) check(TSRegister("liealpha", create));
  done = true;
}

void lie_alpha_attach(TS ts, Dynamics* dynamics) { ts->data = dynamics; }

bool Dynamics::ts_step(double until, StepInfo& info) noexcept {
  try {
    info = take_step(until);
    return observer_(info);
  } catch (...) {
    error_ = std::current_exception();
    return false;
  }
}

}  // namespace hawser
