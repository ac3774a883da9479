// What volumes that press on a stretch of a line do to its tension: a summary of fixed size. Summaries of
// stretches that follow each other join to that of the whole, so that ranks which share a line exchange a few
// numbers a stretch, however many nodes are in contact.
#pragma once

#include <algorithm>
#include <cmath>

namespace hawser::record {

// Of a line at a node that a volume presses on.
struct PressedTurn {
  int node = 0;      // of the mesh
  double angle = 0;  // rad, by which the line turns there
  double taken = 0;  // N, of the tension
  double tension = 0, length = 0,
         passage = 0;  // N; m, of the longer element beside it; s, of a wave across it
};

struct SumRange {
  double low = HUGE_VAL, high = -HUGE_VAL;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double width() const { return high - low; }
};

// With n_1 < n_2 < ... the nodes of the stretch that volumes press on and S_k = taken_1 + ... + taken_k.
struct PressedStretch {
  PressedStretch() = default;  // nothing presses
  explicit PressedStretch(const PressedTurn& turn);

  bool pressed = false;
  PressedTurn first, last;
  PressedTurn worst;                // the first of those that take most
  double before = 0, after = 0;     // rad, turns at the nodes next to the worst one; 0: nothing presses there
  double sum = 0;                   // N, S at the last node
  SumRange inside;                  // N, of all S_k
  SumRange outside;                 // N, of S_k where the node behind n_k is free and the stretch goes on
  double tension = 0, passage = 0;  // the largest of the turns
};

// Of two stretches of a line, b behind a, as one.
PressedStretch joined(const PressedStretch& a, const PressedStretch& b);

}  // namespace hawser::record
