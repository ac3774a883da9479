// How far the run is: one line rewritten on a terminal, plain lines now and then elsewhere.
#pragma once

#include <chrono>
#include <string>

namespace hawser::app {

class Progress {
 public:
  // Only rank 0 speaks. `duration`: the simulated time at the end, s.
  Progress(bool speak, double duration);

  // The steps begin at this simulated time [s]: what came before does not count for the time left.
  void begin(double time);
  void step(double time, double step, int iterations);
  // A line of its own, not lost in the rewritten one.
  void say(const std::string& text);
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  bool speak_;
  int columns_;  // of the terminal; 0: none
  double start_ = 0, duration_;
  Clock::time_point began_ = Clock::now(), last_ = Clock::now();
  double next_share_ = 0.1;
  bool open_ = false;  // a rewritten line stands on the terminal
};

// "1:02:03" or "0:05".
std::string clock_text(double seconds);

}  // namespace hawser::app
