#pragma once

#include <petscsys.h>

#include "hawser/base/handle.hpp"

namespace hawser {

// Measures the time of a scope for -log_view.
class Logged {
 public:
  explicit Logged(PetscLogEvent event) : event_(event) {
    check(PetscLogEventBegin(event_, nullptr, nullptr, nullptr, nullptr));
  }
  ~Logged() { (void)PetscLogEventEnd(event_, nullptr, nullptr, nullptr, nullptr); }
  Logged(const Logged&) = delete;
  Logged& operator=(const Logged&) = delete;

 private:
  PetscLogEvent event_;
};

}  // namespace hawser
