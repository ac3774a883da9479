// Contacts of the accepted state, from which the clash report is made.
#pragma once

#include <vector>

namespace hawser {

// A part of a line in contact with another line, itself or a volume, or a contact between the volumes of
// two bodies. One rank only, the one that counts the contact, reports it.
struct ActiveContact {
  // Indices of the lines in the mesh and of the volumes in the term that reports the contact; -1: none. Of
  // two lines `line` is the smaller index or equal, of two volumes `volume` is.
  int line = -1, other_line = -1, volume = -1, other_volume = -1;
  double from = 0, to = 0;              // m, interval of arc length on `line`
  double other_from = 0, other_to = 0;  // m, interval of arc length on `other_line`
  double force = 0;                     // N, sum of the magnitudes of the normal forces
  double energy = 0;                    // J, in the contact springs
  double depth = 0;                     // m, largest penetration
};
using ActiveContacts = std::vector<ActiveContact>;

}  // namespace hawser
