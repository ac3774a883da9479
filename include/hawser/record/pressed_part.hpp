// Effect of volumes and lines pressing on a part of a line on its tension, as a summary of fixed size.
// Summaries of consecutive parts can be joined, so that ranks sharing a line exchange a few numbers per part,
// independent of the number of contact nodes.
#pragma once

#include <algorithm>
#include <cmath>

namespace hawser::record {

// State of a line at a node in contact with a volume or line.
struct PressedTurn {
  int node = 0;                    // node number in the mesh
  double angle = 0;                // rad, turn of the line there
  double tension_change = 0;       // N, change of tension
  double tension = 0, length = 0;  // N; m, of the longer adjacent element
  // s, of a transverse wave through it; 0 without contact with volumes
  double transverse_transit_time = 0;
  bool over_line = false;  // lines press on it more than volumes do
};

struct SumRange {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double width() const { return high - low; }
};

// n_1 < n_2 < ... are the contact nodes of the part, dT_k are their `tension_change`, and S_k = dT_1 + ... +
// dT_k.
struct PressedPart {
  PressedPart() = default;  // without contact
  explicit PressedPart(const PressedTurn& turn);

  bool pressed = false;
  PressedTurn first, last;
  PressedTurn worst;                   // the first of those with the largest `tension_change`
  double before = 0, after = 0;        // rad, turns at the nodes next to `worst`; 0: no contact there
  double sum = 0;                      // N, S at the last node
  SumRange inside;                     // N, range of all S_k
  SumRange outside;                    // N, range of S_k at nodes n_k followed by a free node within the part
  double transverse_transit_time = 0;  // s, largest value of the turns
  double tension = 0;                  // N, largest of the part, also without contact
};

// Joins two parts of a line, b after a.
PressedPart joined(const PressedPart& a, const PressedPart& b);

}  // namespace hawser::record
