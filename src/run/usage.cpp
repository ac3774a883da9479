// Conversion of parser errors into sentences: unknown commands and options, PETSc options without their "--",
// missing and superfluous values.
#include "hawser/run/usage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "hawser/model/nearest.hpp"

namespace hawser::run {
namespace {

std::vector<std::string> commands_of(const CLI::App& cli) {
  std::vector<std::string> names;
  for (const CLI::App* a : cli.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(a->get_name());
  return names;
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* o : command.get_options()) {
    for (const std::string& name : o->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : o->get_snames()) names.push_back("-" + name);
  }
  return names;
}

bool ends_with(const std::string& word, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](const char* e) { return word.ends_with(e); });
}

std::string no_command(const CLI::App& cli, const std::string& word) {
  const std::vector<std::string> commands = commands_of(cli);
  if (word.empty()) return "it needs a command: " + model::enumerate(commands);
  std::string s = fmt::format("there is no command {}", model::quote(word));
  if (ends_with(word, {".yaml", ".yml"})) return s + fmt::format("; to run this case: hawser run {}", word);
  if (ends_with(word, {".h5"}))
    return s + fmt::format("; for a report of these results: hawser report {}", word);
  const std::string meant = model::did_you_mean(word, commands);
  return s + (meant.empty() ? ", but there are " + model::enumerate(commands, "and") : meant);
}

bool one_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// The first word of a command line that looks like an option but is none of the command's.
std::string unknown_option(const CLI::App& command, const std::vector<std::string>& words) {
  const std::vector<std::string> options = options_of(command);
  const auto known = [&](const std::string& word) {
    return std::find(options.begin(), options.end(), word) != options.end();
  };
  for (const std::string& word : words) {
    if (word.size() < 2 || word[0] != '-' || (word[1] >= '0' && word[1] <= '9')) continue;
    // A short option may be directly followed by its value.
    if (known(word.substr(0, word.find('='))) || (word[1] != '-' && known(word.substr(0, 2)))) continue;
    return word;
  }
  return "";
}

// mpirun sets the number of ranks: "-n 2", "-n2", "--ranks=2" as `given`, with the words that follow.
std::string ranks_by_mpirun(const std::string& command, const std::string& given,
                            const std::vector<std::string>& words) {
  const std::size_t digit = std::min(given.find_first_of("0123456789"), given.size());
  const std::string name = given.substr(0, std::min(digit, given.find('=')));
  if (!one_of(name, {"-n", "-np", "--np", "--ranks", "--n"})) return "";
  std::string number = given.substr(digit);
  std::string file = "case.yaml";
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == given && number.empty() && i + 1 < words.size()) number = words[i + 1];
    if (ends_with(words[i], {".yaml", ".yml"})) file = words[i];
  }
  if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) number = "2";
  return fmt::format("the number of ranks is an option of mpirun: mpirun -n {} {} {}", number, command, file);
}

std::string no_option(const CLI::App& command, const std::string& given,
                      const std::vector<std::string>& words) {
  const std::string name = command.get_parent() ? command.get_name() : "run";
  if (std::string s = ranks_by_mpirun("hawser " + name, given, words); !s.empty()) return s;
  const std::string word = given.substr(0, given.find('='));
  std::string s = fmt::format("there is no option {}", model::quote(word));
  const std::vector<std::string> options = options_of(command);
  // A single dash in place of two.
  if (std::find(options.begin(), options.end(), "-" + word) != options.end())
    return s + fmt::format("; did you mean '-{}'?", word);
  const std::string meant = model::did_you_mean(word, options);
  if (!meant.empty()) return s + meant;
  if (word.size() > 2 && word[1] != '-')
    return s + fmt::format("; options of PETSc follow a lone --: -- {}", given);
  return s + ", but there are " + model::enumerate(options, "and");
}

}  // namespace

std::string usage_error(const CLI::App& cli, const CLI::Error& error, const std::vector<std::string>& words) {
  const std::vector<CLI::App*> chosen = cli.get_subcommands();
  // Error names are option names for some kinds.
  const int kind = error.get_exit_code();
  if (chosen.empty()) {
    const std::string word = words.empty() ? "" : words.front();
    return fmt::format("hawser: {} (see hawser --help)\n",
                       word.starts_with('-') ? no_option(cli, word, words) : no_command(cli, word));
  }
  const CLI::App& command = *chosen.front();
  const std::string name = "hawser " + command.get_name();
  std::string text = error.what();
  if (kind == static_cast<int>(CLI::ExitCodes::ExtrasError)) {  // "The following ... not expected: one two"
    const std::string all = text.substr(std::min(text.find(": "), text.size() - 2) + 2);
    const std::string extra = all.substr(0, all.find(' '));
    const std::string option = unknown_option(command, words);
    text = !option.empty() ? no_option(command, option, words)
                           : fmt::format("{} is an unexpected argument", model::quote(extra));
  } else if (kind == static_cast<int>(CLI::ExitCodes::RequiredError)) {
    text = fmt::format("a case file is missing: {} case.yaml", name);
  } else if (kind == static_cast<int>(CLI::ExitCodes::ArgumentMismatch)) {
    text = fmt::format("a value is missing after {}", text.substr(0, text.find(':')));
  }
  return fmt::format("hawser: {} (see {} --help)\n", text, name);
}

CLI::Validator whole_number(long lowest, long highest) {
  const auto test = [=](std::string& text) -> std::string {
    long n = 0;
    const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), n);
    if (wrong == std::errc() && end == text.data() + text.size() && n >= lowest && n <= highest) return "";
    return fmt::format("{} is not a whole number from {} to {}", model::quote(text), lowest, highest);
  };
  return CLI::Validator(test, "");
}

CLI::Validator positive(std::string kind) {
  const auto test = [kind = std::move(kind)](std::string& text) -> std::string {
    char* end = nullptr;
    const double x = std::strtod(text.c_str(), &end);
    return x > 0 && std::isfinite(x) && !*end ? "" : fmt::format("{} is no {}", model::quote(text), kind);
  };
  return CLI::Validator(test, "");
}

}  // namespace hawser::run
