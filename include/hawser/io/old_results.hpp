// What is at a place where results shall go: whether it is hawser's, and how it is kept.
#pragma once

#include <string>

namespace hawser::io {

// Of the results file `path`: the XDMF file beside it.
std::string xdmf_beside(const std::string& path);

// Whether they are what a run wrote, whole or not.
bool is_results(const std::string& path);
bool is_xdmf(const std::string& path);

// The name under which an older file is kept.
inline std::string backup_name(const std::string& path) { return path + "~"; }

// Gives results at `path`, and the XDMF file beside them, that name; what had it is gone. Serial. Throws
// WriteError.
void back_up_results(const std::string& path);

}  // namespace hawser::io
