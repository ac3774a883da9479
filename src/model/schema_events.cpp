// Keys of events: actions, causes, stages of statics.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

using Does = Action::Kind;
using On = Cause::Kind;

Key line(const Field& field) { return reference({"line", field}, "lines", "the line", required); }
Key action_line() { return line(&Action::line); }
Key action_end(const char* about) {
  return word({"end", &Action::at_b}, {{"end_a", false}, {"end_b", true}}, about, required);
}

Key enabled(const char* about) { return boolean({"enabled", &Action::enabled}, about, required); }

// Name of an action and its kind.
Head does(const char* name, Does kind) {
  return {name, &Event::action, set(&Event::action, &Action::kind, kind)};
}

Key feed() {
  std::vector<Key> keys{action_line(), action_end("its end with a `feed`")};
  for (Key& k : feed_law()) keys.push_back(within(&Action::law, std::move(k)));
  keys.push_back(number({"ramp", &Action::ramp}, time, "in which the speed changes from what it is",
                        at_least(0), or_else("0")));
  keys.push_back(number({"paid_out", &Action::paid_out}, length,
                        "in a stage of statics: so much is paid out; below 0 it is hauled in"));
  return map(does("feed", Does::feed), std::move(keys),
             "starts or stops a feeder, gives it another law, or lets statics pay out");
}

// Keys of all actions; an event has one of them.
std::vector<Key> actions() {
  return {
      map(does("release", Does::release),
          {action_line(), action_end("its end, held by an anchor, a body, a joint or another event")},
          "lets an end of a line go: it parts, or is cast off"),
      map(does("cut", Does::release),
          {reference({"line", &Action::line, &Action::given_line}, "lines", "the line", required),
           number({"at", &Action::cut}, length, "arc length from end A", above(0), required)},
          "parts a line: both parts go on with a free end"),
      map(does("attach", Does::attach),
          {action_line(), action_end("its end, free by then"),
           reference({"body", &Action::body}, "bodies",
                     "that holds it; without it the end is fixed in space"),
           vec3({"at", &Action::at}, length,
                "place in the body's frame (or in space) at which it is expected",
                or_else_note("wherever it is")),
           number({"within", &Action::within}, length,
                  "distance from `at` that is allowed: the end is held where it is", above(0)),
           boolean({"clamped", &Action::clamped}, "rotation held as well, as it is then", or_else("false"))},
          "holds an end of a line from then on where it is, as seen from the body"),
      feed(),
      map(does("contact", Does::contact),
          {text({"volume", &Action::volume},
                "the volume; of `supports` the name of a group, of a box (`stinger 3`) or of a roller",
                required),
           enabled("whether lines touch it from then on")},
          "switches the contact of lines with a volume on or off; of which the first event switches it on is "
          "off until then"),
      map(does("friction", Does::friction), {enabled("whether statics has it from this stage on")},
          "switches friction on or off in statics: of lines on volumes, on each other and on the bed"),
      map(does("current", Does::current),
          {number({"factor", &Action::factor}, none, "times the `current` of the water, from this stage on",
                  required)},
          "scales the current from a stage of statics on"),
  };
}

const std::vector<Group> kActions = {
    {{"release"}, {"release"}}, {{"cut"}, {"cut"}},           {{"attach"}, {"attach"}},  {{"feed"}, {"feed"}},
    {{"contact"}, {"contact"}}, {{"friction"}, {"friction"}}, {{"current"}, {"current"}}};

Key waits_for(const char* name, On kind, std::vector<Key> keys, Dimension unit, const std::string& about) {
  keys.push_back(number({"above", &Cause::limit}, unit, "it happens when the value gets above this"));
  keys.push_back(number({"below", &Cause::limit, set(&Cause::below, true)}, unit, "or below this"));
  return map({name, itself<Cause>(), set(&Cause::kind, kind)}, std::move(keys), about,
             either({"above", "below"}));
}

Key condition() {
  return map({"when", &Event::cause},
             {waits_for("tension", On::tension,
                        {line(&Cause::line), arc({"at", &Cause::arc}, "arc length from end A", required)},
                        force, "effective tension of a line, at the node that is nearest"),
              waits_for("position", On::position,
                        {reference({"line", &Cause::line}, "lines", "of a line ..."),
                         arc({"at", &Cause::arc}, "... at this arc length"),
                         reference({"body", &Cause::body}, "bodies", "or of the origin of a body"),
                         word({"axis", &Cause::axis}, {{"x", 0}, {"y", 1}, {"z", 2}}, "coordinate in space",
                              required)},
                        length, "a coordinate of a node of a line, or of a body"),
              waits_for("paid_out", On::paid_out,
                        {line(&Cause::line), word({"end", &Cause::arc}, {{"end_a", 0}, {"end_b", kEndB}},
                                                  "its end with a `feed`", required)},
                        length, "length that was paid out since t = 0")},
             "a condition, met to 0.1 % of a tension and 1 mm of a length",
             either({"tension", "position", "paid_out"}));
}

Field on(On kind) { return set(&Event::cause, &Cause::kind, kind); }

void delay(Event& e, const Value& v) {
  if (e.cause.kind == On::after) e.cause.time = v.number;
}

}  // namespace

Key events() {
  std::vector<Key> keys = actions();
  keys.push_back(text({"name", &Event::name}, "by which other events know it", or_else_note("what it does")));
  keys.push_back(
      number({"time", within(&Event::cause, &Cause::time)}, Dimension::time, "when it happens", at_least(0)));
  keys.push_back(number(
      {"tension", within(&Event::cause, &Cause::limit), on(On::tension)}, force,
      "it happens when the effective tension at that end, or where the line is cut, reaches this", above(0)));
  keys.push_back(condition());
  keys.push_back(text({"after", within(&Event::cause, &Cause::event), on(On::after)},
                      "it happens after the event of this name"));
  keys.push_back(
      number({"delay", by<Event>(delay)}, Dimension::time, "so much later", at_least(0), or_else("0")));
  keys.push_back(text({"stage", within(&Event::cause, &Cause::event), on(On::stage)},
                      "it happens at the beginning of this stage of statics"));
  return list(
      {"events", &Case::events}, map("", std::move(keys), either(kActions)),
      "What happens, each event once: at a `time`, at a `tension`, at a condition (`when`), `after` another, "
      "or in a `stage` of statics. What is to be attached within a distance may wait for that alone.",
      or_else("[]"));
}

Key stages() {
  return list({"stages", &Case::stages}, name(""),
              "Names of stages of statics, in their order: each begins from the rest of the one before with "
              "the `events` that name it, dynamics from the rest of the last.",
              or_else("[]"));
}

}  // namespace hawser::model::schema_build
