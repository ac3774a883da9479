// Makes an object of the program a PETSc preconditioner of type PCSHELL.
#pragma once

#include <petscksp.h>

#include <memory>

#include "hawser/base/handle.hpp"

namespace hawser {

// `setup` is called for each new matrix, `apply` to solve. Both get the object from PCShellGetContext(). It
// is deleted with pc.
template <class Kept>
void use_shell(PC pc, const char* name, std::unique_ptr<Kept> kept, PetscErrorCode (*setup)(PC),
               PetscErrorCode (*apply)(PC, Vec, Vec)) {
  check(PCSetType(pc, PCSHELL));
  check(PCShellSetName(pc, name));
  check(PCShellSetSetUp(pc, setup));
  check(PCShellSetApply(pc, apply));
  check(PCShellSetDestroy(pc, [](PC shell) -> PetscErrorCode {
    PetscFunctionBegin;
    Kept* k = nullptr;
    PetscCall(PCShellGetContext(shell, &k));
    delete k;
    PetscFunctionReturn(0);
  }));
  check(PCShellSetContext(pc, kept.release()));
}

}  // namespace hawser
