// How far the run is: one line rewritten on a terminal, plain lines now and then elsewhere.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace hawser::run {

class Progress {
 public:
  // Only rank 0 speaks.
  explicit Progress(bool print_lines);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // What begins now and takes about so many seconds: at once on a terminal, elsewhere when it takes long.
  void busy(const std::string& what, double seconds);
  // How far statics is; residual: over the size of the forces.
  void statics(int iterations, int relaxation_steps, double residual);
  // The steps begin at this simulated time and end at that one [s]: what came before does not count for the
  // time left.
  void begin(double time, double end);
  void step(double time, double step, int iterations);
  // A line of its own, not lost in the rewritten one.
  void print(const std::string& text);
  // Lines "note: ..." and "warning: ...".
  void print_notes(const std::vector<std::string>& notes);
  void print_warnings(const std::vector<std::string>& warnings);
  // What has been said of notes and warnings.
  const std::vector<std::string>& messages() const { return messages_; }
  void end();
  ~Progress() { end(); }

 private:
  using Clock = std::chrono::steady_clock;
  bool prints_;
  int columns_;  // of the terminal; 0: none
  double start_ = 0, duration_ = 0;
  Clock::time_point began_ = Clock::now(), last_ = Clock::now();
  double next_share_ = 0.1;
  std::vector<std::string> messages_;
  void rewrite(std::string text);
  bool open_ = false;     // a rewritten line stands on the terminal
  bool passing_ = false;  // and is of no interest once something else is said
};

// "1:02:03" or "0:05".
std::string clock_text(double seconds);

}  // namespace hawser::run
