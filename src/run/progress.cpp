// The class Progress: text and timing of messages about statics and time steps, estimate of the remaining
// time, and detection of a terminal.
#include "hawser/run/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "hawser/advice/run.hpp"
#include "hawser/base/count_of.hpp"

namespace hawser::run {
namespace {

constexpr double kRewriteEvery = 0.2, kLineEvery = 60;  // s: on a terminal; otherwise at most
constexpr double kLong = 2;                             // s without output if not on a terminal

// Columns of the terminal of stdout; 0: no terminal. mpirun gives its processes a pseudo-terminal even if its
// own output goes to a file, but without a size.
int terminal_columns() {
  if (!isatty(STDOUT_FILENO)) return 0;
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  if (known) return size.ws_col;
  return std::getenv("OMPI_COMM_WORLD_SIZE") ? 0 : 80;
}

double seconds(std::chrono::steady_clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

std::string clock_text(double seconds) {
  const long s = std::lround(std::clamp(seconds, 0.0, 1e9));
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

Progress::Progress(bool print_lines) : prints_(print_lines), columns_(terminal_columns()) {}

void Progress::rewrite(std::string text) {
  // A wrapped line cannot be rewritten.
  text.resize(std::min(text.size(), static_cast<size_t>(columns_ - 1)));
  std::fputs(fmt::format("\r\033[K{}", text).c_str(), stdout);
  std::fflush(stdout);
  line_shown_ = true;
}

void Progress::busy(const std::string& text, double seconds_spent) {
  if (!prints_) return;
  const auto now = Clock::now();
  if (columns_ > 0) {
    rewrite(text);
    replaceable_ = true;
  } else if (seconds_spent > kLong || seconds(now - last_) > kLong) {
    std::puts(text.c_str());
    std::fflush(stdout);
  } else {
    return;
  }
  last_ = now;
}

void Progress::statics(int iterations, int relaxation_steps, double residual) {
  if (!prints_) return;
  const auto now = Clock::now();
  if (seconds(now - last_) < (columns_ > 0 ? kRewriteEvery : kLineEvery)) return;
  last_ = now;
  const std::string text = advice::statics_progress(iterations, relaxation_steps, residual);
  if (columns_ > 0) {
    rewrite(text);
    replaceable_ = true;
    return;
  }
  std::puts(text.c_str());
  std::fflush(stdout);
}

void Progress::begin(double time, double end) {
  start_ = time;
  duration_ = end;
  began_ = last_ = Clock::now();
  next_fraction_ = std::floor(10 * time / std::max(duration_, 1e-300) + 1e-9) / 10 + 0.1;
}

void Progress::step(double time, double step, int iterations) {
  if (!prints_) return;
  const double fraction = time / std::max(duration_, 1e-300);
  const auto now = Clock::now();
  const bool last = fraction >= 1 - 1e-9;
  const bool due = fraction >= next_fraction_ - 1e-9;
  const double silent = seconds(now - last_);
  if (columns_ > 0 ? silent < kRewriteEvery && !last : silent < kLineEvery && !due) return;
  last_ = now;
  // Extrapolates the rate so far.
  const double remaining = seconds(now - began_) * (duration_ - time) / std::max(time - start_, 1e-300);
  std::string text =
      fmt::format("t = {:.3f} of {:.6g} s ({:3.0f} %), step {:.3g} s, {}, {} left", time, duration_,
                  100 * fraction, step, count_of(iterations, "iteration"), clock_text(remaining));
  if (columns_ > 0) {
    rewrite(std::move(text));
    replaceable_ = false;
  } else {
    if (due) next_fraction_ = std::floor(fraction * 10 + 1e-9) / 10 + 0.1;
    std::puts(text.c_str());
    std::fflush(stdout);
  }
}

void Progress::print(const std::string& text) {
  if (text.starts_with("note: ") || text.starts_with("warning: ")) messages_.push_back(text);
  if (!prints_) return;
  end();
  std::puts(text.c_str());
  std::fflush(stdout);
}

void Progress::print_notes(const std::vector<std::string>& notes) {
  for (const std::string& n : notes) print(fmt::format("note: {}", n));
}

void Progress::print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& w : warnings) print(fmt::format("warning: {}", w));
}

void Progress::end() {
  if (!line_shown_) return;
  std::fputs(replaceable_ ? "\r\033[K" : "\n", stdout);
  std::fflush(stdout);
  line_shown_ = false;
}

}  // namespace hawser::run
