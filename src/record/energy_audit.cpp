// The class EnergyAudit: sums of the energies of a step over the ranks, and the place where a step created
// most energy. The figures and their limits are in audit.cpp.
#include "hawser/record/energy_audit.hpp"

#include <cmath>
#include <utility>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/record/audit_checkpoint.hpp"
#include "hawser/record/node_fields.hpp"

namespace hawser::record {

EnergyAudit::EnergyAudit(const Subject& subject, NodeFields& fields)
    : subject_(subject), fields_(fields), feeders_(subject.term<Feeders>()) {}

void EnergyAudit::declare(Declarations& to) {
  io::ResultSeries energy{"energy", {}};
  for (const char* name :
       {"kinetic", "strain", "potential", "friction", "damping", "brought_in", "error", "unresolved"})
    energy.columns.push_back({name, "J", 1});
  to.contents.series.push_back(std::move(energy));
}

// The energies of a run with motion are those of its state, which has initial velocities where the recorded
// start is at rest.
void EnergyAudit::step(const Snapshot& s) {
  const bool moves = subject_.model.dynamics.enabled;
  Energy local = subject_.system.energy(moves ? subject_.dynamics().committed_kinematics() : s.at);
  if (moves) local.work += subject_.dynamics().support_work();
  const Energy now = sum_of(subject_.comm(), local);
  if (s.step.h == 0) start_ = now;
  double passed = 0;
  if (feeders_) passed += feeders_->passed_through(s.end_forces.at_feeders(), s.step.h);
  if (audit_.update(start_, now, s.step.time, s.step.h, passed) && s.step.h > 0) find_worst(s);
}

// Finds the place where the step with most created energy changed the motion most, and the force there.
void EnergyAudit::find_worst(const Snapshot& s) {
  using With = Audit::Step::ContactWith;
  fields_.fill(s.at, FieldsFilled::all);
  const NodeValue change = subject_.dynamics().largest_acceleration_change();
  int with = 0;
  const int n = subject_.local().find(change.node);
  if (subject_.local().owns(n))
    for (size_t f = 0; f < s.values.size() && with == 0; ++f) {
      const Field& field = fields_.fields()[f];
      double size = 0;
      for (int c = 0; c < field.components; ++c) size += std::abs(s.values[f][n * field.components + c]);
      if (size != 0) with = static_cast<int>(field.contact_with);
    }
  all_reduce(subject_.comm(), MPI_MAX, with);
  audit_.located(change.node, static_cast<With>(with));
}

void EnergyAudit::rows(const Snapshot&, Rows& to) {
  const Energy& e = audit_.now;
  std::vector<double> row;
  if (rank_of(subject_.comm()) == 0)
    row = {e.kinetic, e.strain,          e.potential,  e.friction,
           e.damping, audit_.brought_in, audit_.error, e.unresolved};
  to.add(std::move(row));
}

std::string EnergyAudit::warning() const {
  if (rank_of(subject_.comm()) != 0) return "";
  const int node = audit_.worst.node;
  const model::Case& c = subject_.model;
  return audit_.warning(advice::step_choice(c), node < 0 ? "a body" : subject_.mesh().place(node),
                        advice::initial_velocity_key(c));
}

void EnergyAudit::save(io::Checkpoint& to) { save_audit(start_, audit_, to); }

void EnergyAudit::restore(const io::Checkpoint& from) { restore_audit(from, start_, audit_); }

}  // namespace hawser::record
