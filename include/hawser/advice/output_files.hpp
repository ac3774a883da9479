// Messages about output files: why they cannot be written, and what happens to older ones. path: the
// requested file.
#pragma once

#include <cstddef>
#include <string>

namespace hawser::advice {

// kind: "the results" or "the table"; read: a file of the case that would be overwritten; written: its path
// by the name to be written.
std::string would_replace_input(const std::string& kind, const std::string& path, const std::string& read,
                                const std::string& written);

// Reasons why the results cannot be written to `path`.
std::string link_to_itself(const std::string& path);
std::string name_must_end_in_h5(const std::string& path);
std::string no_folder(const std::string& path, const std::string& folder);
std::string not_a_folder(const std::string& path, const std::string& folder);
std::string folder_not_writable(const std::string& path, const std::string& folder);
std::string name_too_long(const std::string& path, size_t characters, long allowed);
std::string name_is_a_folder(const std::string& path, const std::string& name);
std::string third_party_file(const std::string& path, const std::string& name);

// Refusals of a file for a table of `contents` ("stiffnesses", "radiation").
std::string table_needs_csv(const std::string& path, const std::string& contents);
std::string not_such_a_table(const std::string& path, const std::string& contents);

// Notes.
std::string no_file_locks(const std::string& path);
std::string name_not_utf8(const std::string& path);
std::string results_kept_as(const std::string& path, const std::string& kept);

}  // namespace hawser::advice
