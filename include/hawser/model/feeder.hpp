// What pays a line out at one of its ends or hauls it in: a winch, a tensioner, a reel.
#pragma once

#include <utility>
#include <vector>

namespace hawser::model {

struct Feed {
  double stock = 0;  // m of the line, from this end on, that is inside the feeder at t = 0
  // s, m/s: positive pays out; straight between the rows, constant before the first and beyond the last.
  std::vector<std::pair<double, double>> speed;
  double tension = 0;            // N, that it keeps to; 0: it goes by speed
  double least = 0, most = 0;    // N, dead band: it rests as long as the tension is within; both 0: none
  double speed_per_tension = 0;  // m/s per N of what the tension differs by; 0: keeps exactly to it
  double max_speed = 0;          // m/s, either way; 0: no limit

  bool has_band() const { return most > 0; }  // with which it begins at rest
};

// At a time t >= 0 [s] of a feeder that goes by speed: length paid out since t = 0 [m], its rate, and that
// rate's own (the one after t where the rows have a corner).
struct Fed {
  double length = 0, speed = 0, acceleration = 0;
};
Fed fed_by(const Feed& feed, double t);

}  // namespace hawser::model
