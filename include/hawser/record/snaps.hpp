// Detection of lines whose largest tension is an impact that steps or elements do not resolve.
#pragma once

#include <mpi.h>

#include <span>
#include <string>
#include <vector>

#include "hawser/advice/step_choice.hpp"
#include "hawser/mesh/local_mesh.hpp"
#include "hawser/mesh/per_line.hpp"
#include "hawser/model/case.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser::record {

// A line that snaps taut has a tension peak like a half wave, T cos(w t) about its maximum. The peak is not
// resolved with fewer than six steps, or if the wave passes fewer than six elements; nor if the integration
// damps much of the axial vibration (docs/theory/time-integration.md); nor for the impact of an element on a
// volume, which a transverse wave must pass as well.
class Snaps {
 public:
  // Fed lines are excluded, because nodes leave a feeder without tension, as are rigidly joined members of
  // frames, which bend.
  Snaps(const model::Case& c, const LocalMesh& mesh);
  // Turn of a line over a volume from one cable element to the next.
  struct VolumePassage {
    double transverse_transit_time = 0;  // s, of a transverse wave through the slowest of these cables
    double time = 0;                     // s
  };
  // By owned node: effective tension towards end A and towards end B, N. After every step of h [s]; 0: at the
  // start. passages: the last contact with a volume; null: no volumes.
  void update(double time, double h, std::span<const double> before, std::span<const double> after,
              const PerLine<VolumePassage>* passages = nullptr);
  // Combines the ranks after the last step. Collective.
  void gather(MPI_Comm comm);
  // Sentence if the largest tension [N] of a line is such a peak, or if another peak, which a step does not
  // resolve, may exceed it; else empty. damped: much axial vibration was damped. After gather(), for a line
  // of this rank.
  std::string warning(int line, const std::string& name, double largest_tension, bool damped,
                      advice::StepChoice step) const;

 private:
  struct Worst {
    double tension = 0, time = 0, arc = 0;
    double step = 0, angle = 0;          // s; rad, phase of the wave within the step before the peak
    double element_transit_time = 0;     // s, of an axial wave
    double rate = 0;                     // rad/s, frequency of the peak from both sides
    double rise = 0;                     // N/s², rise before the peak
    double from = 0, within = 0;         // N, s: tension before the monotonic rise, and its duration
    double transverse_transit_time = 0;  // s, of an element over a volume; 0: none
    int node = -1;                       // owned, until the next step is processed
  };
  struct Before {
    double last = 0;            // N, at the previous step
    double previous = 0;        // N, at the step before it
    double step = 0;            // s, length of the previous step
    double low = 0, since = 0;  // N, s: start of the rise
  };
  std::string of_largest(int line, const std::string& name, double largest_tension, bool damped,
                         advice::StepChoice step) const;
  const LocalMesh& mesh_;
  std::vector<double> element_transit_time_;  // s, of an axial wave through the slower element at each owned
                                              // node; 0: excluded
  std::vector<Before> before_;                // by owned node; empty: no step yet
  PerLine<double> round_trip_time_;           // s, of an axial wave along each line and back
  PerLine<Worst> worst_;
  PerLine<Worst> unresolved_;  // the largest estimate of a peak between steps that do not resolve it
};

}  // namespace hawser::record
