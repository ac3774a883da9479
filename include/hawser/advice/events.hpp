// Messages about events: that happened, could not happen or did not happen.
#pragma once

#include <string>

#include "hawser/model/event.hpp"

namespace hawser::advice {

// Details of an executed action for its message.
struct Happened {
  double tension = -1;      // N, of the released end; below 0: not reported
  double from_place = -1;   // m, distance of an end attached at a given place
  double from_origin = -1;  // m, distance from the body's origin of an end attached where it was
};
// stage: its name; empty: the event happened at the time [s].
std::string happened(const model::Action& action, double time, const std::string& stage, const Happened& how);
// without: length [m] next to the released end without contact with the volume in which it starts.
std::string released_inside(const model::Action& action, const std::string& volume, double without);
// A condition that the initial state already meets, with its value [N or m].
std::string met_at_start(const model::Event& event, double value);
std::string did_not_happen(const model::Event& event);
// because: a clause.
std::string cannot_happen(const model::Action& action, double time, const std::string& because);
std::string nothing_holds();
std::string holds_already();
std::string too_far_from_place(double away, double within);  // m
// remaining: length [m] still to be paid out (below 0: hauled in) in a stage of statics, which fails because
// of `why`.
std::string cannot_pay_out(const std::string& stage, double remaining, const std::string& feeder,
                           const std::string& why);

}  // namespace hawser::advice
