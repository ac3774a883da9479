// Events of a run: an action and its cause.
#pragma once

#include <optional>
#include <string>

#include "hawser/math/types.hpp"
#include "hawser/model/feeder.hpp"
#include "hawser/model/line_end.hpp"

namespace hawser::model {

struct Action {
  // release, attach: an end of a line is released or attached. feed: changes a feeder's law. contact:
  // switches contact of lines with a volume. friction: switches static friction. current: scales the current.
  // The last two act from a stage of statics on.
  enum class Kind { release, attach, feed, contact, friction, current };
  Kind kind = Kind::release;
  std::string line;  // all kinds but contact; line_end selects the end
  LineEnd line_end = LineEnd::A;
  // Release by a cut: arc length from end A of the line `given_line` [m]; the released end belongs to one of
  // its parts.
  double cut = -1;
  std::string given_line;
  // Attachment:
  std::string body;                // empty: fixed in space
  std::optional<Vec3> at;          // m, in the body's frame (or space); none: the current position of the end
  double within = 0;               // m, allowed distance from there; the end stays where it is
  bool clamped = false;            // rotation is held as well
  Feed law;                        // without stock
  double ramp = 0;                 // s, to reach the speed
  double paid_out = 0;             // m, paid out in a stage of statics; < 0: hauled in; 0: `law` applies
  std::string volume;              // of contact
  bool enabled = true;             // contact, friction: switched on or off
  double factor = 1;               // of the current
  std::string subject() const;     // "end B of line hose", "line hose", "contact with volume drum"
  std::string participle() const;  // "released", "cut at 12 m", "switched on"
};

// Condition that triggers an event.
struct Cause {
  // near: the end to be attached is within the given distance of its expected position. stage: the start of a
  // stage of statics.
  enum class Kind { time, tension, position, paid_out, after, near, stage };
  Kind kind = Kind::time;
  double time = 0;           // s; Kind::after: delay
  std::string line;          // of tension, position and paid_out
  double arc = 0;            // m from end A; paid_out: an end
  std::string body;          // position of a body instead of a line
  int axis = 2;              // of the position
  double limit = 0;          // N, m
  bool below = false;        // triggers below the limit, else above
  std::string event;         // Kind::after: name of the other event; Kind::stage: name of the stage
  std::string text() const;  // "its tension did not reach 5 N"
};

struct Event {
  std::string name;  // unique
  Action action;
  Cause cause;
};

}  // namespace hawser::model
