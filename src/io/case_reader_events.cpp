// Entries of `events`: combinations of keys, and arc lengths relative to the line's length.
#include "hawser/io/case_values.hpp"

namespace hawser::io {

using model::Action;
using model::Cause;
using model::refuse;
using model::Value;

namespace {

void check_action(const Value& v, const Action& a) {
  if (const Value* attach = v.find("attach"); attach && a.at.has_value() != (a.within > 0))
    refuse(*attach, "'at' and 'within' together define where the end is expected");
  const Value* feed = v.find("feed");
  if (!feed) return;
  if (feed->has("speed") + feed->has("tension") + feed->has("paid_out") != 1)
    refuse(*feed, "give one of 'speed', 'tension' and 'paid_out'");
  if (feed->has("paid_out") && a.paid_out == 0) refuse((*feed)["paid_out"], "0 m would change nothing");
  if (!feed->has("tension") && (feed->has("dead_band") || a.law.speed_per_tension + a.law.max_speed > 0))
    refuse(*feed, "'dead_band', 'speed_per_tension' and 'max_speed' go with 'tension'");
  if (!feed->has("speed") && a.ramp > 0) refuse((*feed)["ramp"], "goes with 'speed'");
}

}  // namespace

void finish_event(const Value& v, model::Event& e, const model::Case& c) {
  const Action& a = e.action;
  Cause& cause = e.cause;
  check_action(v, a);
  if (e.name.empty()) e.name = a.subject() + " " + a.participle();
  const int causes = v.has("time") + v.has("tension") + v.has("when") + v.has("after") + v.has("stage");
  const bool near = a.kind == Action::Kind::attach && a.at;
  if (causes > 1 || (causes == 0 && !near))
    refuse(v, "give one of 'time', 'tension', 'when', 'after' and 'stage': what it waits for");
  if (v["delay"].given && !v.has("after")) refuse(v["delay"], "goes with 'after'");
  if (causes == 0) {
    cause.kind = Cause::Kind::near;
    cause.limit = a.within;
    cause.below = true;
  }
  if (v.has("tension")) {
    if (a.kind != Action::Kind::release)
      refuse(v["tension"], "applies to 'release' and 'cut' only; give 'when: {tension: {line, at, above}}'");
    cause.line = a.line;
    cause.arc = a.cut >= 0 ? a.cut : a.line_end == LineEnd::B ? model::kEndB : 0;
  }
  if (const Value* when = v.find("when"))
    if (const Value* position = when->find("position"))
      if (position->has("body") == (position->has("line") || position->has("at")) ||
          position->has("line") != position->has("at"))
        refuse(*position, "give either 'body', or 'line' and 'at'");
  if (!cause.line.empty()) to_length(cause.arc, length_of(c, cause.line));
}

}  // namespace hawser::io
