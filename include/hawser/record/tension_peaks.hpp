// Whether the largest tension of a line is one that the steps or the elements do not show as it is.
#pragma once

#include "hawser/record/folds.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/record/snaps.hpp"
#include "hawser/record/subject.hpp"

namespace hawser::record {

class TensionPeaks : public Recording {
 public:
  // The subject outlives it.
  explicit TensionPeaks(const Subject& subject);

  void declare(Declarations& to) override;
  void step(const Snapshot& s) override;
  std::vector<Finding> findings(const std::vector<io::SummaryRow>& summary, const Audit& audit) override;

 private:
  const Subject& subject_;
  Folds folds_;
  Snaps snaps_;
  int before_ = -1, after_ = -1;  // among the fields
};

}  // namespace hawser::record
