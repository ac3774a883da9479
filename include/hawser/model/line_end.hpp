// The two ends of a line.
#pragma once

#include <array>
#include <cstddef>

namespace hawser {

enum class LineEnd { A, B };

inline constexpr std::array kLineEnds{LineEnd::A, LineEnd::B};

constexpr LineEnd opposite(LineEnd end) { return end == LineEnd::A ? LineEnd::B : LineEnd::A; }
constexpr std::size_t end_index(LineEnd end) { return static_cast<std::size_t>(end); }
// In messages ("end B") and in the keys of a case ("end_b").
constexpr char end_letter(LineEnd end) { return end == LineEnd::A ? 'A' : 'B'; }
constexpr const char* end_key(LineEnd end) { return end == LineEnd::A ? "end_a" : "end_b"; }

}  // namespace hawser
