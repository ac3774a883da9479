// Feeders: winches, tensioners or reels that pay out or haul in a line at an end.
#pragma once

#include <utility>
#include <vector>

namespace hawser::model {

struct Feed {
  double stock = 0;  // m, length inside the feeder at t = 0, measured from this end
  // Time [s] and speed [m/s], positive: pays out; linear between the rows, constant before the first and
  // after the last.
  std::vector<std::pair<double, double>> speed;
  double tension = 0;  // N, set point; 0: controlled by speed
  double min_tension = 0,
         max_tension = 0;        // N, dead band: no feeding while the tension is within; both 0: none
  double speed_per_tension = 0;  // m/s per N of deviation from the set point; 0: keeps the tension exactly
  double max_speed = 0;          // m/s, in both directions; 0: unlimited

  bool has_band() const { return max_tension > 0; }  // the feeder is at rest initially
};

// Speed-controlled feeding at time t >= 0 [s]: length paid out since t = 0 [m], its rate [m/s] and
// acceleration [m/s²] (the right-hand value at a corner).
struct Fed {
  double length = 0, speed = 0, acceleration = 0;
};
Fed fed_by(const Feed& feed, double t);

}  // namespace hawser::model
