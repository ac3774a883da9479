// Sentences about events: what happened, what could not, and what did not.
#pragma once

#include <string>

#include "hawser/model/event.hpp"

namespace hawser::advice {

// How an action came about: what its message says beside the action.
struct Happened {
  double tension = -1;      // N, of what is released; below 0: not said
  double from_place = -1;   // m, of an end attached at a given place
  double from_origin = -1;  // m, of an end attached where it was to a body
};
// stage: its name; empty: at the time [s].
std::string happened(const model::Action& action, double time, const std::string& stage, const Happened& how);
// without: m of a line next to the end released that have no contact with the volume in which it starts.
std::string released_inside(const model::Action& action, const std::string& volume, double without);
// A condition that the state at the start meets, with its value [N or m].
std::string met_at_start(const model::Event& event, double value);
std::string did_not_happen(const model::Event& event);
// because: a clause.
std::string cannot_happen(const model::Action& action, double time, const std::string& because);
std::string nothing_holds();
std::string holds_already();
std::string too_far_from_place(double away, double within);  // m
// m that are left to be paid out (below 0: hauled in) in a stage of statics, which fails by `why`.
std::string cannot_pay_out(const std::string& stage, double left, const std::string& feeder,
                           const std::string& why);

}  // namespace hawser::advice
