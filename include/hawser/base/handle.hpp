// Owning handle of a PETSc object, and PETSc's error codes as exceptions.
#pragma once

#include <petscsys.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace hawser {

// Thrown when a PETSc call fails: a defect of the program or its installation, not of the input.
struct PetscFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void check(PetscErrorCode code) {
  if (code) {
    const char* text = nullptr;
    PetscErrorMessage(code, &text, nullptr);
    throw PetscFailure(std::string("PETSc: ") + (text ? text : "error"));
  }
}

template <class T, PetscErrorCode (*Destroy)(T*)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(T raw) : raw_(raw) {}
  Handle(Handle&& o) noexcept : raw_(std::exchange(o.raw_, nullptr)) {}
  Handle& operator=(Handle&& o) noexcept {
    std::swap(raw_, o.raw_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { reset(); }
  T get() const { return raw_; }
  explicit operator bool() const { return raw_ != nullptr; }
  // For PETSc's create(&out); releases the present object.
  T* out() {
    reset();
    return &raw_;
  }
  void reset() {
    if (raw_) Destroy(&raw_);
    raw_ = nullptr;
  }

 private:
  T raw_ = nullptr;
};

}  // namespace hawser
