// A number with its noun, for messages.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace hawser {

// "1 element", "2 elements"; `plural` is needed where it is not `singular` and an s.
inline std::string count_of(long long n, std::string_view singular, std::string_view plural = {}) {
  if (n == 1) return fmt::format("1 {}", singular);
  return plural.empty() ? fmt::format("{} {}s", n, singular) : fmt::format("{} {}", n, plural);
}

}  // namespace hawser
