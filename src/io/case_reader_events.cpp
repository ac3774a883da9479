// An entry of `events`: its action and what it waits for.
#include <fmt/format.h>

#include "hawser/io/case_values.hpp"
#include "hawser/model/check.hpp"

namespace hawser::io {

using model::Action;
using model::Cause;
using model::Value;

namespace {

double length(const model::Case& c, const std::string& line) {
  return model::length_of(c.lines[static_cast<std::size_t>(c.line_index(line))]);
}

Action action(const Value& v, const std::string& path, const CaseSource& source) {
  Action a;
  const auto end = [&a](const Value& of) { a.line = of["line"].text, a.at_b = of["end"].is("end_b"); };
  if (const Value* release = v.find("release")) {
    end(*release);
  } else if (const Value* cut = v.find("cut")) {
    a.line = a.whole = (*cut)["line"].text, a.cut = (*cut)["at"].number;
  } else if (const Value* attach = v.find("attach")) {
    a.kind = Action::Kind::attach;
    end(*attach);
    if (attach->has("body")) a.body = (*attach)["body"].text;
    if (attach->has("at")) a.at = vec(*attach, "at");
    a.within = number(*attach, "within"), a.clamped = (*attach)["clamped"].number != 0;
    if (a.at.has_value() != (a.within > 0))
      source.bad(*attach, path + ".attach", "'at' and 'within' say together where the end is expected");
  } else if (const Value* feed = v.find("feed")) {
    a.kind = Action::Kind::feed;
    end(*feed);
    model::take(*feed, a.law), a.ramp = (*feed)["ramp"].number;
    a.paid_out = number(*feed, "paid_out");
    if (feed->has("speed") + feed->has("tension") + feed->has("paid_out") != 1)
      source.bad(*feed, path + ".feed", "give one of 'speed', 'tension' and 'paid_out'");
    if (feed->has("paid_out") && a.paid_out == 0)
      source.bad((*feed)["paid_out"], path + ".feed.paid_out", "0 m would change nothing");
    if (!feed->has("tension") && (feed->has("dead_band") || a.law.speed_per_tension + a.law.max_speed > 0))
      source.bad(*feed, path + ".feed", "'dead_band', 'speed_per_tension' and 'max_speed' go with 'tension'");
    if (!feed->has("speed") && a.ramp > 0) source.bad(*feed, path + ".feed.ramp", "goes with 'speed'");
  } else if (const Value* friction = v.find("friction")) {
    a.kind = Action::Kind::friction, a.enabled = (*friction)["enabled"].number != 0;
  } else if (const Value* current = v.find("current")) {
    a.kind = Action::Kind::current, a.factor = (*current)["factor"].number;
  } else {
    a.kind = Action::Kind::contact;
    a.volume = v["contact"]["volume"].text, a.enabled = v["contact"]["enabled"].number != 0;
  }
  return a;
}

Cause condition(const Value& when, const std::string& path, const CaseSource& source, const model::Case& c) {
  Cause out;
  const auto take = [&](const Value& v) {
    out.below = v.has("below"), out.limit = v[out.below ? "below" : "above"].number;
    if (v.has("line")) out.line = v["line"].text;
    if (v.has("at")) out.arc = arc(v.find("at"), 0, length(c, out.line));
    if (v.has("end") && v["end"].is("end_b")) out.arc = length(c, out.line);
  };
  if (const Value* tension = when.find("tension")) {
    out.kind = Cause::Kind::tension;
    take(*tension);
  } else if (const Value* paid = when.find("paid_out")) {
    out.kind = Cause::Kind::paid_out;
    take(*paid);
  } else {
    const Value& position = when["position"];
    out.kind = Cause::Kind::position;
    if (position.has("body") ? position.has("line") || position.has("at")
                             : !position.has("line") || !position.has("at"))
      source.bad(position, path + ".position", "give either 'body', or 'line' and 'at'");
    if (position.has("body")) out.body = position["body"].text;
    out.axis = position["axis"].is("x") ? 0 : position["axis"].is("y") ? 1 : 2;
    take(position);
  }
  return out;
}

}  // namespace

model::Event read_event(const Value& v, const std::string& path, const CaseSource& source,
                        const model::Case& c) {
  model::Event e;
  e.action = action(v, path, source);
  e.name = v.has("name") ? v["name"].text : e.action.subject() + " " + e.action.participle();
  const int causes = v.has("time") + v.has("tension") + v.has("when") + v.has("after") + v.has("stage");
  const bool near = e.action.kind == Action::Kind::attach && e.action.at;
  if (causes > 1 || (causes == 0 && !near))
    source.bad(v, path, "give one of 'time', 'tension', 'when', 'after' and 'stage': what it waits for");
  if (v.has("delay") && v["delay"].given && !v.has("after"))
    source.bad(v["delay"], path + ".delay", "goes with 'after'");
  Cause& cause = e.cause;
  if (v.has("time")) {
    cause.time = v["time"].number;
  } else if (v.has("tension")) {
    if (e.action.kind != Action::Kind::release)
      source.bad(v["tension"], path + ".tension",
                 "is that of an end that is released or a line that is cut; give 'when: {tension: {line, at, "
                 "above}}'");
    cause.kind = Cause::Kind::tension, cause.limit = v["tension"].number, cause.line = e.action.line;
    cause.arc = e.action.cut >= 0 ? e.action.cut : e.action.at_b ? length(c, e.action.line) : 0;
  } else if (v.has("when")) {
    cause = condition(v["when"], path + ".when", source, c);
  } else if (v.has("stage")) {
    cause.kind = Cause::Kind::stage, cause.event = v["stage"].text;
  } else if (v.has("after")) {
    cause.kind = Cause::Kind::after, cause.event = v["after"].text, cause.time = v["delay"].number;
  } else {
    cause.kind = Cause::Kind::near, cause.limit = e.action.within, cause.below = true;
  }
  return e;
}

}  // namespace hawser::io
