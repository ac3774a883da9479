// Recorder of a run: node fields at outputs, the energy audit, and all recordings (recording.hpp).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/record/audit.hpp"
#include "hawser/record/node_fields.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"

namespace hawser::record {

class Recorder {
 public:
  // Starts a new results file. `from`: the checkpoint the run goes on from, if it does; `append`: in the file
  // that holds it, else in a new one. write: false makes no file, and only contents() and save() may follow.
  Recorder(Subject subject, std::vector<io::VolumeMesh> volumes, io::RunInfo run,
           const io::Checkpoint* from = nullptr, bool append = false, bool write = true);

  // Contents of the file, or of the file that would be written.
  const io::ResultContents& contents() const { return file_ ? file_->contents() : planned_; }

  // Equilibrium `at` of a stage of statics except the last, by its index; written as an output at a negative
  // time.
  void stage(size_t place, const Kinematics& at);
  // The beginning of a run: the state `at`, from which energies count and which may move already, and the one
  // that is shown for it, the first step and output: its static equilibrium where there is one. Where it is
  // the motion that is shown, first_step [s] is the step of the forces that its accelerations are of, else 0.
  void start(const Kinematics& at, const Kinematics& shown, double first_step = 0);
  // Every accepted step. Collective.
  void step(const StepInfo& info, const Kinematics& at, double support_work) {
    step(info, at, support_work, at, at.step);
  }
  // Writes all fields of a state; after a step it must be the state of that step.
  void output(const Kinematics& at);
  // Writes a checkpoint with the current statistics.
  void checkpoint(io::Checkpoint c);
  // Writes the summary table with the run's notes and warnings, and those of its end; returns the table as
  // text, on rank 0.
  std::string finish(std::vector<std::string> messages);

  const Audit& audit() const { return audit_; }
  std::string audit_warning() const;  // Audit::warning with the names of this case
  // Findings since the last call that a user should get before the run ends; the same on all ranks.
  std::vector<std::string> remarks();
  // Clash report as text, on rank 0 after finish(); empty: no clashes.
  std::string clash_table() const { return clashes_ ? clashes_->table() : ""; }
  // Warnings for the user after finish(), for example deep penetration or created energy; on rank 0.
  const std::vector<std::string>& warnings() const { return warnings_; }
  const io::ResultsFile& file() const { return *file_; }

  // Adds the recorder's part of a checkpoint. Collective.
  void save(io::Checkpoint& to);

 private:
  io::ResultContents declared(std::vector<io::VolumeMesh> volumes, io::RunInfo run);
  void restore(const io::Checkpoint& from);
  Snapshot snapshot(const Kinematics& at, const StepInfo& info = {}, double moving_step = 0) const;
  void fill(const Snapshot& s, bool all);
  void find_worst(const Snapshot& s);
  std::vector<io::SummaryRow> gather_summary();
  double passed_through(double h) const;
  void step(const StepInfo& info, const Kinematics& at, double support_work, const Kinematics& shown,
            double moving_step);
  void write_output(double time, const Snapshot& s, const io::ClashTables& clashes);
  io::ClashTables take_clashes() { return clashes_ ? clashes_->take() : io::ClashTables{}; }

  const Subject subject_;
  NodeFields fields_;
  std::vector<std::unique_ptr<Recording>> recordings_;
  HasClashes* clashes_ = nullptr;      // the recording with clashes; null: none
  bool stepped_ = false;               // field values are those of the last step
  double rows_every_, rows_from_ = 0;  // s, for the histories; 0: every step
  std::unique_ptr<io::ResultsFile> file_;
  io::ResultContents planned_;  // contents without a file
  // Not a recording: recordings may use it, its sums over ranks come first in a step, and it decides whether
  // the run has failed.
  Audit audit_;
  Energy start_;  // energies at the original start, before all restarts
  std::vector<std::string> warnings_;
};

}  // namespace hawser::record
