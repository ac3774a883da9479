// Warnings of floating bodies that sink below the seabed, which carries lines only.
#pragma once

#include <map>
#include <vector>

#include "hawser/record/recording.hpp"
#include "hawser/record/subject.hpp"

namespace hawser::record {

class BodiesBelowBed : public Recording {
 public:
  // The subject must outlive the object.
  explicit BodiesBelowBed(const Subject& subject) : subject_(subject) {}

  // True if the case has a seabed and floating bodies.
  static bool possible(const Subject& s);

  void start(const Snapshot& s) override { output(s); }
  void output(const Snapshot& s) override;
  std::vector<Warning> warnings(const std::vector<io::SummaryRow>& summary) override;

 private:
  const Subject& subject_;
  // Largest depth [m] of the centre of mass below the bed, by body of the case, for those of this rank that
  // have been there.
  std::map<int, double> deepest_;
};

}  // namespace hawser::record
