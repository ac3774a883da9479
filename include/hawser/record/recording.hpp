// Interface of all recordings of a run: a recording declares its data, receives every accepted step, and
// contributes rows of the results file, numbers in checkpoints and warnings at the end. The recorder uses
// only this interface; src/record/recording_list.cpp lists the recordings.
#pragma once

#include <mpi.h>

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/io/results.hpp"
#include "hawser/record/end_forces.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/record/touchdown.hpp"
#include "hawser/terms/active_contact.hpp"

namespace hawser::record {

using Values = std::vector<std::vector<double>>;  // by field, over this rank's owned nodes or ends

// Rows of a step, one per series.
class Rows {
 public:
  // Adds a row that is complete on this rank; empty if another rank has it. Of a series by line: the values
  // of this rank's lines.
  void add(std::vector<double> row) { rows_.push_back(std::move(row)); }
  // Adds this rank's part of a row, of equal length on all ranks; rank 0 gets the sum.
  void add_part(std::vector<double> part) {
    parts_.push_back(rows_.size());
    rows_.push_back(std::move(part));
  }
  // All rows, with one reduction for the parts of all recordings. Collective.
  std::vector<std::vector<double>> gathered(MPI_Comm comm) &&;

 private:
  std::vector<std::vector<double>> rows_;
  std::vector<size_t> parts_;  // their indices in rows_
};

// An accepted state and its data.
class Snapshot {
 public:
  Snapshot(const Subject& subject, const Touchdowns& touchdowns, const Kinematics& state,
           const StepInfo& info, const Values& of_nodes, const Values& of_ends, const EndForces& forces)
      : at(state),
        step(info),
        values(of_nodes),
        ends(of_ends),
        end_forces(forces),
        subject_(subject),
        finder_(touchdowns) {}

  const Kinematics& at;
  const StepInfo step;  // step that led to this state; of length 0: none
  const Values &values, &ends;
  const EndForces& end_forces;
  // Values of a field on the owned nodes by its index among the declared fields; empty for an index of -1.
  std::span<const double> field(int index) const {
    if (index < 0) return {};
    return values[static_cast<size_t>(index)];
  }
  // Poses of the bodies of the case. Collective.
  const std::vector<io::BodyPose>& poses() const {
    if (!poses_) poses_ = body_poses(subject_.bodies, subject_.system, at);
    return *poses_;
  }
  // Contacts of lines with volumes that this rank counts; volumes are those of the term.
  const ActiveContacts& volume_contacts() const;
  // Touchdowns::find of the state. Collective.
  const std::vector<Touchdown>& touchdowns() const {
    if (!touchdowns_) touchdowns_ = finder_.find(at);
    return *touchdowns_;
  }

 private:
  const Subject& subject_;
  const Touchdowns& finder_;
  mutable std::optional<std::vector<io::BodyPose>> poses_;
  mutable std::optional<ActiveContacts> volume_contacts_;
  mutable std::optional<std::vector<Touchdown>> touchdowns_;
};

// Contributions of recordings to the results file, and fields needed at every step; other fields are computed
// only at outputs.
struct Declarations {
  io::ResultContents contents;  // its fields are complete; a recording adds series and the like
  std::set<std::string> every_step;
};

// A warning for the user, and the row of the summary it refers to.
struct Warning {
  static constexpr size_t kWholeRun = static_cast<size_t>(-1);
  std::string text;
  size_t row = kWholeRun;
};

class Recording {
 public:
  virtual ~Recording() = default;

  // Adds node fields computed from those before them; fill() computes their values.
  virtual void add_fields(std::vector<Field>&) {}
  virtual void fill(const Snapshot&, Values&) {}
  // Called once, with all fields known. Collective.
  virtual void declare(Declarations&) {}

  // Called with the equilibrium of each stage of statics except the last. Collective, as are the others.
  virtual void stage(const Snapshot&) {}
  // Called once before the first step, with the initial equilibrium.
  virtual void start(const Snapshot&) {}
  virtual void step(const Snapshot&) {}
  virtual void output(const Snapshot&) {}
  // Adds the clashes for the file since the last call, at outputs and at the end; on rank 0.
  virtual void take_clashes(io::ClashTables&) {}
  // Adds the points of contact of an output or stage that this rank counts.
  virtual void points(const Snapshot&, io::ContactRows&) {}
  // Adds a row for each series that it declared; after step(), for steps in histories.
  virtual void rows(const Snapshot&, Rows&) {}
  // Sentences for the user since start() or step(), before the run ends; on rank 0 at least.
  virtual std::vector<std::string> remarks() { return {}; }
  // Updates data that the file has once.
  virtual void write(io::ResultsFile&) {}

  virtual void save(io::Checkpoint&) {}
  virtual void restore(const io::Checkpoint&) {}
  // After restore(), if the run continues in a new file, which has nothing of the earlier steps.
  virtual void begin_file() {}
  // Adds the clashes in the file in which the run continues; on rank 0.
  virtual void add_reported(io::ReportedClashes&) const {}

  // At the end of a run: rows of the summary, each on the rank that owns the first node of its line; then
  // warnings, about a row on its rank, about the whole run on one rank. `summary`: the rows of this rank.
  virtual std::vector<io::SummaryRow> summary() { return {}; }
  virtual std::vector<Warning> warnings(const std::vector<io::SummaryRow>& /*summary*/) { return {}; }
  // A table for the user after the last take_clashes(), on rank 0; empty: none.
  virtual std::string table() const { return {}; }
};

class EnergyAudit;
class NodeFields;

// All recordings of a case, in the order of their series in the results file.
struct Recordings {
  std::vector<std::unique_ptr<Recording>> all;
  const EnergyAudit* energy = nullptr;  // one of them
  auto begin() const { return all.begin(); }
  auto end() const { return all.end(); }
};

// Subject and fields outlive the recordings. Collective.
Recordings recordings(const Subject& subject, NodeFields& fields);

}  // namespace hawser::record
