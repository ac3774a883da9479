// Schedules a repeated task so that it takes no more than a given fraction of the time.
#pragma once

#include <chrono>

namespace hawser {

class ShareOfTime {
 public:
  explicit ShareOfTime(double fraction) : fraction_(fraction) {}
  // True if enough time has passed since the last run of the task, relative to its cost.
  bool due() const { return fraction_ * seconds_since(end_) >= cost_; }
  template <class Task>
  void spend(const Task& task) {
    const Clock::time_point start = Clock::now();
    task();
    cost_ = seconds_since(start);
    end_ = Clock::now();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point t) {
    return std::chrono::duration<double>(Clock::now() - t).count();
  }
  double fraction_, cost_ = 0;  // cost_: s
  Clock::time_point end_ = Clock::now();
};

}  // namespace hawser
