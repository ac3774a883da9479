// Exceptions and PETSc: its frames are of C, and no exception may pass through them.
#pragma once

#include <exception>
#include <utility>

#include "hawser/base/handle.hpp"

namespace hawser {

// Carries what a callback of PETSc throws until the call into PETSc has returned.
class CarriedError {
 public:
  // The body of a callback, and what the callback returns: an error code where the body threw.
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

  // After the call into PETSc that the callback is part of: throws what was captured, or else PetscFailure
  // where the call returned an error.
  void check(PetscErrorCode code) {
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    hawser::check(code);
  }

 private:
  std::exception_ptr error_;
};

}  // namespace hawser
