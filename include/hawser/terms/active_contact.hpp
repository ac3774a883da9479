// A place where something touches in the accepted state: what the clash report is made from.
#pragma once

#include <vector>

namespace hawser {

// A stretch of a line that touches another line (or itself) or a volume; or two volumes of bodies that touch.
// Each is reported by one rank only, the one that counts it.
struct ActiveContact {
  // What touches: lines of the mesh; volumes of the term that reports it. -1: none. Of two lines `line` is
  // not the larger, nor is `volume` of two volumes.
  int line = -1, other_line = -1, volume = -1, other_volume = -1;
  double from = 0, to = 0;              // m, arc length on `line`
  double other_from = 0, other_to = 0;  // m, arc length on `other_line`
  double force = 0;                     // N, sum of the sizes of the normal forces
  double energy = 0;                    // J, in the contact springs
  double depth = 0;                     // m, largest penetration
};
using ActiveContacts = std::vector<ActiveContact>;

}  // namespace hawser
