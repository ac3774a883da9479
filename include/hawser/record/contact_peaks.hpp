// Peaks of bending where a volume presses on a beam between two of its nodes, a roller for example: moment
// and curvature there, shown at the nearer node (docs/theory/supports.md, "Moments under a roller").
#pragma once

#include <array>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/system/system.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser::record {

class ContactPeaks {
 public:
  // Case and system outlive it.
  ContactPeaks(const model::Case& c, const System& system);

  // Which of them are raised: moments and curvature.
  void find(const std::vector<Field>& fields);

  // Of an accepted state, `values` of this rank's owned nodes by field: what is less than a peak within an
  // element, in the half of it that is theirs, becomes that. No communication.
  void fill(const Kinematics& at, std::vector<std::vector<double>>& values) const;

 private:
  // Bending at a place of an element, about the axes 2 and 3 of its section, N m.
  struct Peak {
    double xi = 0, about2 = 0, about3 = 0;
  };
  Peak peak(const Kinematics& at, const LocalElement& e, const AxisShape& shape,
            std::span<const LineVolumeContact::Load> loads, double from, double to) const;

  const System& system_;
  const LineVolumeContact* contact_;       // null: no line touches a volume
  std::vector<std::array<double, 2>> EI_;  // N m², of the local elements; 0: cables, and what bends by a law
  int moment_ = -1, moment_2_ = -1, moment_3_ = -1, curvature_ = -1;
};

}  // namespace hawser::record
