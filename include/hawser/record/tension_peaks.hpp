// Warnings of tension peaks that time steps or elements do not resolve.
#pragma once

#include "hawser/record/edge_errors.hpp"
#include "hawser/record/folds.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/snaps.hpp"
#include "hawser/record/subject.hpp"

namespace hawser::record {

class TensionPeaks : public Recording {
 public:
  // errors: contact of lines with volumes, updated before this recording; null: none. Both must outlive the
  // object.
  TensionPeaks(const Subject& subject, const EdgeErrors* errors);

  void declare(Declarations& to) override;
  void step(const Snapshot& s) override;
  std::vector<Warning> warnings(const std::vector<io::SummaryRow>& summary, const Audit& audit) override;

 private:
  const Subject& subject_;
  const EdgeErrors* errors_;
  Folds folds_;
  Snaps snaps_;
  int before_ = -1, after_ = -1;  // indices of fields
};

}  // namespace hawser::record
