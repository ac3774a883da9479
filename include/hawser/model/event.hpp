// What happens during a run: an action, and what it waits for.
#pragma once

#include <optional>
#include <string>

#include "hawser/math/types.hpp"
#include "hawser/model/feeder.hpp"

namespace hawser::model {

struct Action {
  // release: an end of a line lets go. attach: one is held from then on. feed: a feeder goes by another law.
  // contact: that of lines with a volume goes on or off. friction, current: that of statics goes on or off,
  // the current is scaled, from a stage of statics on.
  enum class Kind { release, attach, feed, contact, friction, current };
  Kind kind = Kind::release;
  std::string line;  // and its end: of all but contact
  bool at_b = false;
  // Of a release: m, arc length from end A of the line `whole`, which is cut there. The end is that of one of
  // its parts.
  double cut = -1;
  std::string whole;
  // Of an attachment.
  std::string body;                // empty: fixed in space
  std::optional<Vec3> at;          // m, in the body's frame (or space); none: where the end is
  double within = 0;               // m, that the end may be away from there; it stays where it is
  bool clamped = false;            // its rotation is held as well
  Feed law;                        // without a stock
  double ramp = 0;                 // s, in which a speed is reached
  double paid_out = 0;             // m, by a feeder in a stage of statics; < 0: hauled in; 0: it has a law
  std::string volume;              // of contact
  bool enabled = true;             // contact, friction: on or off
  double factor = 1;               // of the current
  std::string subject() const;     // "end B of line hose", "line hose", "contact with volume drum"
  std::string participle() const;  // "released", "cut at 12 m", "switched on"
};

// What an event waits for.
struct Cause {
  // near: the end that is to be attached comes within the distance of its place. stage: of statics, which
  // begins with it.
  enum class Kind { time, tension, position, paid_out, after, near, stage };
  Kind kind = Kind::time;
  double time = 0;           // s: when; of `after`: so much later
  std::string line;          // of tension, position and paid_out
  double arc = 0;            // m from end A; of paid_out an end
  std::string body;          // of the position, if not of the line
  int axis = 2;              // of the position
  double limit = 0;          // N, m
  bool below = false;        // it waits for a value below the limit, else above
  std::string event;         // of `after`: name of the other; of a stage: its name
  std::string text() const;  // "its tension did not reach 5 N"
};

struct Event {
  std::string name;  // unique
  Action action;
  Cause cause;
};

}  // namespace hawser::model
