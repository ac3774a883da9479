// Progress of a run: a rewritten line on a terminal, otherwise occasional lines.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace hawser::run {

class Progress {
 public:
  // Only rank 0 prints.
  explicit Progress(bool print_lines);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Announces an operation of about `seconds`: immediately on a terminal, otherwise only if it takes long.
  void busy(const std::string& text, double seconds_spent);
  // Progress of statics; residual: relative to the forces.
  void statics(int iterations, int relaxation_steps, double residual);
  // Start of the steps: simulated times of the first and last one [s]; earlier time does not count for the
  // remaining-time estimate.
  void begin(double time, double end);
  void step(double time, double step, int iterations);
  // Prints a separate line and keeps the rewritten one intact.
  void print(const std::string& text);
  // Lines "note: ..." and "warning: ...".
  void print_notes(const std::vector<std::string>& notes);
  void print_warnings(const std::vector<std::string>& warnings);
  // Printed notes and warnings.
  const std::vector<std::string>& messages() const { return messages_; }
  void end();
  ~Progress() { end(); }

 private:
  using Clock = std::chrono::steady_clock;
  bool prints_;
  int columns_;  // of the terminal; 0: no terminal
  double start_ = 0, duration_ = 0;
  Clock::time_point began_ = Clock::now();
  Clock::time_point last_ = Clock::now();
  double next_fraction_ = 0.1;
  std::vector<std::string> messages_;
  void rewrite(std::string text);
  bool line_shown_ = false;   // the rewritten line is on the terminal
  bool replaceable_ = false;  // it is removed before other messages, not kept
};

// "1:02:03" or "0:05".
std::string clock_text(double seconds);

}  // namespace hawser::run
