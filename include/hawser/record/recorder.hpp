// What a run leaves behind: node fields, histories of named points at every step, the energy audit, and the
// extremes over the run.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/record/audit.hpp"
#include "hawser/record/clash_report.hpp"
#include "hawser/record/clearances.hpp"
#include "hawser/record/contact_peaks.hpp"
#include "hawser/record/element_errors.hpp"
#include "hawser/record/end_forces.hpp"
#include "hawser/record/folds.hpp"
#include "hawser/record/histories.hpp"
#include "hawser/record/line_extremes.hpp"
#include "hawser/record/node_statistics.hpp"
#include "hawser/record/pipe_strength.hpp"
#include "hawser/record/snaps.hpp"
#include "hawser/record/stations.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/record/support_log.hpp"
#include "hawser/record/touchdown.hpp"
#include "hawser/record/utilisation.hpp"
#include "hawser/record/water_errors.hpp"

namespace hawser::record {

class Recorder {
 public:
  // Starts a new results file. `from`: the checkpoint the run goes on from, if it does; `append`: in the file
  // that holds it, else in a new one. write: false makes no file,
  // and only contents() and save() may follow.
  Recorder(Subject subject, std::vector<io::VolumeMesh> volumes, const io::RunInfo& run,
           const io::Checkpoint* from = nullptr, bool append = false, bool write = true);

  // What the file holds, or would.
  const io::ResultContents& contents() const { return file_ ? file_->contents() : planned_; }

  // The rest `at` of a stage of statics but the last, by its place: an output at a negative time.
  void stage(size_t place, const Kinematics& at);
  // The beginning of a run: the state `at`, from which energies count and which may move already, and the one
  // that is shown for it, the first step and output: its static equilibrium where there is one.
  void start(const Kinematics& at, const Kinematics& shown);
  // Every accepted step: histories, extremes, statistics, audit. Collective only in the audit.
  void step(const StepInfo& info, const Kinematics& at, double support_work);
  // A picture of the state: all fields. Where there was a step, it is of the last one.
  void output(const Kinematics& at);
  // With it the statistics so far.
  void checkpoint(io::Checkpoint c);
  // Writes the summary table into the file, with the notes and warnings that were told of the run and those
  // of its end; returns the table as text.
  std::string finish(std::vector<std::string> messages);

  const Audit& audit() const { return audit_; }
  std::string audit_warning() const;  // Audit::warning in words of this case
  // The clash report in words, on rank 0 after finish(); empty: nothing touched.
  std::string clash_table() const { return clashes_ ? clashes_->table() : ""; }
  // What a user must not overlook, after finish(): deep penetration, energy out of nowhere.
  const std::vector<std::string>& warnings() const { return warnings_; }
  const io::ResultsFile& file() const { return *file_; }

  // The recorder's own share of a checkpoint. Collective.
  void save(io::Checkpoint& to);

 private:
  void restore(const io::Checkpoint& from);
  void fill(const Kinematics& at, bool all);
  void fill_field(size_t f, const Kinematics& at);
  void find_worst(const Kinematics& at);
  void look_at_elements(const Kinematics& at);
  std::string peak_warning(const io::SummaryRow& largest_tension) const;
  std::string compressed(const io::SummaryRow& least_tension) const;
  void gather_warnings(const std::vector<io::SummaryRow>& rows);
  double passed_through(double h) const;
  void correct_ends(const Kinematics& at);
  void step(const StepInfo& info, const Kinematics& at, double support_work, const Kinematics& shown);
  void append_rows(const StepInfo& info, const Kinematics& at);
  void write_statistics();
  bool shows_touchdowns() const;
  PipePlaces pipe_places(const Kinematics& at);

  const Subject subject_;
  const MPI_Comm comm_;
  const Feeders* feeders_;  // null: no line is fed
  FieldRegistry registry_;
  std::vector<char> every_step_;  // by field of the registry: wanted at every step, not only at outputs
  bool rest_apart_ = false;       // correct_ends() changes none but these
  bool stepped_ = false;          // values_ have them of the last step
  std::vector<int> onto_;         // likewise: among values_, the field it is computed from; -1: none
  EndForces end_forces_;
  ContactPeaks peaks_;
  std::vector<std::vector<double>> values_;  // position, velocity, the registry's fields, utilisations
  std::vector<std::vector<double>> ends_;    // force, direction, moment, of the owned ends in file order
  std::vector<io::ResultField> fields_;
  // Among values_.
  int tension_ = -1, before_ = -1, after_ = -1, wall_ = -1, shear_ = -1, torsion_ = -1, moment_ = -1,
      moment_2_ = -1, moment_3_ = -1, pressed_ = -1, declination_ = -1;
  std::vector<int> touches_;   // likewise, not zero where something touches a line
  std::vector<int> carriers_;  // likewise
  std::unique_ptr<Histories> histories_;
  std::unique_ptr<LineExtremes> extremes_;
  std::unique_ptr<NodeStatistics> statistics_;   // null: not wanted
  std::unique_ptr<Stations> stations_;           // likewise
  std::unique_ptr<NodeStatistics> at_stations_;  // likewise
  ElementErrors element_errors_;
  WaterErrors water_errors_;
  Folds folds_;
  Snaps snaps_;
  Utilisation utilisation_;
  PipeStrength pipes_;
  Touchdowns touchdowns_;
  Clearances clearances_;
  std::unique_ptr<SupportLog> supports_;           // null: the case has none
  std::vector<std::vector<double>> support_rows_;  // of the last step
  double rows_every_ = 0, rows_from_ = 0;          // s, of the histories; 0: every step
  std::unique_ptr<ClashReport> clashes_;           // null: nothing can touch
  std::unique_ptr<io::ResultsFile> file_;
  io::ResultContents planned_;  // where there is no file
  Audit audit_;
  std::vector<std::string> warnings_;
  Energy start_;  // energies at the start of the run, that of before all restarts
};

}  // namespace hawser::record
