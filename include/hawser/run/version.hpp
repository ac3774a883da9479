// Version of the program.
#pragma once

namespace hawser::run {
inline constexpr const char* kVersion = "0.1.0";
}
