// Version of the program.
#pragma once

namespace hawser::run {
extern const char* const kVersion;
}
