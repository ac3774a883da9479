// Keys of events: actions, causes, stages of statics.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

using Does = Action::Kind;
using On = Cause::Kind;

Key line(const Field& field) { return reference({"line", field}, "lines", "the line", required); }
Key action_line() { return line(&Action::line); }
Key action_end(const char* about) {
  return word({"end", &Action::line_end}, {{"end_a", LineEnd::A}, {"end_b", LineEnd::B}}, about, required);
}

Key enabled(const char* about) { return boolean({"enabled", &Action::enabled}, about, required); }

// Name of an action and its kind.
Head does(const char* name, Does kind) {
  return {name, &Event::action, set(&Event::action, &Action::kind, kind)};
}

Key feed() {
  std::vector<Key> keys{action_line(), action_end("the end that has a `feed`")};
  for (Key& k : feed_law()) keys.push_back(within(&Action::law, std::move(k)));
  keys.push_back(number({"ramp", &Action::ramp}, time, "duration of the change from the present speed",
                        at_least(0), or_else("0")));
  keys.push_back(number({"paid_out", &Action::paid_out}, length,
                        "length paid out in a stage of statics; below 0 hauled in"));
  return map(does("feed", Does::feed), std::move(keys),
             "starts or stops a feeder, changes its law, or pays out in statics");
}

// Keys of all actions; an event has one of them.
std::vector<Key> actions() {
  return {
      map(does("release", Does::release),
          {action_line(), action_end("the end, held by an anchor, a body, a joint or an earlier event")},
          "releases an end of a line"),
      map(does("cut", Does::release),
          {reference({"line", &Action::line, &Action::given_line}, "lines", "the line", required),
           number({"at", &Action::cut}, length, "arc length from end A", above(0), required)},
          "cuts a line into two parts with free ends"),
      map(does("attach", Does::attach),
          {action_line(), action_end("the end, which must be free at that time"),
           reference({"body", &Action::body}, "bodies",
                     "body that holds it; without it the end is fixed in space"),
           vec3({"at", &Action::at}, length,
                "point in the body's frame (or in space) where the end is expected",
                or_else_note("none: any position")),
           number({"within", &Action::within}, length,
                  "allowed distance from `at`: the end is held at its actual position", above(0)),
           boolean({"clamped", &Action::clamped},
                   "whether its rotation is held as well, in its actual orientation", or_else("false"))},
          "holds an end of a line from this event on, at its actual position relative to the body"),
      feed(),
      map(does("contact", Does::contact),
          {text({"volume", &Action::volume},
                "the volume; for `supports` the name of a group, of a box (`stinger 3`) or of a roller",
                required),
           enabled("whether contact acts from this event on")},
          "switches contact of lines with a volume on or off; a volume whose first event switches it on is "
          "off until then"),
      map(does("friction", Does::friction), {enabled("whether friction acts in statics from this stage on")},
          "switches friction on or off in statics: of lines on volumes, on each other and on the bed"),
      map(does("current", Does::current),
          {number({"factor", &Action::factor}, none,
                  "factor of the `current` of the water, from this stage on", required)},
          "scales the current from a stage of statics on"),
  };
}

const std::vector<Group> kActions = {
    {{"release"}, {"release"}}, {{"cut"}, {"cut"}},           {{"attach"}, {"attach"}},  {{"feed"}, {"feed"}},
    {{"contact"}, {"contact"}}, {{"friction"}, {"friction"}}, {{"current"}, {"current"}}};

Key waits_for(const char* name, On kind, std::vector<Key> keys, Dimension unit, const std::string& about) {
  keys.push_back(number({"above", &Cause::limit}, unit, "the event happens when the value exceeds this"));
  keys.push_back(number({"below", &Cause::limit, set(&Cause::below, true)}, unit,
                        "the event happens when the value falls below this"));
  return map({name, itself<Cause>(), set(&Cause::kind, kind)}, std::move(keys), about,
             either({"above", "below"}));
}

Key condition() {
  return map({"when", &Event::cause},
             {waits_for("tension", On::tension,
                        {line(&Cause::line), arc({"at", &Cause::arc}, "arc length from end A", required)},
                        force, "effective tension of a line, at the nearest node"),
              waits_for("position", On::position,
                        {reference({"line", &Cause::line}, "lines", "line of the node ..."),
                         arc({"at", &Cause::arc}, "... at this arc length"),
                         reference({"body", &Cause::body}, "bodies", "body, whose origin counts"),
                         word({"axis", &Cause::axis}, {{"x", 0}, {"y", 1}, {"z", 2}},
                              "axis of the coordinate, in space", required)},
                        length, "coordinate of a node of a line, or of the origin of a body"),
              waits_for("paid_out", On::paid_out,
                        {line(&Cause::line), word({"end", &Cause::arc}, {{"end_a", 0}, {"end_b", kEndB}},
                                                  "the end that has a `feed`", required)},
                        length, "length paid out since t = 0")},
             "a condition, located to 0.1 % of a tension and 1 mm of a length",
             either({"tension", "position", "paid_out"}));
}

Field set_cause(On kind) { return set(&Event::cause, &Cause::kind, kind); }

void delay(Event& e, const Value& v) {
  if (e.cause.kind == On::after) e.cause.time = v.number;
}

}  // namespace

Key events() {
  std::vector<Key> keys = actions();
  keys.push_back(text({"name", &Event::name}, "name by which other events refer to this one",
                      or_else_note("a description of its action")));
  keys.push_back(number({"time", within(&Event::cause, &Cause::time)}, Dimension::time, "time of the event",
                        at_least(0)));
  keys.push_back(number(
      {"tension", within(&Event::cause, &Cause::limit), set_cause(On::tension)}, force,
      "the event happens when the effective tension at that end, or at the place of the cut, reaches this",
      above(0)));
  keys.push_back(condition());
  keys.push_back(text({"after", within(&Event::cause, &Cause::event), set_cause(On::after)},
                      "the event happens after the event of this name"));
  keys.push_back(number({"delay", set_by<Event>(delay)}, Dimension::time, "additional delay", at_least(0),
                        or_else("0")));
  keys.push_back(text({"stage", within(&Event::cause, &Cause::event), set_cause(On::stage)},
                      "the event happens at the beginning of this stage of statics"));
  return list({"events", &Case::events}, map("", std::move(keys), either(kActions)),
              "Events, each of which happens once: at a `time`, at a `tension`, at a condition (`when`), "
              "`after` another, or in a `stage` of statics. An event that attaches an end `within` a "
              "distance may wait for that distance alone.",
              or_else("[]"));
}

Key stages() {
  return list({"stages", &Case::stages}, name(""),
              "Names of stages of statics, in order: each stage starts from the equilibrium of the previous "
              "one with the `events` that name it; dynamics starts from the equilibrium of the last stage.",
              or_else("[]"));
}

}  // namespace hawser::model::schema_build
