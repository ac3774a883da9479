// The two ways a run can end badly, each with the exit code a script can test.
#pragma once

#include <stdexcept>
#include <string>

namespace hawser {

// The user's input is wrong; what() is one sentence with file, line and key. Exit code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The solver gave up; what() names line, arc length and cause. Exit code 3.
struct SolveError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr int kExitInput = 2;
inline constexpr int kExitSolve = 3;

}  // namespace hawser
