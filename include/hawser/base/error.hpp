// Exit codes of the program, which scripts can test, and the exceptions behind two of them. Results that
// cannot be written: io/write_error.hpp. Energy that does not add up: record/audit.hpp.
#pragma once

#include <fmt/core.h>

#include <stdexcept>
#include <utility>

namespace hawser {

// One sentence, as it is or with what fmt::format puts into it.
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
inline constexpr int kExitEnergy = 4;     // the run has ended, but its energy does not add up
inline constexpr int kExitStopped = 130;  // by a signal

}  // namespace hawser
