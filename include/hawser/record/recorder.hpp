// What a run leaves behind: node fields at outputs, the energy audit, and whatever its recordings keep
// (recording.hpp).
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

  // What the file holds, or would.
  const io::ResultContents& contents() const { return file_ ? file_->contents() : planned_; }

  // The rest `at` of a stage of statics but the last, by its place: an output at a negative time.
  void stage(size_t place, const Kinematics& at);
  // The beginning of a run: the state `at`, from which energies count and which may move already, and the one
  // that is shown for it, the first step and output: its static equilibrium where there is one. Where it is
  // the motion that is shown, first_step [s] is the step of the forces that its accelerations are of, else 0.
  void start(const Kinematics& at, const Kinematics& shown, double first_step = 0);
  // Every accepted step. Collective.
  void step(const StepInfo& info, const Kinematics& at, double support_work) {
    step(info, at, support_work, at, at.step);
  }
  // A picture of the state: all fields. Where there was a step, it is of the last one.
  void output(const Kinematics& at);
  // With it the statistics so far.
  void checkpoint(io::Checkpoint c);
  // Writes the summary table into the file, with the notes and warnings that were given during the run and
  // those of its end; returns the table as text.
  std::string finish(std::vector<std::string> messages);

  const Audit& audit() const { return audit_; }
  std::string audit_warning() const;  // Audit::warning in words of this case
  // What was found since the last call that a user should know before the run ends; the same on all ranks.
  std::vector<std::string> remarks();
  // The clash report in words, on rank 0 after finish(); empty: nothing touched.
  std::string clash_table() const { return clashes_ ? clashes_->table() : ""; }
  // What a user must not overlook, after finish(): deep penetration, energy out of nowhere.
  const std::vector<std::string>& warnings() const { return warnings_; }
  const io::ResultsFile& file() const { return *file_; }

  // The recorder's own share of a checkpoint. Collective.
  void save(io::Checkpoint& to);

 private:
  io::ResultContents declared(std::vector<io::VolumeMesh> volumes, io::RunInfo run);
  void restore(const io::Checkpoint& from);
  Snapshot snapshot(const Kinematics& at, const StepInfo& info = {}, double moving_step = 0) const;
  void fill(const Snapshot& s, bool all);
  void find_worst(const Snapshot& s);
  void gather_warnings(const std::vector<io::SummaryRow>& rows);
  double passed_through(double h) const;
  void step(const StepInfo& info, const Kinematics& at, double support_work, const Kinematics& shown,
            double moving_step);
  void write_output(double time, const Snapshot& s, const io::ClashTables& clashes);
  io::ClashTables take_clashes() { return clashes_ ? clashes_->take() : io::ClashTables{}; }

  const Subject subject_;
  NodeFields fields_;
  std::vector<std::unique_ptr<Recording>> recordings_;
  HasClashes* clashes_ = nullptr;      // the one of them that has some
  bool stepped_ = false;               // the values of fields are of the last step
  double rows_every_, rows_from_ = 0;  // s, of the histories; 0: every step
  std::unique_ptr<io::ResultsFile> file_;
  io::ResultContents planned_;  // where there is no file
  // Beside the recordings, which may go by it: its sums over the ranks come first in a step, and by them a
  // run fails or not.
  Audit audit_;
  Energy start_;  // energies at the start of the run, that of before all restarts
  std::vector<std::string> warnings_;
};

}  // namespace hawser::record
