// What TSEvent of PETSc 3.18 does with events (027-events-in-the-verdict.md). With 3.18.5 it prints:
//   run from t = 0 s: found at x - 2 = -0.000297155
//   run from t = 100 s: found at x - 2 = 0.0137457
//   run from t = 10000 s: found at x - 2 = 0.0137457
//   x falls through 2, awaited is that it rises: 1 events
//   from the event on x' = -1000 x: the largest |x| of accepted steps is 601.043
// mpicxx -std=c++20 027-tsevent.cpp $(pkg-config --cflags --libs petsc)
#include <petscts.h>

struct Run {
  double from, rate, after;
  int direction, events;
  double value, t, most;
};

PetscErrorCode rhs(TS, PetscReal, Vec x, Vec f, void* r) {
  const PetscScalar* p;
  PetscScalar* q;
  VecGetArrayRead(x, &p);
  VecGetArray(f, &q);
  q[0] = static_cast<Run*>(r)->rate * p[0];
  VecRestoreArrayRead(x, &p);
  VecRestoreArray(f, &q);
  return 0;
}
PetscErrorCode function(TS, PetscReal, Vec x, PetscScalar g[], void*) {
  const PetscScalar* p;
  VecGetArrayRead(x, &p);
  g[0] = p[0] - 2;
  VecRestoreArrayRead(x, &p);
  return 0;
}
PetscErrorCode happens(TS ts, PetscInt, PetscInt*, PetscReal t, Vec x, PetscBool, void* ctx) {
  auto& r = *static_cast<Run*>(ctx);
  PetscScalar g;
  function(ts, t, x, &g, ctx);
  if (r.events++ == 0) r.value = g, r.t = t - r.from;
  r.rate = r.after;
  return 0;
}
PetscErrorCode look(TS ts, PetscInt, PetscReal, Vec x, void* ctx) {
  auto& r = *static_cast<Run*>(ctx);
  PetscScalar g;
  function(ts, 0, x, &g, ctx);
  if (r.events) r.most = PetscMax(r.most, PetscAbs(g + 2));
  return 0;
}

// x' = rate x from x0 at a time `from`, for ten seconds; the event is x = 2, to 0.001.
Run run(double from, double x0, double rate, double after, int direction, const char* adapt, double h) {
  Run r{from, rate, after, direction, 0, 0, 0, 0};
  TS ts;
  Vec x;
  TSAdapt a;
  PetscInt d[] = {direction};
  PetscBool stop[] = {PETSC_FALSE};
  VecCreateSeq(PETSC_COMM_SELF, 1, &x);
  VecSet(x, x0);
  TSCreate(PETSC_COMM_SELF, &ts);
  TSSetType(ts, TSRK);
  TSSetRHSFunction(ts, nullptr, rhs, &r);
  TSGetAdapt(ts, &a);
  TSAdaptSetType(a, adapt);
  TSSetTolerances(ts, 1e-6, nullptr, 1e-6, nullptr);
  TSSetTime(ts, from);
  TSSetTimeStep(ts, h);
  TSSetMaxTime(ts, from + 10);
  TSSetMaxSteps(ts, 20000);
  TSSetExactFinalTime(ts, TS_EXACTFINALTIME_STEPOVER);
  TSSetEventHandler(ts, 1, d, stop, function, happens, &r);
  TSSetEventTolerances(ts, 1e-3, nullptr);
  TSMonitorSet(ts, look, &r, nullptr);
  TSSolve(ts, x);
  TSDestroy(&ts);
  VecDestroy(&x);
  return r;
}

int main(int argc, char** argv) {
  PetscInitialize(&argc, &argv, nullptr, nullptr);
  for (const double from : {0.0, 100.0, 10000.0})
    PetscPrintf(PETSC_COMM_WORLD, "run from t = %g s: found at x - 2 = %g\n", from,
                run(from, 1, 1, 1, 1, TSADAPTNONE, 0.05).value);
  Run r = run(0, 3, -1, -1, 1, TSADAPTNONE, 0.05);
  PetscPrintf(PETSC_COMM_WORLD, "x falls through 2, awaited is that it rises: %d events\n", r.events);
  r = run(0, 4, -1, -1000, -1, TSADAPTBASIC, 0.05);
  PetscPrintf(PETSC_COMM_WORLD, "from the event on x' = -1000 x: the largest |x| of accepted steps is %g\n",
              r.most);
  PetscFinalize();
}
