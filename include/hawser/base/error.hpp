// Exit codes of the program, which scripts can test, and the exceptions for two of them. Unwritable results
// are in io/write_error.hpp, an unbalanced energy in record/audit.hpp.
#pragma once

#include <fmt/core.h>

#include <stdexcept>
#include <utility>

namespace hawser {

// A message, optionally formatted by fmt::format.
struct Sentence : std::runtime_error {
  using std::runtime_error::runtime_error;
  template <class First, class... More>
  Sentence(fmt::format_string<First, More...> text, First&& first, More&&... more)
      : runtime_error(fmt::format(text, std::forward<First>(first), std::forward<More>(more)...)) {}
};

// The user's input is wrong; what() says file, line and key. Exit code 2.
struct InputError : Sentence {
  using Sentence::Sentence;
};

// The solver failed; what() names line, arc length and cause. Exit code 3.
struct SolveError : Sentence {
  using Sentence::Sentence;
};

inline constexpr int kExitWrite = 1;  // or an error of the program
inline constexpr int kExitInput = 2;
inline constexpr int kExitSolve = 3;
inline constexpr int kExitEnergy = 4;     // the run is complete, but its energy balance is not
inline constexpr int kExitStopped = 130;  // by a signal

}  // namespace hawser
