// Recorder of a run: node fields at outputs, and all recordings (recording.hpp).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hawser/io/results.hpp"
#include "hawser/record/node_fields.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/record/touchdown.hpp"

namespace hawser::record {

// File of a Recorder: a new one, that of the checkpoint from which the run continues, or none, after which
// only contents() and save() may follow.
enum class RecorderFile { create, append, none };

class Recorder {
 public:
  // from: the checkpoint from which the run continues; null: none.
  Recorder(Subject subject, std::vector<io::VolumeMesh> volumes, io::RunInfo run,
           RecorderFile use = RecorderFile::create, const io::Checkpoint* from = nullptr);

  // Contents of the file, or of the file that would be written.
  const io::ResultContents& contents() const { return file_ ? file_->contents() : planned_; }

  // Equilibrium `state` of a stage of statics except the last, by its index; written as an output at a
  // negative time.
  void stage(size_t place, const Kinematics& state);
  // The start of a run, recorded as first step and output: the static equilibrium if there is one.
  void start(const Kinematics& state);
  // Every accepted step. Collective.
  void step(const StepInfo& info, const Kinematics& state);
  // Writes all fields of a state; after a step it must be the state of that step.
  void output(const Kinematics& state);
  // Writes a checkpoint with the current statistics.
  void checkpoint(io::Checkpoint c);
  // Writes the summary table with the run's notes and warnings, and those of its end; returns the table as
  // text, on rank 0.
  std::string finish(std::vector<std::string> messages);

  const EnergyAudit& energy() const { return *recordings_.energy; }
  // Warnings since the last call to be reported before the run ends; on rank 0 at least.
  std::vector<std::string> remarks();
  // Tables of the recordings as text, on rank 0 after finish().
  std::vector<std::string> tables() const;
  // Warnings for the user after finish(), for example deep penetration or created energy; on rank 0.
  const std::vector<std::string>& warnings() const { return warnings_; }
  const io::ResultsFile& file() const { return *file_; }

  // Adds the recorder's part of a checkpoint. Collective.
  void save(io::Checkpoint& to);

 private:
  io::ResultContents declared(std::vector<io::VolumeMesh> volumes, io::RunInfo run);
  void restore(const io::Checkpoint& from);
  Snapshot snapshot(const Kinematics& state, const StepInfo& info = {}) const;
  void fill(const Snapshot& s, FieldsFilled which);
  std::vector<io::SummaryRow> gather_summary();
  void write_output(double time, const Snapshot& s, const io::ClashTables& clashes);
  io::ClashTables take_clashes();

  const Subject subject_;
  const Touchdowns touchdowns_;
  NodeFields fields_;
  Recordings recordings_;
  bool stepped_ = false;               // field values are those of the last step
  double rows_every_, rows_from_ = 0;  // s, for the histories; 0: every step
  std::unique_ptr<io::ResultsFile> file_;
  io::ResultContents planned_;  // contents without a file
  std::vector<std::string> warnings_;
};

}  // namespace hawser::record
