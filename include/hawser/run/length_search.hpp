// Search for one length, of a section or of a feeder's stock, at which a line meets its target at rest.
#pragma once

#include <mpi.h>

#include <string>
#include <vector>

#include "hawser/advice/lengths.hpp"
#include "hawser/math/root_search.hpp"
#include "hawser/model/case.hpp"
#include "hawser/record/touchdown.hpp"
#include "hawser/run/simulation.hpp"

namespace hawser::run {

// Values that targets may refer to, on every rank.
struct AtRest {
  std::vector<double> ends;             // tension [N] and declination [rad] at end A and end B of every line
  std::vector<double> feeders;          // force on each feeder, N
  std::vector<record::Touchdown> down;  // touchdown of every line
};
// Collective.
AtRest at_rest(MPI_Comm comm, Simulation& sim);

class LengthSearch {
 public:
  // Search for the section of a line with a `target`.
  LengthSearch(const model::Case& c, size_t line);
  // Search for the stock of a feeder with a tension set point; feeder: its index in the case.
  LengthSearch(const model::Case& c, size_t line, LineEnd line_end, int feeder);

  const std::string& key() const { return key_; }
  double length() const { return length_; }
  bool met() const { return met_; }

  // Chooses the next trial; a line that meets its target is not changed.
  void choose() { length_ = search_.next(); }
  // Updates the value of the trial. True: it has left a target that was met.
  bool update(const AtRest& now);
  // Distance of the value from the target: relative to the tension, in rad, or relative to the line's length.
  double error() const;
  // Sentence with the current length and value.
  std::string now(const model::Case& c) const;
  void add_value() { search_.add(value_ - t_.value); }
  void add_failure(const std::string& why) {
    if (why_.empty() || !search_.values().empty()) why_ = why;  // without a root so far: for the given length
    search_.fail();
  }
  // Restarts from the last length with an equilibrium.
  void restart();
  // No root was found, or a jump across it.
  bool failed() const { return search_.exhausted() || (narrow() && !near_); }
  // Throws InputError with the reason why there is no such length; a feeder keeps the length given instead.
  void end_without_length(const model::Case& c);

  // Sentence with the result after `trials` static analyses.
  std::string solved_sentence(const model::Case& c, int trials) const;

 private:
  void begin(double from, double step);
  double reached(const AtRest& now) const;
  advice::LengthSearched searched(const model::Case& c) const;
  advice::LengthsTried tried() const;
  bool narrow() const;

  size_t line_;
  model::LengthTarget t_;
  int feeder_ = -1;  // -1: a section
  std::string key_;
  double given_, other_sections_;  // m, given length; length of the other sections
  RootSearch search_{1, 1, 0, 2};
  double length_ = 0, value_ = 0, last_solved_ = 0;  // m; its value; m, last one with an equilibrium
  bool met_ = false, near_ = false, given_kept_ = false;
  std::string why_;
};

}  // namespace hawser::run
