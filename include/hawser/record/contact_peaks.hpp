// Bending peaks where a volume, for example a roller, presses on a beam between two nodes: moment and
// curvature, shown at the nearer node (docs/theory/supports.md, "Moments under a roller").
#pragma once

#include <array>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/system/system.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser::record {

class ContactPeaks {
 public:
  // Case and system must outlive the object.
  ContactPeaks(const model::Case& c, const System& system);

  // Selects the fields to correct: moments and curvature.
  void find(const std::vector<Field>& fields);

  // Raises `values` (by field, of this rank's owned nodes) of an accepted state to the peaks within the half
  // element next to each node. No communication.
  void fill(const Kinematics& state, std::vector<std::vector<double>>& values) const;

 private:
  // Bending moment at a place of an element, about section axes 2 and 3, N m.
  struct Peak {
    double xi = 0, about2 = 0, about3 = 0;
  };
  Peak peak(const Kinematics& state, const LocalElement& e, const AxisShape& shape,
            std::span<const LineVolumeContact::Load> loads, double from, double to) const;

  const System& system_;
  const LineVolumeContact* contact_;       // null: no contact of lines with volumes
  std::vector<std::array<double, 2>> EI_;  // N m², by local element; 0: cables and nonlinear bending
  int moment_ = -1, moment_2_ = -1, moment_3_ = -1, curvature_ = -1;
};

}  // namespace hawser::record
