// Location of the Python package relative to the program (installed, moved or in a build folder), and
// replacement of the process by Python.
#include "hawser/run/post.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace hawser::run {
namespace {

namespace fs = std::filesystem;

// Data folders relative to the program: in a build folder, and installed.
constexpr const char* kData[] = {"share/hawser", HAWSER_DATA};

// Folder of the package hawser_post; if missing, prints where it was searched for.
fs::path package_folder(const fs::path& program) {
  std::string searched;
  for (const char* data : kData) {
    const fs::path folder = (program.parent_path() / data / "python").lexically_normal();
    std::error_code none;
    if (fs::is_directory(folder / "hawser_post", none)) return folder;
    searched += (searched.empty() ? "neither in " : " nor in ") + folder.string();
  }
  std::fputs(fmt::format("hawser: the Python package hawser_post is {}\n", searched).c_str(), stderr);
  return {};
}

}  // namespace

bool is_post_command(std::string_view word) {
  return std::any_of(std::begin(kPostCommands), std::end(kPostCommands),
                     [&](const PostCommand& c) { return word == c.name; });
}

int post(char** arguments) {
  // Only one of several processes is needed.
  if (const char* rank = std::getenv("OMPI_COMM_WORLD_RANK"); rank && std::string_view(rank) != "0") return 0;
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  const fs::path folder = package_folder(program);
  if (folder.empty()) return 1;
  setenv("HAWSER", program.c_str(), 1);
  // Ctrl-C is blocked until Python can handle it.
  sigset_t interrupt;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  sigprocmask(SIG_BLOCK, &interrupt, nullptr);
  // The package precedes the user's folder, which may contain modules of the same names.
  std::string python = "python3";
  std::string no_bytecode = "-B";
  std::string command = "-c";
  std::string from = folder.string();
  std::string start = R"(
import os, sys
sys.path[0] = sys.argv.pop(1)
def stop(*_):
    os.write(2, b'hawser: stopped by Ctrl-C\n')
    os._exit(130)
try:
    import runpy, signal
    # No KeyboardInterrupt: where libraries catch it or Python ignores it, as in finalizers, a command would go on.
    signal.signal(signal.SIGINT, stop)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGINT])
    runpy.run_module('hawser_post', run_name='__main__', alter_sys=True)
except KeyboardInterrupt:
    stop()
)";
  std::vector<char*> words{python.data(), no_bytecode.data(), command.data(), start.data(), from.data()};
  for (; *arguments; ++arguments) words.push_back(*arguments);
  words.push_back(nullptr);
  // The distribution's Python has the modules; another may come first in PATH.
  execv("/usr/bin/python3", words.data());
  execvp("python3", words.data());
  std::fputs("hawser: this command needs python3, which was not found\n", stderr);
  return 1;
}

}  // namespace hawser::run
