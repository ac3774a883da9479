#include "hawser/app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace hawser::app {

std::string clock_text(double seconds) {
  const long s = std::lround(std::max(seconds, 0.0));
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

Progress::Progress(bool speak, double start, double duration)
    : speak_(speak), terminal_(isatty(STDOUT_FILENO)), start_(start), duration_(duration) {}

void Progress::step(double time, double step, int iterations) {
  if (!speak_) return;
  const double share = (time - start_) / std::max(duration_ - start_, 1e-300);
  const auto now = Clock::now();
  const double spent = std::chrono::duration<double>(now - began_).count();
  const std::string text = fmt::format(
      "t = {:.3f} of {:.6g} s ({:3.0f} %), step {:.3g} s, {} iterations, {} left", time, duration_,
      100 * share, step, iterations, clock_text(spent * (1 - share) / std::max(share, 1e-9)));
  if (terminal_) {
    if (std::chrono::duration<double>(now - last_).count() < 0.2 && share < 1) return;
    last_ = now;
    std::fputs(fmt::format("\r\033[K{}", text).c_str(), stdout);
    std::fflush(stdout);
    open_ = true;
  } else if (share >= next_share_ - 1e-9) {
    next_share_ = std::floor(share * 10 + 1e-9) / 10 + 0.1;
    std::puts(text.c_str());
    std::fflush(stdout);
  }
}

void Progress::say(const std::string& text) {
  if (!speak_) return;
  end();
  std::puts(text.c_str());
  std::fflush(stdout);
}

void Progress::end() {
  if (open_) std::fputc('\n', stdout);
  open_ = false;
}

}  // namespace hawser::app
