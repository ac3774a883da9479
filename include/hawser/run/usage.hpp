// Error messages for invalid command lines.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace hawser::run {

// Sentence with the nearest valid command or option, for an error in parsing `words` (without the program's
// name).
std::string usage_error(const CLI::App& cli, const CLI::Error& error, const std::vector<std::string>& words);

// Validators of option values with their descriptions: a whole number in a range; a number above 0, described
// by `kind` ("time above 0, in s").
CLI::Validator whole_number(long lowest, long highest);
CLI::Validator positive(std::string kind);

}  // namespace hawser::run
