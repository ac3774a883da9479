// Warnings of tension peaks that time steps or elements do not resolve.
#pragma once

#include "hawser/record/audit.hpp"
#include "hawser/record/edge_errors.hpp"
#include "hawser/record/folds.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/snaps.hpp"
#include "hawser/record/subject.hpp"

namespace hawser::record {

class TensionPeaks : public Recording {
 public:
  // errors: contact of lines with volumes, updated before this recording; null: none. All must outlive the
  // object.
  TensionPeaks(const Subject& subject, const EdgeErrors* errors, const Audit& audit);

  void declare(Declarations& to) override;
  void step(const Snapshot& s) override;
  std::vector<Warning> warnings(const std::vector<io::SummaryRow>& summary) override;

 private:
  const Subject& subject_;
  const EdgeErrors* errors_;
  const Audit& audit_;
  Folds folds_;
  Snaps snaps_;
  int before_ = -1, after_ = -1;  // indices of fields
};

}  // namespace hawser::record
