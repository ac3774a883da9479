// Where the largest tension of a line is that of an impact which steps or elements do not resolve.
#pragma once

#include <mpi.h>

#include <span>
#include <string>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/model/case.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser::record {

// A line that snaps taut has a peak of tension like half a wave, T cos(w t) about its top. Of fewer than six
// steps, or than six elements that the wave of it passes, such a peak is no longer itself; nor where the
// integration takes out much of the axial vibration (docs/theory/time-integration.md). Nor is the impact of
// an element against a volume, which a wave across the line must pass as well.
class Snaps {
 public:
  // Lines that are fed do not count: nodes come out of a feeder that have had no tension. Nor do members of
  // frames, joined rigidly, which bend.
  Snaps(const model::Case& c, const LocalMesh& mesh);
  // Of a line that turns over a volume from one cable to the next.
  struct OverVolume {
    double passage = 0, time = 0;  // s, of a wave across it through the slowest of these cables, and when
  };
  // By owned node: effective tension on the side of end A and of end B, N. After every step of h [s]; 0: at
  // the start. over: by line, the last contact with a volume; empty: there are no volumes.
  void update(double time, double h, std::span<const double> before, std::span<const double> after,
              std::span<const OverVolume> over = {});
  // After the last step: puts together what the ranks have. Collective.
  void gather(MPI_Comm comm);
  // That the largest tension [N] of a line is such a peak, in words; empty: it is not. damped: the run has
  // taken much out of axial vibration; fixed: the user chose the step. After gather().
  std::string warning(int line, const std::string& name, double largest_tension, bool damped,
                      bool fixed) const;

 private:
  struct Worst {
    double tension = 0, time = 0, arc = 0;
    double step = 0, angle = 0;    // s; rad, of the wave within the step that led to it
    double passage = 0, rate = 0;  // s, of a wave through an element; rad/s of the peak by its two sides
    double rise = 0;               // N/s², of the side before it
    double from = 0, within = 0;   // N, s: from what it came up without falling, and how long that took
    double across = 0;             // s, of a wave across an element that lay over a volume; 0: none did
    int node = -1;                 // owned, while the step after it has not been seen
  };
  struct Before {
    double last = 0;            // N, of the step before
    double low = 0, since = 0;  // N, s: from which on it has not fallen
  };
  const LocalMesh& mesh_;
  std::vector<double> passage_;  // s, of the slower element at each owned node; 0: does not count
  std::vector<Before> before_;   // by owned node; empty: no step yet
  std::vector<double> echo_;     // s, of a wave along each line and back
  std::vector<Worst> worst_;     // by line
};

}  // namespace hawser::record
