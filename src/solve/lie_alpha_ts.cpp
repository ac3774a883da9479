// The TS type "liealpha": the only file that looks into PETSc's private TS structure. A step is delegated to
// Dynamics, because configuration and unknown differ (rotations) and TSALPHA2 of PETSc 3.18 is first order.
#include <petsc/private/tsimpl.h>

#include "hawser/solve/dynamics.hpp"

namespace hawser {
namespace {

PetscErrorCode step(TS ts) {
  PetscFunctionBegin;
  PetscCall(static_cast<Dynamics*>(ts->data)->ts_step(ts));
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

PetscErrorCode Dynamics::ts_step(TS ts) {
  PetscFunctionBegin;
  StepInfo info;
  try {
    const double t = committed_.s.time;
    const double until = ts->max_time;
    prepare(control_.wish());  // tries can only be shorter
    StepLimit limit;
    if (control_.limited()) {
      limit = system_.longest_step(committed_.s.view(last_step_), control_.wish());
      control_.struck(t, limit.period);
    }
    for (bool again = false;;) {
      const double h = control_.next(t, std::min(next_stop_(t), until), limit.longest);
      const Attempt a = attempt(h);
      if (a.converged && control_.accurate(h, a.error)) {
        accept(h);
        control_.accepted(h, a.iterations, a.error);
        info.time = committed_.s.time, info.h = h, info.iterations = a.iterations, info.error = a.error;
        break;
      }
      // How old a list of candidates is must not show in the steps: a restart makes a new one.
      if (a.missed && !again && system_.outdated()) {
        again = true;
        prepare(h, &trial_.s);
        continue;
      }
      ++info.rejected;
      if (!control_.rejected(h, !a.converged, a.error)) {
        ts->reason = TS_DIVERGED_STEP_REJECTED;
        PetscFunctionReturn(0);
      }
    }
    ts->ptime = info.time;
    ts->time_step = control_.wish();
    ts->snes_its += info.iterations;
    if (!observer_(info)) ts->reason = TS_CONVERGED_USER;
  } catch (...) {
    error_ = std::current_exception();
    ts->reason = TS_CONVERGED_USER;
  }
  PetscFunctionReturn(0);
}

}  // namespace hawser
