// The energy audit of a run as a recording: energies of every step, their history, the note and the warning.
#pragma once

#include <string>
#include <vector>

#include "hawser/record/audit.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {

class EnergyAudit : public Recording {
 public:
  // fields: those of the recorder. Both must outlive the object.
  EnergyAudit(const Subject& subject, NodeFields& fields);

  const Audit& figures() const { return audit_; }
  // Audit::warning with the names of this case; empty on all ranks but the first.
  std::string warning() const;

  void declare(Declarations& to) override;
  // The first step, of length 0, has the energies from which the audit counts.
  void step(const Snapshot& s) override;
  void rows(const Snapshot& s, Rows& to) override;
  void save(io::Checkpoint& to) override;
  void restore(const io::Checkpoint& from) override;

 private:
  void find_worst(const Snapshot& s);

  const Subject& subject_;
  NodeFields& fields_;
  const Feeders* feeders_;  // null: no line is fed
  Audit audit_;
  Energy start_;  // energies at the original start, before all restarts
};

}  // namespace hawser::record
