// The search for one length, that of a section or of what is inside a feeder, with which a line has at rest
// what its case asks for.
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

// What targets are about, on every rank.
struct AtRest {
  std::vector<double> ends;             // tension [N] and declination [rad] at end A and end B of every line
  std::vector<double> feeders;          // N, what each feels
  std::vector<record::Touchdown> down;  // of every line
};
// Collective.
AtRest at_rest(MPI_Comm comm, Simulation& sim);

class LengthSearch {
 public:
  // Of the section of a line with a `target`.
  LengthSearch(const model::Case& c, size_t line);
  // Of the stock of a feeder that keeps a tension, the one of that number in the case.
  LengthSearch(const model::Case& c, size_t line, bool at_b, int feeder);

  const std::string& key() const { return key_; }
  double length() const { return length_; }
  bool met() const { return met_; }

  // The next trial; a line that is met stays as it is.
  void choose() { length_ = search_.next(); }
  // What the trial has brought. Whether it has parted from a target that was met.
  bool update(const AtRest& now);
  // How far the value is from the target: of the tension, rad, or of the line's length.
  double error() const;
  // The length and the value that it has, in a sentence.
  std::string now(const model::Case& c) const;
  void go_on() { search_.add(value_ - t_.value); }
  void fail(const std::string& why) {
    if (why_.empty() || !search_.values().empty()) why_ = why;  // where none is known, of what is given
    search_.fail();
  }
  // Restarts from the last length with an equilibrium.
  void restart();
  // Whether the search has failed: no root found, or a jump across it.
  bool stuck() const { return search_.exhausted() || (narrow() && !near_); }
  // There is no such length. InputError that says why; a feeder begins with its stock as it is given.
  void throw_not_found(const model::Case& c);

  // What was found, in so many statics.
  std::string found(const model::Case& c, int trials) const;

 private:
  void begin(double from, double step);
  double reached(const AtRest& now) const;
  advice::LengthSearched searched(const model::Case& c) const;
  advice::LengthsTried tried() const;
  bool narrow() const;

  size_t line_;
  model::LengthTarget t_;
  int feeder_ = -1;  // -1: of a section
  std::string key_;
  double given_, rest_;  // m, as given; of the sections that stay
  RootSearch search_{1, 1, 0, 2};
  double length_ = 0, value_ = 0, last_found_ = 0;  // m; its value; m, with which statics was found last
  bool met_ = false, near_ = false, failed_ = false;
  std::string why_;
};

}  // namespace hawser::run
