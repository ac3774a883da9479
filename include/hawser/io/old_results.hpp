// Earlier results at the path of new ones: recognition and backup.
#pragma once

#include <string>

namespace hawser::io {

// Path of the XDMF file that belongs to the results file `path`.
std::string xdmf_beside(const std::string& path);

// True if the file was written by a run, complete or not.
bool is_results(const std::string& path);
bool is_xdmf(const std::string& path);

// Name under which an older file is kept.
inline std::string backup_name(const std::string& path) { return path + "~"; }

// Renames results at `path` and their XDMF file to their backup names, replacing older backups. Serial.
// Throws WriteError.
void back_up_results(const std::string& path);

}  // namespace hawser::io
