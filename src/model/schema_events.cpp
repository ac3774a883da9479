// The keys of what happens: actions, what events wait for, stages of statics.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

Key line() { return reference("line", "lines", "the line").is_required(); }
Key end(const char* about) { return word("end", {"end_a", "end_b"}, about).is_required(); }

Key feed() {
  std::vector<Key> keys{line(), end("its end with a `feed`")};
  for (Key& k : feed_law()) keys.push_back(std::move(k));
  keys.push_back(number("ramp", time, "in which the speed changes from what it is").at_least(0).or_else("0"));
  keys.push_back(
      number("paid_out", length, "in a stage of statics: so much is paid out; below 0 it is hauled in"));
  return map("feed", std::move(keys),
             "starts or stops a feeder, gives it another law, or lets statics pay out");
}

// One of them.
std::vector<Key> actions() {
  return {
      map("release", {line(), end("its end, held by an anchor, a body, a joint or another event")},
          "lets an end of a line go: it parts, or is cast off"),
      map("cut", {line(), number("at", length, "arc length from end A").above(0).is_required()},
          "parts a line: both parts go on with a free end"),
      map("attach",
          {line(), end("its end, free by then"),
           reference("body", "bodies", "that holds it; without it the end is fixed in space"),
           vec3("at", length, "place in the body's frame (or in space) at which it is expected")
               .or_else_note("wherever it is"),
           number("within", length, "distance from `at` that is allowed: the end is held where it is")
               .above(0),
           boolean("clamped", "rotation held as well, as it is then").or_else("false")},
          "holds an end of a line from then on where it is, as seen from the body"),
      feed(),
      map("contact",
          {text("volume",
                "the volume; of `supports` the name of a group, of a box (`stinger 3`) or of a roller")
               .is_required(),
           boolean("enabled", "whether lines touch it from then on").is_required()},
          "switches the contact of lines with a volume on or off; of which the first event switches it on is "
          "off until then"),
      map("friction", {boolean("enabled", "whether statics has it from this stage on").is_required()},
          "switches friction on or off in statics: of lines on volumes, on each other and on the bed"),
      map("current",
          {number("factor", none, "times the `current` of the water, from this stage on").is_required()},
          "scales the current from a stage of statics on"),
  };
}

const std::vector<Group> kActions = {
    {{"release"}, {"release"}}, {{"cut"}, {"cut"}},           {{"attach"}, {"attach"}},  {{"feed"}, {"feed"}},
    {{"contact"}, {"contact"}}, {{"friction"}, {"friction"}}, {{"current"}, {"current"}}};

Key waits_for(std::string name, std::vector<Key> keys, Dimension unit, const std::string& about) {
  keys.push_back(number("above", unit, "it happens when the value gets above this"));
  keys.push_back(number("below", unit, "or below this"));
  return map(std::move(name), std::move(keys), about)
      .either({{{"above"}, {"above"}}, {{"below"}, {"below"}}}, true);
}

Key condition() {
  return map("when",
             {waits_for("tension", {line(), arc("at", "arc length from end A").is_required()}, force,
                        "effective tension of a line, at the node that is nearest"),
              waits_for("position",
                        {reference("line", "lines", "of a line ..."), arc("at", "... at this arc length"),
                         reference("body", "bodies", "or of the origin of a body"),
                         word("axis", {"x", "y", "z"}, "coordinate in space").is_required()},
                        length, "a coordinate of a node of a line, or of a body"),
              waits_for("paid_out", {line(), end("its end with a `feed`")}, length,
                        "length that was paid out since t = 0")},
             "a condition, met to 0.1 % of a tension and 1 mm of a length")
      .either({{{"tension"}, {"tension"}}, {{"position"}, {"position"}}, {{"paid_out"}, {"paid_out"}}}, true);
}

}  // namespace

Key events() {
  std::vector<Key> keys = actions();
  keys.push_back(text("name", "by which other events know it").or_else_note("what it does"));
  keys.push_back(number("time", Dimension::time, "when it happens").at_least(0));
  keys.push_back(
      number("tension", force,
             "it happens when the effective tension at that end, or where the line is cut, reaches "
             "this")
          .above(0));
  keys.push_back(condition());
  keys.push_back(text("after", "it happens after the event of this name"));
  keys.push_back(number("delay", Dimension::time, "so much later").at_least(0).or_else("0"));
  keys.push_back(text("stage", "it happens at the beginning of this stage of statics"));
  return list("events", map("", std::move(keys), "").either(kActions, true),
              "What happens, each event once: at a `time`, at a `tension`, at a condition (`when`), `after` "
              "another, or in a `stage` of statics. What is to be attached within a distance may wait for "
              "that "
              "alone.")
      .or_else("[]");
}

Key stages() {
  return list("stages", make(Type::name, "", ""),
              "Names of stages of statics, in their order: each begins from the rest of the one before with "
              "the "
              "`events` that name it, dynamics from the rest of the last.")
      .or_else("[]");
}

}  // namespace hawser::model::schema_build
