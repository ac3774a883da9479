// What every recording of a run is: it declares what it keeps, sees every accepted step, and has rows in the
// results file, numbers in checkpoints and findings at the end. The recorder knows recordings by this alone;
// src/record/recordings.cpp lists them.
#pragma once

#include <mpi.h>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "hawser/io/checkpoint.hpp"
#include "hawser/io/results.hpp"
#include "hawser/record/audit.hpp"
#include "hawser/record/end_forces.hpp"
#include "hawser/record/subject.hpp"

namespace hawser::record {

using Values = std::vector<std::vector<double>>;  // by field, of this rank's owned nodes or ends

// The rows of a step, one for each series.
class Rows {
 public:
  // Complete on this rank; empty where another rank has it.
  void add(std::vector<double> row) { rows_.push_back(std::move(row)); }
  // This rank's part, as long as on all ranks; rank 0 gets the sum.
  void add_part(std::vector<double> part) {
    parts_.push_back(rows_.size());
    rows_.push_back(std::move(part));
  }
  // With the sums, in one reduction for the parts of all recordings. Collective.
  std::vector<std::vector<double>> gathered(MPI_Comm comm) &&;

 private:
  std::vector<std::vector<double>> rows_;
  std::vector<size_t> parts_;  // their places among the rows
};

// An accepted state with what is known of it.
class Snapshot {
 public:
  Snapshot(const Subject& subject, const Kinematics& state, const StepInfo& info, double forces_step,
           const Values& of_nodes, const Values& of_ends, const EndForces& forces, const Audit& energies)
      : at(state),
        step(info),
        moving_step(forces_step),
        values(of_nodes),
        ends(of_ends),
        end_forces(forces),
        audit(energies),
        subject_(subject) {}

  const Kinematics& at;
  const StepInfo step;       // that led to this state; of length 0: none did
  const double moving_step;  // s, of the forces that belong to its accelerations; 0: it is at rest in statics
  const Values &values, &ends;
  const EndForces& end_forces;
  const Audit& audit;
  // Of the bodies of the case. Collective.
  const std::vector<io::BodyPose>& poses() const {
    if (!poses_) poses_ = body_poses(subject_.bodies, subject_.system, at);
    return *poses_;
  }

 private:
  const Subject& subject_;
  mutable std::optional<std::vector<io::BodyPose>> poses_;
};

// What recordings put into the results file, and fields that they need at every step: others have their
// values only at outputs.
struct Declarations {
  io::ResultContents contents;  // its fields are all there are; a recording adds series and the like
  std::set<std::string> every_step;
};

// What a user must not overlook, and the row of the summary that it is about.
struct Finding {
  static constexpr size_t kWholeRun = static_cast<size_t>(-1);
  std::string text;
  size_t row = kWholeRun;
};

class Recording {
 public:
  virtual ~Recording() = default;

  // Adds fields of nodes that are made from those before them; fill() computes their values.
  virtual void add_fields(std::vector<Field>& fields) { (void)fields; }
  virtual void fill(const Snapshot&, Values&) {}
  // Once, when all fields are known. Collective.
  virtual void declare(Declarations& to) { (void)to; }

  // Called with the equilibrium of each stage of statics but the last. Collective, as are the others.
  virtual void stage(const Snapshot& s) { (void)s; }
  // Called once, before the first step, with the equilibrium from which a run starts.
  virtual void start(const Snapshot& s) { (void)s; }
  virtual void step(const Snapshot& s) { (void)s; }
  virtual void output(const Snapshot& s) { (void)s; }
  // Adds the points of contact of an output or stage that this rank counts.
  virtual void points(const Snapshot&, io::ContactRows&) {}
  // Adds a row for each series that it declared; after step(), of steps that histories keep.
  virtual void rows(const Snapshot&, Rows&) {}
  // Sentences that a user needs before the run ends, since start() or step(); the same on all ranks.
  virtual std::vector<std::string> remarks() { return {}; }
  // Brings what the file has once, up to date.
  virtual void write(io::ResultsFile& file) { (void)file; }

  virtual void save(io::Checkpoint& to) { (void)to; }
  virtual void restore(const io::Checkpoint& from) { (void)from; }

  // At the end of a run: rows of the summary, the same on all ranks; then what was found, those about a row
  // on all ranks alike.
  virtual std::vector<io::SummaryRow> summary() { return {}; }
  virtual std::vector<Finding> findings(const std::vector<io::SummaryRow>& summary, const Audit& audit) {
    (void)summary;
    (void)audit;
    return std::vector<Finding>();
  }
};

// Has clashes, for which the results file has tables of their own.
class HasClashes {
 public:
  virtual ~HasClashes() = default;
  // Of rank 0: what the next output is to hold. Collective.
  virtual io::ClashTables take() = 0;
  // Of rank 0: what outputs have given the file so far. Another one begins with nothing.
  virtual const io::ReportedClashes& reported() const = 0;
  virtual void begin_file() = 0;
  // In words, on rank 0, after take(); empty: nothing touched.
  virtual std::string table() const = 0;
};

// All recordings of a case, in the order of their series in the results file. Subject and forces outlive
// them. Collective.
std::vector<std::unique_ptr<Recording>> recordings(const Subject& subject, const EndForces& forces);

}  // namespace hawser::record
