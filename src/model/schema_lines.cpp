// Keys of lines: sections, ends, joints, attached items and length targets.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

void constant_speed(Feed& f, const Value& v) { f.speed = {{0, v.number}}; }
void dead_band(Feed& f, const Value& v) {
  f.least = v.items[0].number;
  f.most = v.items[1].number;
}
void between(LengthTarget& t, const Value& v) {
  t.least = v.items[0].number;
  t.most = v.items[1].number;
}
void temperature(Line& l, const Value& v) {
  if (v.number != 0) l.temperature_change = {{0, v.number}};
}

Key fed_end() {
  std::vector<Key> keys = feed_law();
  keys.insert(keys.begin(),
              number({"stock", &Feed::stock}, length,
                     "of the line, counted from this end on, is inside the feeder at t = 0: held at it, "
                     "without weight and forces; of a feeder that keeps a `tension` about as much: statics "
                     "finds how much is inside when that is there",
                     above(0), required));
  keys.push_back(rows({"speed_table", &Feed::speed},
                      "`[[s, m/s], ...]`: straight between the rows, constant before and beyond", items(1)));
  return map({"feed", &End::feed}, std::move(keys),
             "pays the line out here and hauls it in (winch, tensioner, reel), in dynamics; at an anchor or "
             "a body whose motion is prescribed; a line that resists bending must be `clamped` there",
             either({"speed",
                     "speed_table",
                     {{"tension", "dead_band", "speed_per_tension", "max_speed"}, {"tension"}}}));
}

Key line_end(Head head, const std::string& about) {
  return one_of(
      std::move(head),
      {word("", {"free"}),
       map("",
           {vec3({"anchor", &End::at, set(&End::kind, EndKind::anchor)}, length,
                 "fixed at this point in space; at the height of the seabed the line lies on it there"),
            reference({"body", &End::body, set(&End::kind, EndKind::body)}, "bodies",
                      "tied to this body ..."),
            vec3({"at", &End::at}, length, "... at this point of its frame"),
            reference({"joint", &End::body, set(&End::kind, EndKind::joint)}, "joints",
                      "pinned to the other ends at this joint, which moves freely"),
            vec3({"direction", unit(&End::direction)}, none,
                 "tangent of the line from end A to end B, in space (anchor) or in the body's frame; its "
                 "length does not matter",
                 or_else_note("none: needed if clamped or with `rotational_stiffness`")),
            boolean({"clamped", &End::clamped}, "rotation tied as well", or_else("false")),
            number({"rotational_stiffness", &End::rotational_stiffness}, turning_stiffness,
                   "of a spring that turns the end towards `direction`: between free and clamped", above(0),
                   or_else_note("none: the end turns freely, unless clamped")),
            number({"no_contact_within", &End::no_contact_within}, length,
                   "so much of the line, from this end on, has no contact with volumes; 0: all of it has",
                   at_least(0),
                   or_else_note("of a held end that starts inside a volume: up to where the line is clear of "
                                "it, with that volume")),
            fed_end()},
           either({"anchor", {{"body", "at"}, {"body", "at"}}, "joint"}))},
      about, required);
}

Key target() {
  return map(
      {"target", &Line::target},
      {number({"tension", &LengthTarget::value, set(&LengthTarget::kind, LengthTarget::Kind::tension)}, force,
              "effective tension at the end", above(0)),
       number({"declination_deg", &LengthTarget::value,
               set(&LengthTarget::kind, LengthTarget::Kind::declination)},
              angle,
              "angle at the end between the upward vertical and the line's direction from end A to end B, as "
              "of `ends/direction` in the results",
              in_range(0, 3.14159265358979323846)),
       number({"touchdown", &LengthTarget::value, set(&LengthTarget::kind, LengthTarget::Kind::touchdown)},
              length, "arc length from end A of the touchdown point that is the first one from `at`",
              at_least(0)),
       number(
           {"laid_length", &LengthTarget::value, set(&LengthTarget::kind, LengthTarget::Kind::laid_length)},
           length, "that lies on the seabed", above(0)),
       word({"at", &LengthTarget::at_a}, {{"end_a", true}, {"end_b", false}}, "the end", or_else("end_b")),
       integer("section", "whose `length` is sought: number from end A on, the first is 1", at_least(1),
               or_else_note("the longest")),
       list({"between", by<LengthTarget>(between)}, number("", length, above(0)),
            "lengths of that section that are tried", items(2, 2),
            or_else_note("half its `length` and one and a half times it"))},
      "what statics is to meet at t = 0 by the length of one section: its `length` is then only where the "
      "search begins",
      either({"tension", "declination_deg", "touchdown", "laid_length"}));
}

Key sections() {
  return list(
      {"sections", &Line::sections},
      map("",
          {reference({"type", &Section::type}, "line_types", "line type", required),
           number({"length", &Section::length}, length, "unstretched length", above(0), required),
           integer({"elements", &Section::elements}, "number of elements", in_range(1, 1e6)),
           number("element_length", length, "longest element wanted, instead of their number", above(0)),
           number({"grading", &Section::grading}, none, "length of the last element over the first",
                  in_range(1e-3, 1e3), or_else("1"))},
          either({"elements", "element_length"})),
      "from end A to end B", required, items(1));
}

Key start() {
  return one_of("start",
                {word({"", &Line::start}, {{"auto", Start::automatic},
                                           {"catenary", Start::catenary},
                                           {"hanging", Start::hanging},
                                           {"straight", Start::straight}}),
                 map("",
                     {list({"points", &Line::points, set(&Line::start, Start::points)}, vec3("", length),
                           "polyline from end A to end B that the line is laid along", items(2)),
                      text("from",
                           "results (.h5) of another run, beside the case: as it left the line, by share of "
                           "the length, its ends where they are now ..."),
                      number("time", time, "... at this output", at_least(0), or_else_note("the last")),
                      text("line", "... what the line is called there", or_else_note("as here"))},
                     either({"points", {{"from", "time", "line"}, {"from"}}}))},
                "shape from which statics starts; `auto`: catenary between two held ends, hanging from one",
                or_else("auto"));
}

Key masses() {
  return list({"masses", &Line::masses},
              map("", {arc({"at", &PointMass::at}, "arc length from end A, where a node is put", required),
                       number({"mass", &PointMass::mass}, mass, "point mass", above(0), required),
                       number({"volume", &PointMass::volume}, volume,
                              "displaced by it: a buoy or a clump weight, taken for a ball", at_least(0),
                              or_else("0")),
                       number({"drag_area", &PointMass::drag_area}, area, "drag coefficient times area",
                              at_least(0), or_else("0")),
                       number({"Ca", &PointMass::Ca}, none, "added mass over the mass of the displaced water",
                              in_range(0, 100), or_else("0"))}),
              "point masses, clump weights and buoys", or_else("[]"));
}

Key bend_stiffeners() {
  return list(
      {"bend_stiffeners", &Line::bend_stiffeners},
      map("", {arc({"at", &BendStiffener::at}, "arc length from end A of its root", required),
               word({"towards", &BendStiffener::towards_a}, {{"end_a", true}, {"end_b", false}},
                    "where it goes to from its root", or_else_note("`end_b`; from `end_b` on: `end_a`")),
               rows({"EI", &BendStiffener::rows},
                    "bending stiffness it adds to that of the line, `[[m from the root, N m²], ...]`, "
                    "straight between the rows and nothing beyond",
                    required, items(2))}),
      "bend stiffeners, and whatever else makes the bending stiffness vary along the line", or_else("[]"));
}

Key buried() {
  return list(
      {"buried", &Line::buried},
      map("", {arc({"from", &Buried::from}, "from this arc length ...", or_else_note("`end_a`")),
               arc({"to", &Buried::to}, "... to this one", or_else_note("`end_b`")),
               map("resistance",
                   {number({"axial", &Buried::axial}, force_per_length, "along the line", above(0), required),
                    number({"normal", &Buried::normal}, force_per_length, "across it, to all sides", above(0),
                           required)},
                   "of the soil at most, per length", required),
               map("mobilisation_length",
                   {number({"axial", &Buried::axial_length}, length, "along the line", above(0),
                           or_else_note("1 % of the contact diameter")),
                    number({"normal", &Buried::normal_length}, length, "across it", above(0),
                           or_else_note("10 % of the contact diameter"))},
                   "after which the soil resists with all of it", or_else("{}"))}),
      "stretches in the soil, which holds them where they start until it yields: an anchor's end below the "
      "bed (a line that starts by itself goes straight from it to the bed), a pipe in a trench (`start` says "
      "where); the bed does not act on them, nor water but for its buoyancy",
      or_else("[]"));
}

Key change_of_temperature() {
  return one_of("temperature_change",
                {number({"", by<Line>(temperature)}, temperature_change),
                 rows({"", &Line::temperature_change}, items(2))},
                "what the line is warmer than when its sections had their `length`, or along it `[[m from "
                "end A, K], ...]`, straight between the rows and constant beyond: types with "
                "`thermal_expansion` get longer; acts from statics on",
                or_else("0"));
}

Key loads() {
  return list(
      "loads",
      map("",
          {vec3("per_length", force_per_length, "distributed dead load per unstretched length ..."),
           arc("from", "... from this arc length", or_else_note("`end_a`")),
           arc("to", "... to this one", or_else_note("`end_b`")),
           arc("at", "point load at this arc length, where a node is put"),
           vec3("force", force, "dead force of a point load"),
           vec3("moment", moment, "dead moment of a point load, axes fixed in space"),
           number("ramp", time, "starts smoothly over this time in dynamics; 0: acts in statics already",
                  at_least(0), or_else("0"))},
          either({{{"per_length", "from", "to"}, {"per_length"}}, {{"at", "force", "moment"}, {"at"}}})),
      "loads besides weight", or_else("[]"));
}

}  // namespace

std::vector<Key> feed_law() {
  return {number({"speed", by<Feed>(constant_speed)}, velocity,
                 "constant; above 0 pays out, below 0 hauls in, 0 holds the line"),
          number({"tension", &Feed::tension}, force, "that the feeder keeps to, at its feed point", above(0)),
          list({"dead_band", by<Feed>(dead_band)}, number("", force, at_least(0)),
               "tensions between which the feeder rests, once it has reached `tension`", items(2, 2),
               or_else_note("none: it never rests")),
          number({"speed_per_tension", &Feed::speed_per_tension}, none,
                 "m/s for each N by which the tension is above `tension` (pays out) or below it (hauls in)",
                 above(0), or_else_note("none: it keeps the tension exactly")),
          number({"max_speed", &Feed::max_speed}, velocity, "of a feeder that keeps to a tension, either way",
                 above(0), or_else_note("none"))};
}

Key joints() {
  return names(
      {"joints", &Case::joints},
      map("<joint>",
          {vec3({"start", &Joint::start}, length, "roughly where it is at rest: statics starts from there",
                required),
           boolean({"rigid", &Joint::rigid},
                   "lines that resist bending are joined rigidly: they keep the angles between them that "
                   "they start with (their `direction` there, or the tangents of their start shapes)",
                   or_else("false"))}),
      "Where ends of lines are joined to each other, by name: bridles, branches, frames. Of lines that "
      "resist bending a joint that is not rigid takes one.",
      or_else("{}"));
}

Key lines() {
  return names({"lines", &Case::lines},
               map("<line>", {sections(), line_end({"end_a", &Line::end_a}, "how end A is held"),
                              line_end({"end_b", &Line::end_b}, "how end B is held"), start(), masses(),
                              bend_stiffeners(), buried(), change_of_temperature(), loads(), target()}),
               "Lines, by name. Arc lengths are unstretched and count from end A.", or_else("{}"));
}

}  // namespace hawser::model::schema_build
