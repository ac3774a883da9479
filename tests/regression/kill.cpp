// The program is killed (SIGKILL) at random moments of a run with contact. Rows that its file showed before
// are still there, equal to those of an uninterrupted run, and a restart from it has the same end.
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <random>

#include "regression/runs.hpp"

namespace hawser::runs::kill_test {
namespace {

// Starts the program without the MPI environment of this test's job.
pid_t start(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{std::string(HAWSER_BINARY_DIR) + "/hawser"};
  std::vector<std::string> env;
  words.insert(words.end(), arguments.begin(), arguments.end());
  for (const char* name : {"PATH", "HOME", "TMPDIR", "LD_LIBRARY_PATH", "ASAN_OPTIONS",
                           "OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM",
                           "OMPI_MCA_btl_vader_single_copy_mechanism", "OMPI_MCA_hwloc_base_binding_policy"})
    if (const char* value = std::getenv(name)) env.push_back(std::string(name) + "=" + value);
  std::vector<char*> argv, envp;
  for (auto& w : words) argv.push_back(w.data());
  for (auto& e : env) envp.push_back(e.data());
  argv.push_back(nullptr);
  envp.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    execve(argv[0], argv.data(), envp.data());
    _exit(127);
  }
  return child;
}

int wait_for(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

// Rows in `path` at this moment; another process may be writing it.
std::pair<size_t, size_t> rows(const std::string& path) {
  if (access(path.c_str(), F_OK)) return {0, 0};
  return written(io::h5::open_read(path));
}

// The contents of `part` are the beginning of those of `whole`, bit for bit.
void expect_beginning(const Results& whole, const Results& part) {
  const auto begins = [](const std::vector<double>& all, const std::vector<double>& some) {
    return some.size() <= all.size() && std::equal(some.begin(), some.end(), all.begin());
  };
  EXPECT_TRUE(begins(whole.output_times, part.output_times));
  EXPECT_TRUE(begins(whole.step_times, part.step_times));
  for (const auto& [name, values] : whole.fields) EXPECT_TRUE(begins(values, part.fields.at(name))) << name;
  for (const auto& [name, values] : whole.series) EXPECT_TRUE(begins(values, part.series.at(name))) << name;
  EXPECT_TRUE(begins(whole.clash_counts, part.clash_counts));
}

TEST(Kill, WhatWasAcceptedStaysAndTheRunGoesOn) {
  const std::string path = folder("kill");
  const std::string file = path + "/killed.h5";
  const std::string input =
      reel(path + "/reel.yaml", {{"length: 250, elements: 250", "length: 60, elements: 60"},
                                 {"duration: 325", "duration: 20"},
                                 {"every: 1.0", "every: 0.1"}});
  const auto began = std::chrono::steady_clock::now();
  ASSERT_EQ(wait_for(start({"run", input, "-q", "-o", path + "/whole.h5"})), 0);
  const double duration =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();  // s, wall time
  const Results whole = read(path + "/whole.h5");
  ASSERT_EQ(whole.output_times.size(), 201u);

  std::mt19937 random(20240102);
  std::uniform_real_distribution<double> moment(0.05 * duration, duration);
  std::remove(file.c_str());
  int kills = 0, restarts = 0, ends = 0;
  for (int attempt = 0; attempt < 100 && (kills < 10 || restarts < 3 || ends < 2); ++attempt) {
    // A run killed before its first checkpoint starts again from the beginning.
    std::vector<std::string> words{"run", input, "-q", "-o", file};
    const bool going_on = rows(file).first > 1;
    if (going_on) words.insert(words.end(), {"--restart", file});
    // A restart first writes a new file up to its checkpoint and repeats later rows.
    const auto number = [&] {
      struct stat now {};
      return stat(file.c_str(), &now) ? ino_t{0} : now.st_ino;
    };
    const ino_t old = going_on ? number() : ino_t{0};
    const pid_t child = start(words);
    const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(moment(random));
    std::pair<size_t, size_t> written{0, 0};
    if (!going_on) std::remove(file.c_str());
    while (std::chrono::steady_clock::now() < until) {
      usleep(2000);
      try {
        if (number() != old) written = std::max(written, rows(file));
      } catch (const std::exception&) {  // no file yet
      }
    }
    kill(child, SIGKILL);
    const int code = wait_for(child);
    if (access(file.c_str(), F_OK)) continue;  // killed before it began
    const Results part = read(file);
    EXPECT_GE(part.output_times.size(), written.first);
    EXPECT_GE(part.step_times.size(), written.second);
    expect_beginning(whole, part);
    if (code == -SIGKILL) {
      ++kills;
      restarts += going_on;
    } else {
      // This run ended normally, after one kill or several.
      ASSERT_EQ(code, 0);
      ++ends;
      EXPECT_EQ(part.output_times.size(), whole.output_times.size());
      EXPECT_EQ(part.step_times.size(), whole.step_times.size());
      EXPECT_EQ(part.summary, whole.summary);
      EXPECT_EQ(part.ended, whole.ended);
      EXPECT_EQ(part.open, whole.open);
      std::remove(file.c_str());
    }
    if (HasFailure()) FAIL() << "after kill " << kills;
  }
  std::printf("%d kills, %d of them of runs that went on from a killed one, %d runs came to their end\n",
              kills, restarts, ends);
  EXPECT_GE(kills, 10);
  EXPECT_GE(restarts, 3);
  EXPECT_GE(ends, 2);
}

}  // namespace
}  // namespace hawser::runs::kill_test
