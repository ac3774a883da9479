// Transfer of exceptions through PETSc, whose C frames must not be unwound.
#pragma once

#include <exception>
#include <utility>

#include "hawser/base/handle.hpp"

namespace hawser {

// Stores the exception of a PETSc callback until the call into PETSc has returned.
class DeferredError {
 public:
  // Runs the body of a callback. Returns the callback's result: an error code if the body threw.
  template <class Body>
  PetscErrorCode capture(const Body& body) noexcept {
    try {
      body();
    } catch (...) {
      error_ = std::current_exception();
      return PETSC_ERR_LIB;
    }
    return 0;
  }

  // Called after the call into PETSc that the callback is part of. Rethrows a stored exception, or throws
  // PetscFailure if the call returned an error.
  void check(PetscErrorCode code) {
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    hawser::check(code);
  }

 private:
  std::exception_ptr error_;
};

}  // namespace hawser
