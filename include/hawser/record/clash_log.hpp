// Clashes: time intervals in which a pair is in contact, assembled from the contacts of each step.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "hawser/base/runs.hpp"
#include "hawser/io/clash_rows.hpp"
#include "hawser/system/checkpoint_record.hpp"
#include "hawser/terms/active_contact.hpp"

namespace hawser::record {

struct ClashSettings {
  double merge_gap = 0.1;     // s: a shorter separation does not end a clash
  Runs<double> merge_length;  // m, by line: places closer along it count as one
};

// Contacts sorted by pair and place; those of a pair closer along `line` than the merge length are merged:
// forces and energies add, the largest penetration is kept.
ActiveContacts merge_contacts(ActiveContacts touches, const Runs<double>& merge_length);

class ClashLog {
 public:
  explicit ClashLog(ClashSettings settings) : settings_(std::move(settings)) {}

  // Adds all contacts at `time` [s], later than the previous step; touches: result of merge_contacts().
  //
  // A contact continues the clash of its pair whose places at the last contact it overlaps or approaches
  // within the merge length. A contact that matches several joins them into the earliest. A clash whose place
  // splits stays one. Impulses are integrated by the trapezoidal rule; a clash begins and ends with the first
  // and last step in contact.
  void step(double time, std::span<const ActiveContact> touches);

  // Ongoing clashes by start time.
  std::vector<io::ClashRow> open() const;
  // Clashes for an output: those that ended since the last call, and open().
  io::ClashTables take();
  // Clashes passed to the current file by all calls. A new file begins with none.
  const io::ReportedClashes& reported() const { return reported_; }
  void begin_file() { reported_ = {}; }
  // Number of all clashes so far, the ended ones first, and those with the largest peak forces.
  long long count() const { return ended_count_ + static_cast<long long>(open_.size()); }
  std::vector<io::ClashRow> largest(size_t max_rows) const;

  // Complete state, a record of each kind at node 0, and its restoration, which throws std::invalid_argument
  // for invalid records.
  static std::vector<CheckpointKind> checkpoint_kinds();
  std::vector<CheckpointRecord> save() const;
  void restore(const std::vector<CheckpointRecord>& records);

 private:
  struct Open {
    io::ClashRow row;
    std::vector<std::pair<double, double>> places;  // m, at the last contact
    double force = 0;                               // N, at the last step; 0: currently no contact
  };
  // In a checkpoint the places of all open clashes follow each other in one record.
  struct KeptOpen {
    io::ClashRow row;
    double force = 0;  // N
    size_t places = 0;
    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      io::ClashRow::quantities(self.row, each);
      each("force", "N", self.force);
      each("places", "", self.places);
    }
  };
  struct KeptPlace {
    double from = 0, to = 0;  // m
    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("from", "m", self.from);
      each("to", "m", self.to);
    }
  };
  struct KeptSums {
    double time = 0;  // s
    long long ended = 0, reported_ended = 0;
    template <class Self, class Each>
    static void quantities(Self& self, Each&& each) {
      each("time", "s", self.time);
      each("ended", "", self.ended);
      each("reported ended", "", self.reported_ended);
    }
  };
  // State of an open clash at this step: its contacts combined, and their places. joined: merged into
  // another.
  struct Now {
    ActiveContact sum;
    std::vector<std::pair<double, double>> places;
    bool joined = false;
    void take(const ActiveContact& t);
  };
  // Assigns each contact to an open or a new clash.
  std::vector<Now> assign(double time, std::span<const ActiveContact> touches);
  void join(size_t first, size_t second, std::vector<Now>& now);
  // Updates the clashes with the contacts of a step, and ends those separated for too long.
  void update_tracks(double time, std::vector<Now> now);
  void end(const io::ClashRow& row);

  ClashSettings settings_;
  double time_ = std::numeric_limits<double>::quiet_NaN();  // of the last step
  std::vector<Open> open_;
  std::vector<io::ClashRow> ended_, largest_;  // since take(); of all ended ones, at most kKept
  io::ReportedClashes reported_;
  long long ended_count_ = 0;
};

}  // namespace hawser::record
