// Phrases for events: subject, action and cause.
#include "hawser/model/event.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hawser::model {
namespace {

std::string limit_text(const Cause& c, const char* unit) {
  return fmt::format("{} {:g} {}", c.below ? "below" : "above", c.limit, unit);
}

}  // namespace

std::string Action::subject() const {
  if (kind == Kind::contact) return "contact with volume " + volume;
  if (kind == Kind::friction) return "friction of statics";
  if (kind == Kind::current) return "the current";
  if (cut >= 0) return "line " + given_line;
  const std::string end = fmt::format("end {} of line {}", end_letter(line_end), line);
  return kind == Kind::feed ? "the feeder at " + end : end;
}

std::string Action::participle() const {
  switch (kind) {
    case Kind::release:
      return cut >= 0 ? fmt::format("cut at {:g} m", cut) : "released";
    case Kind::attach:
      return body.empty() ? "attached" : "attached to body " + body;
    case Kind::feed:
      if (paid_out != 0)
        return fmt::format("set to {} {:g} m", paid_out > 0 ? "pay out" : "haul in", std::abs(paid_out));
      return law.speed.empty() ? fmt::format("set to {:g} N", law.tension)
                               : fmt::format("set to {:g} m/s", law.speed.back().second);
    case Kind::current:
      return fmt::format("scaled by {:g}", factor);
    case Kind::friction:
    case Kind::contact:
      return enabled ? "switched on" : "switched off";
  }
  return "";
}

std::string Cause::text() const {
  switch (kind) {
    case Kind::time:
      return fmt::format("at t = {:g} s", time);
    case Kind::tension:
      return fmt::format("when the effective tension of line {} at {:g} m is {}", line, arc,
                         limit_text(*this, "N"));
    case Kind::position:
      return fmt::format("when {} of {} is {}", "xyz"[axis],
                         body.empty() ? fmt::format("line {} at {:g} m", line, arc) : "body " + body,
                         limit_text(*this, "m"));
    case Kind::paid_out:
      return fmt::format("when line {} is paid out {}", line, limit_text(*this, "m"));
    case Kind::after:
      return time > 0 ? fmt::format("{:g} s after '{}'", time, event) : fmt::format("at '{}'", event);
    case Kind::stage:
      return fmt::format("in stage '{}' of statics", event);
    case Kind::near:
      return fmt::format("when it is within {:g} m of its place", limit);
  }
  return "";
}

}  // namespace hawser::model
