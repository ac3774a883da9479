// Warning of beams that rest on several short supports, where the penetration of contact changes reactions
// and moments as settlements of the supports do (docs/theory/contact.md, "Beams on several supports").
#pragma once

#include <string>
#include <vector>

#include "hawser/advice/contact_stiffness.hpp"
#include "hawser/record/recording.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser::record {

class SupportSettlement : public Recording {
 public:
  // True if beams may rest on volumes.
  static bool possible(const Subject& subject);
  // The subject must outlive the object.
  explicit SupportSettlement(const Subject& subject);

  void declare(Declarations& to) override;
  void start(const Snapshot& s) override;
  // With dynamics the sentence is printed as they begin, else at the end.
  std::vector<std::string> remarks() override;
  std::vector<Warning> warnings(const std::vector<io::SummaryRow>& summary) override;

 private:
  struct Support {                 // interval of a line in contact with a volume
    int line = 0, volume = -1;     // volume: index into the case; -1: held end of the line
    double from = 0, to = 0;       // m, arc length
    double radius = 0, EI = 0;     // m; N m²
    Vec3 force = Vec3::Zero();     // N, on the line and normal to it
    double pressed = 0, work = 0;  // sums of |force| and of |force| times settlement, N and N m
    double depth = 0;              // m, largest penetration; negative: smallest gap
    double smoothing = 0;          // m, half width of the smooth onset of contact

    Vec3 displacement() const;
  };
  Support support(const Kinematics& state, std::span<const LineVolumeContact::Load> loads) const;
  std::vector<Support> supports_of_rank(const Kinematics& state) const;
  double settlement(const Support& s) const;
  // Supports of a line with its held ends, in the order of arc length; close ones are joined.
  std::vector<Support> chain(std::span<const Support> of_line) const;
  void find_worst(std::span<const Support> chain, double largest_moment);

  const Subject& subject_;
  std::vector<int> volumes_;  // of the term: index into Case::volumes
  int moment_ = -1;           // index of the field
  double worst_ = 0;          // fraction, of the warning
  std::string text_;          // empty: none
};

}  // namespace hawser::record
