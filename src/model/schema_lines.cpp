// Keys of lines: sections, ends, joints, attached items and length targets.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

void constant_speed(Feed& f, const Value& v) { f.speed = {{0, v.number}}; }
void dead_band(Feed& f, const Value& v) {
  f.min_tension = v.items[0].number;
  f.max_tension = v.items[1].number;
}
void between(LengthTarget& t, const Value& v) {
  t.min_length = v.items[0].number;
  t.max_length = v.items[1].number;
}
void temperature(Line& l, const Value& v) {
  if (v.number != 0) l.temperature_change = {{0, v.number}};
}

Key fed_end() {
  std::vector<Key> keys = feed_law();
  keys.insert(keys.begin(), number({"stock", &Feed::stock}, length,
                                   "length of the line from this end on that is inside the feeder at t = 0: "
                                   "the program holds it there, without weight and forces. With `tension` "
                                   "this is an estimate: statics finds the length that has this tension",
                                   above(0), required));
  keys.push_back(rows({"speed_table", &Feed::speed},
                      "`[[s, m/s], ...]`: linear between the rows, constant outside them", items(1)));
  return map(
      {"feed", &End::feed}, std::move(keys),
      "feeder that pays the line out and hauls it in at this end (winch, tensioner, reel), in dynamics; at "
      "an anchor or a body with prescribed motion; a line that resists bending must be `clamped` there",
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
                 "fixed at this point in space; an anchor at the height of the seabed lies on the bed"),
            reference({"body", &End::carrier, set(&End::kind, EndKind::body)}, "bodies",
                      "attached to this body ..."),
            vec3({"at", &End::at}, length, "... at this point of its frame"),
            reference({"joint", &End::carrier, set(&End::kind, EndKind::joint)}, "joints",
                      "pinned to the other ends at this joint, which is free to move"),
            vec3({"direction", unit(&End::direction)}, none,
                 "tangent of the line from end A to end B, in space (anchor) or in the body's frame, of any "
                 "length",
                 or_else_note("none; needed with `clamped` or `rotational_stiffness`")),
            boolean({"clamped", &End::clamped}, "the rotation is held as well", or_else("false")),
            number({"rotational_stiffness", &End::rotational_stiffness}, turning_stiffness,
                   "stiffness of a rotational spring towards `direction`: between pinned and clamped",
                   above(0), or_else_note("none: the end is pinned, unless clamped")),
            number(
                {"no_contact_within", &End::no_contact_within}, length,
                "length of the line from this end on that has no contact with volumes; 0: contact everywhere",
                at_least(0),
                or_else_note("for a held end that starts inside a volume: with that volume, up to the point "
                             "where the line is outside it")),
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
              "in `ends/direction` in the results",
              in_range(0, 3.14159265358979323846)),
       number({"touchdown", &LengthTarget::value, set(&LengthTarget::kind, LengthTarget::Kind::touchdown)},
              length, "arc length from end A of the touchdown point, the first one from the end `at`",
              at_least(0)),
       number(
           {"laid_length", &LengthTarget::value, set(&LengthTarget::kind, LengthTarget::Kind::laid_length)},
           length, "unstretched length on the seabed", above(0)),
       word({"at", &LengthTarget::line_end}, {{"end_a", LineEnd::A}, {"end_b", LineEnd::B}},
            "end to which the target refers", or_else("end_b")),
       integer("section", "section whose `length` is adjusted: its number, counted from 1 at end A",
               at_least(1), or_else_note("the longest section")),
       list({"between", set_by<LengthTarget>(between)}, number("", length, above(0)),
            "range of the length of that section", items(2, 2),
            or_else_note("0.5 and 1.5 times its `length`"))},
      "target that statics meets at t = 0 by adjusting the length of one section; its `length` is the first "
      "estimate",
      either({"tension", "declination_deg", "touchdown", "laid_length"}));
}

Key sections() {
  return list(
      {"sections", &Line::sections},
      map("",
          {reference({"type", &Section::type}, "line_types", "line type", required),
           number({"length", &Section::length}, length, "unstretched length", above(0), required),
           integer({"elements", &Section::elements}, "number of elements", in_range(1, 1e6)),
           number("element_length", length, "largest element length, in place of their number", above(0)),
           number({"grading", &Section::grading}, none, "length of the last element over that of the first",
                  in_range(1e-3, 1e3), or_else("1"))},
          either({"elements", "element_length"})),
      "sections from end A to end B", required, items(1));
}

Key start() {
  return one_of(
      "start",
      {word({"", &Line::start}, {{"auto", Start::automatic},
                                 {"catenary", Start::catenary},
                                 {"hanging", Start::hanging},
                                 {"straight", Start::straight}}),
       map("",
           {list({"points", &Line::points, set(&Line::start, Start::points)}, vec3("", length),
                 "polyline from end A to end B on which the line is placed", items(2)),
            text("from",
                 "results (.h5) of another run, beside the case: the shape of the line there, scaled to its "
                 "length, with its ends moved to their positions in this case ..."),
            number("time", time, "... at the output of this time", at_least(0),
                   or_else_note("the last output")),
            text("line", "... of the line of this name", or_else_note("the same name"))},
           either({"points", {{"from", "time", "line"}, {"from"}}}))},
      "shape from which statics starts; `auto`: a catenary between two held ends, a hanging line from one",
      or_else("auto"));
}

Key masses() {
  return list(
      {"masses", &Line::masses},
      map("", {arc({"at", &PointMass::at}, "arc length from end A; the program puts a node there", required),
               number({"mass", &PointMass::mass}, mass, "point mass", above(0), required),
               number({"volume", &PointMass::volume}, volume,
                      "displaced volume: a buoy or a clump weight, computed as a sphere", at_least(0),
                      or_else("0")),
               number({"drag_area", &PointMass::drag_area}, area, "drag coefficient times area", at_least(0),
                      or_else("0")),
               number({"Ca", &PointMass::Ca}, none, "added mass over the mass of the displaced water",
                      in_range(0, 100), or_else("0"))}),
      "point masses, clump weights and buoys", or_else("[]"));
}

Key bend_stiffeners() {
  return list({"bend_stiffeners", &Line::bend_stiffeners},
              map("", {arc({"at", &BendStiffener::at}, "arc length of its root from end A", required),
                       word({"towards", &BendStiffener::towards_a}, {{"end_a", true}, {"end_b", false}},
                            "the end of the line towards which it extends from its root",
                            or_else_note("`end_b`; with its root at `end_b`: `end_a`")),
                       rows({"EI", &BendStiffener::rows},
                            "bending stiffness added to that of the line, `[[m from the root, N m²], ...]`, "
                            "linear between the rows and zero outside them",
                            required, items(2))}),
              "bend stiffeners and other local additions to the bending stiffness of the line",
              or_else("[]"));
}

Key buried() {
  return list(
      {"buried", &Line::buried},
      map("", {arc({"from", &Buried::from}, "start of the buried part ...", or_else_note("`end_a`")),
               arc({"to", &Buried::to}, "... and its end", or_else_note("`end_b`")),
               map("resistance",
                   {number({"axial", &Buried::axial}, force_per_length, "along the line", above(0), required),
                    number({"normal", &Buried::normal}, force_per_length,
                           "across the line, in all directions", above(0), required)},
                   "largest resistance of the soil, per length", required),
               map("mobilisation_length",
                   {number({"axial", &Buried::axial_length}, length, "along the line", above(0),
                           or_else_note("1 % of the contact diameter")),
                    number({"normal", &Buried::normal_length}, length, "across the line", above(0),
                           or_else_note("10 % of the contact diameter"))},
                   "displacement at which the resistance is fully mobilised", or_else("{}"))}),
      "buried parts of the line. The soil holds them at their start positions until it yields: the anchor "
      "end of a mooring line below the bed (an automatic start shape is straight from it to the bed), a pipe "
      "in a trench (`start` gives its position). The bed does not act on them, and the water only by "
      "buoyancy",
      or_else("[]"));
}

Key change_of_temperature() {
  return one_of("temperature_change",
                {number({"", set_by<Line>(temperature)}, temperature_change),
                 rows({"", &Line::temperature_change}, items(2))},
                "temperature of the line above that at which its sections have their `length`, as one number "
                "or along the line, `[[m from end A, K], ...]`, linear between the rows and constant outside "
                "them; it acts on types with `thermal_expansion`, from statics on",
                or_else("0"));
}

Key loads() {
  return list(
      "loads",
      map("",
          {vec3("per_length", force_per_length, "distributed dead load per unstretched length ..."),
           arc("from", "... from this arc length", or_else_note("`end_a`")),
           arc("to", "... to this arc length", or_else_note("`end_b`")),
           arc("at", "arc length of a point load; the program puts a node there"),
           vec3("force", force, "dead force of a point load"),
           vec3("moment", moment, "dead moment of a point load, axes fixed in space"),
           number("ramp", time, "starts smoothly over this time in dynamics; 0: acts in statics as well",
                  at_least(0), or_else("0"))},
          either({{{"per_length", "from", "to"}, {"per_length"}}, {{"at", "force", "moment"}, {"at"}}})),
      "loads in addition to weight", or_else("[]"));
}

}  // namespace

std::vector<Key> feed_law() {
  return {number({"speed", set_by<Feed>(constant_speed)}, velocity,
                 "constant speed; above 0 pays out, below 0 hauls in, 0 holds the line"),
          number({"tension", &Feed::tension}, force, "tension that the feeder maintains at its feed point",
                 above(0)),
          list({"dead_band", set_by<Feed>(dead_band)}, number("", force, at_least(0)),
               "range of tension in which the feeder stops, after it has reached `tension`", items(2, 2),
               or_else_note("none: it never stops")),
          number({"speed_per_tension", &Feed::speed_per_tension}, none,
                 "speed per tension above `tension` (pays out) or below it (hauls in), m/s per N", above(0),
                 or_else_note("none: it keeps the tension exactly")),
          number({"max_speed", &Feed::max_speed}, velocity,
                 "largest speed of a feeder that maintains a tension, in both directions", above(0),
                 or_else_note("none"))};
}

Key joints() {
  return map_by_name(
      {"joints", &Case::joints},
      map("<joint>",
          {vec3({"start", &Joint::start}, length,
                "approximate position of the joint at equilibrium, from which statics starts", required),
           boolean({"rigid", &Joint::rigid},
                   "whether lines that resist bending are rigidly joined: they keep the angles between them "
                   "at the start (by their `direction`, or by the tangents of their start shapes)",
                   or_else("false"))}),
      "Joints, which connect ends of lines to each other, by name: bridles, branches, frames. At a joint "
      "that is not rigid at most one line may resist bending.",
      or_else("{}"));
}

Key lines() {
  return map_by_name("lines",
                     map("<line>", {sections(), line_end({"end_a", &Line::end_a}, "how end A is held"),
                                    line_end({"end_b", &Line::end_b}, "how end B is held"), start(), masses(),
                                    bend_stiffeners(), buried(), change_of_temperature(), loads(), target()}),
                     "Lines, by name. Arc lengths are unstretched and count from end A.", or_else("{}"));
}

}  // namespace hawser::model::schema_build
