// What is said of a command line that is wrong.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace hawser::run {

// One sentence with the nearest valid command or option, of the error that parsing `words` (without the
// program's name) gave.
std::string usage_error(const CLI::App& cli, const CLI::Error& error, const std::vector<std::string>& words);

// Tests of an option's value, in words: a whole number in a range; a number above 0, by what it is ("time
// above 0, in s").
CLI::Validator whole_number(long least, long most);
CLI::Validator positive(std::string what);

}  // namespace hawser::run
