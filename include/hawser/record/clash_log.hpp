// What touches, step after step, put together to clashes: intervals of time in which a pair is in contact.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "hawser/io/clash_rows.hpp"
#include "hawser/terms/active_contact.hpp"

namespace hawser::record {

struct ClashSettings {
  double merge_gap = 0.1;            // s: a pair that parts for less is still in the same clash
  std::vector<double> merge_length;  // m, by line: places nearer along it are one
};

// Touches sorted by pair and place, those of a pair that are nearer to each other along `line` than the merge
// length put together: forces and energies add, the largest penetration counts.
ActiveContacts put_together(ActiveContacts touches, const std::vector<double>& merge_length);

class ClashLog {
 public:
  explicit ClashLog(ClashSettings settings) : settings_(std::move(settings)) {}

  // All that touches at `time` [s], later than that of the step before; result of put_together().
  //
  // A place goes on with the clash of its pair whose places at the last touch it overlaps, or is nearer to
  // than the merge length. One that touches several joins them: the earliest goes on. A clash whose place
  // parts in several stays one. Impulses are trapezoids over the steps; a clash begins with the first step
  // that finds it touching and ends with the last one.
  void step(double time, std::span<const ActiveContact> touches);

  // Still going on, by start.
  std::vector<io::ClashRow> open() const;
  // For an output: those that ended since the last call, and open().
  io::ClashTables take();
  // What all calls have given the file that is being written. Another one begins with nothing.
  const io::ReportedClashes& reported() const { return reported_; }
  void begin_file() { reported_ = {}; }
  // Of all so far, the ended ones first: how many, and those with the largest peak forces.
  long long count() const { return ended_count_ + static_cast<long long>(open_.size()); }
  std::vector<io::ClashRow> largest(size_t most) const;

  // Everything, and back.
  std::vector<double> save() const;
  void restore(const std::vector<double>& values);  // std::invalid_argument when they are no such

 private:
  struct Open {
    io::ClashRow row;
    std::vector<std::pair<double, double>> places;  // m, of the last touch
    double force = 0;                               // N, at the last step; 0: does not touch at present
  };
  // What an open clash is at this step: its touches together and where they are. joined: with another.
  struct Now {
    ActiveContact sum;
    std::vector<std::pair<double, double>> places;
    bool joined = false;
    void take(const ActiveContact& t);
  };
  // Gives each touch to a clash, an open one or a new one.
  std::vector<Now> assign(double time, std::span<const ActiveContact> touches);
  void join(size_t first, size_t second, std::vector<Now>& now);
  // Takes a step's touches into the clashes; what was apart for too long ends.
  void follow(double time, std::vector<Now> now);
  void end(const io::ClashRow& row);

  ClashSettings settings_;
  double time_ = std::numeric_limits<double>::quiet_NaN();  // of the last step
  std::vector<Open> open_;
  std::vector<io::ClashRow> ended_, largest_;  // since take(); of all ended, at most kKept
  io::ReportedClashes reported_;
  long long ended_count_ = 0;
};

}  // namespace hawser::record
