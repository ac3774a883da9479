// Version of the program with the commit of its sources, for example 0.1.0+1a2b3c4d.
#pragma once

namespace hawser::run {
extern const char* const kVersion;
}
