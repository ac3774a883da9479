// Used by fuzz.py: runs `hawser check case.yaml` in one process for each folder whose path is a line of
// stdin, because starting a process under sanitizers takes a hundred times as long as a check. Prints for
// each folder a line "exit code, blank, sentence". If a file is given on the command line, the checks are
// `check --quick`, and that file contains the output of the last check.
#include <petscsys.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>

#include "hawser/base/error.hpp"
#include "hawser/base/singleton.hpp"
#include "hawser/run/driver.hpp"

int main(int argc, char** argv) {
  hawser::start_singleton();
  if (PetscInitialize(&argc, &argv, nullptr, nullptr)) return 1;
  PetscPopSignalHandler();
  std::FILE* const answers = fdopen(dup(STDOUT_FILENO), "w");
  const bool quick = argc > 1;
  if (!answers || !std::freopen(quick ? argv[1] : "/dev/null", "w", stdout)) return 1;
  for (std::string folder; std::getline(std::cin, folder);) {
    int code = 0;
    std::string text;
    try {
      std::rewind(stdout);
      if (quick && ftruncate(STDOUT_FILENO, 0) != 0) throw std::runtime_error("cannot empty the file");
      if (chdir(folder.c_str()) != 0) throw std::runtime_error("no folder " + folder);
      code = hawser::run::check_case(PETSC_COMM_WORLD, {.case_path = "case.yaml", .trial = !quick});
    } catch (const hawser::InputError& e) {
      code = hawser::kExitInput;
      text = e.what();
    } catch (const std::exception& e) {
      code = 1;
      text = e.what();
    }
    std::fflush(stdout);
    std::fprintf(answers, "%d %s\n", code, text.c_str());
    std::fflush(answers);
  }
  return PetscFinalize();
}
