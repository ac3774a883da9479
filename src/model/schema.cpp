// The keys of a case file. Order here is the order in the user guide.
#include "hawser/model/schema.hpp"

#include <utility>

#include "schema_build.hpp"

namespace hawser::model {

Key&& Key::is_required() && { return required = true, std::move(*this); }
Key&& Key::or_else(std::string literal) && { return fallback = std::move(literal), std::move(*this); }
Key&& Key::or_else_note(std::string text) && { return fallback_note = std::move(text), std::move(*this); }
Key&& Key::above(double x) && { return bounds.above = x, std::move(*this); }
Key&& Key::at_least(double x) && { return bounds.at_least = x, std::move(*this); }
Key&& Key::at_most(double x) && { return bounds.at_most = x, std::move(*this); }
Key&& Key::items(std::size_t least, std::size_t most) && {
  min_items = least, max_items = most;
  return std::move(*this);
}
Key&& Key::either(std::vector<Group> g, bool needed) && {
  groups = std::move(g), group_required = needed;
  return std::move(*this);
}

using namespace schema_build;

namespace {

Key harmonic(std::string about) {
  return map(
      "harmonic",
      {vec3("amplitude", length, "amplitudes of x, y, z: offset = amplitude sin(2 pi t / period + phase)")
           .or_else(kZero),
       vec3("rotation_amplitude_deg", angle, "amplitudes of the rotation vector").or_else(kZero),
       number("period", time, "period").above(0).is_required(),
       vec3("phase_deg", angle, "phases of x, y, z").or_else(kZero),
       vec3("rotation_phase_deg", angle, "phases of the rotation vector").or_else(kZero)},
      std::move(about));
}

Key table(std::string about) {
  return map("table",
             {text("file",
                   "text file beside the case: columns t [s], x, y, z [m] and, if it turns, the rotation "
                   "vector [deg]; blanks or commas between, `#` starts a comment"),
              list("rows", list("", number("", none), "").items(4, 7),
                   "the same, written here: "
                   "`[[t, x, y, z], ...]`")
                  .items(2),
              word("interpolation", {"spline", "monotone", "linear"},
                   "between rows: a cubic spline; a cubic that stays between them; straight lines, whose "
                   "velocity jumps at the rows")
                  .or_else("spline")},
             std::move(about))
      .either({{{"file"}, {"file"}}, {{"rows"}, {"rows"}}}, true);
}

// With `motion`, whatever that is.
Key drift() {
  return map("drift",
             {vec3("offset", length, "away from `position`").or_else(kZero),
              vec3("rotation_deg", angle, "rotation vector").or_else(kZero),
              harmonic("slow sinusoidal motion on top of it"), table("slow motion against time on top of it"),
              number("ramp", time, "the drift starts smoothly over this time; 0: it is there in statics")
                  .at_least(0)
                  .or_else("0")},
             "slow drift that carries the body with its other motion; with `rao` the vessel meets the waves "
             "where it has drifted to");
}

Key motion() {
  return map("motion",
             {vec3("velocity", velocity, "constant velocity"),
              map("rotation",
                  {vec3("axis", none,
                        "direction of the axis through the body's position, fixed in space; its length "
                        "does not matter")
                       .is_required(),
                   number("rate", angular_velocity, "turning rate, right-handed about the axis")
                       .is_required()},
                  "constant turning"),
              harmonic("sinusoidal motion about the position at rest"),
              table("offsets from `position` against time"),
              map("rao",
                  {text("file",
                        "text file beside the case: columns period [s], direction [deg] the wave goes to as "
                        "seen "
                        "from the bow (0: from astern), then surge, sway, heave [m/m], roll, pitch, yaw "
                        "[deg/m], each "
                        "amplitude followed by its phase [deg]; every direction at the same periods"),
                   list("rows", list("", number("", none), "").items(14, 14), "the same, written here")
                       .items(1),
                   word("phase", {"lag", "lead"},
                        "what phases are: how far the motion comes after the crest at the body's origin, or "
                        "before it")
                       .or_else("lag"),
                   word("symmetry", {"none", "port_starboard"},
                        "of a table of one side (0 to 180 deg): `port_starboard` has the vessel answer waves "
                        "from the other side as in a mirror, with sway, roll and yaw the other way")
                       .or_else("none")},
                  "moves in the waves by response amplitude operators, about `position`")
                  .either({{{"file"}, {"file"}}, {{"rows"}, {"rows"}}}, true),
              drift(),
              number("ramp", time,
                     "the motion starts smoothly over this time (quintic); of `rao`: that of the waves")
                  .at_least(0)
                  .or_else("0")},
             "prescribed motion; without it the body stands still")
      .either({{{"velocity", "rotation"}, {}},
               {{"harmonic"}, {"harmonic"}},
               {{"table"}, {"table"}},
               {{"rao"}, {"rao"}}},
              false);
}

Key floating() {
  return map(
      "floating",
      {number("mass", mass, "mass").above(0).is_required(),
       vec3("inertia", inertia, "moments of inertia about the centre of mass, along the body's axes")
           .above(0)
           .is_required(),
       vec3("products_of_inertia", inertia, "Ixy, Iyz, Ixz: off the diagonal of the inertia").or_else(kZero),
       vec3("centre_of_mass", length, "in the body's frame").or_else(kZero),
       boolean("weight", "gravity acts on it; `false`: buoyancy that is not modelled carries its weight")
           .or_else("false"),
       vec3("velocity", velocity, "of the centre of mass at t = 0, axes of space").or_else(kZero),
       vec3("angular_velocity", angular_velocity, "at t = 0, axes of the body").or_else(kZero),
       vec3("stiffness", point_stiffness,
            "springs in x, y, z that pull it to where `motion` (or `position`) wants it")
           .at_least(0)
           .or_else(kZero),
       vec3("damping", point_damping, "dampers in x, y, z beside them").at_least(0).or_else(kZero),
       vec3("turning_stiffness", turning_stiffness, "springs against turning, axes of the body")
           .at_least(0)
           .or_else(kZero),
       vec3("turning_damping", turning_damping, "dampers beside them").at_least(0).or_else(kZero)},
      "it moves by its own mass, held by springs, and touches other bodies; without it its motion is "
      "prescribed");
}

Key bodies() {
  return names("bodies",
               map("<body>",
                   {vec3("position", length, "of the body's origin at t = 0").or_else(kZero),
                    vec3("rotation_deg", angle, "rotation vector at t = 0").or_else(kZero), motion(),
                    floating(),
                    map("on",
                        {reference("line", "lines", "the line").is_required(),
                         arc("at", "where on it: the nearest node, between elements that resist bending")
                             .is_required()},
                        "it rides on a line and turns with it; `position` and `rotation_deg` are then seen "
                        "from "
                        "there, with x along the line")},
                   ""),
               "Rigid bodies that carry volumes and line ends, by name.")
      .or_else("{}");
}

Key line_end(std::string name, const std::string& about) {
  return one_of(
      std::move(name),
      {word("", {"free"}),
       map("",
           {vec3("anchor", length,
                 "fixed at this point in space; at the height of the seabed the line lies on it there"),
            reference("body", "bodies", "tied to this body ..."),
            vec3("at", length, "... at this point of its frame"),
            reference("joint", "joints", "pinned to the other ends at this joint, which moves freely"),
            vec3("direction", none,
                 "tangent of the line from end A to end B, in space (anchor) or in the body's "
                 "frame; its length does not matter")
                .or_else_note("none: needed if clamped or with `rotational_stiffness`"),
            boolean("clamped", "rotation tied as well").or_else("false"),
            number("rotational_stiffness", turning_stiffness,
                   "of a spring that turns the end towards `direction`: between free and clamped")
                .above(0)
                .or_else_note("none: the end turns freely, unless clamped"),
            number("no_contact_within", length,
                   "so much of the line, from this end on, has no contact with volumes; 0: all of it has")
                .at_least(0)
                .or_else_note(
                    "of a held end that starts inside a volume: up to where the line is clear of it, "
                    "with that volume")},
           "")
           .either({{{"anchor"}, {"anchor"}}, {{"body", "at"}, {"body", "at"}}, {{"joint"}, {"joint"}}},
                   true)},
      about);
}

Key joints() {
  return names(
             "joints",
             map("<joint>",
                 {vec3("start", length, "roughly where it is at rest: statics starts from there")
                      .is_required(),
                  boolean(
                      "rigid",
                      "lines that resist bending are joined rigidly: they keep the angles between them that "
                      "they start with (their `direction` there, or the tangents of their start shapes)")
                      .or_else("false")},
                 ""),
             "Where ends of lines are joined to each other, by name: bridles, branches, frames. Of lines "
             "that "
             "resist bending a joint that is not rigid takes one.")
      .or_else("{}");
}

Key lines() {
  Key sections =
      list("sections",
           map("",
               {reference("type", "line_types", "line type").is_required(),
                number("length", length, "unstretched length").above(0).is_required(),
                integer("elements", "number of elements").at_least(1).at_most(1e6),
                number("element_length", length, "longest element wanted, instead of their number").above(0),
                number("grading", none, "length of the last element over the first")
                    .at_least(1e-3)
                    .at_most(1e3)
                    .or_else("1")},
               "")
               .either({{{"elements"}, {}}, {{"element_length"}, {}}}, true),
           "from end A to end B")
          .is_required()
          .items(1);
  Key buried =
      list("buried",
           map("",
               {arc("from", "from this arc length ...").or_else_note("`end_a`"),
                arc("to", "... to this one").or_else_note("`end_b`"),
                map("resistance",
                    {number("axial", force_per_length, "along the line").above(0).is_required(),
                     number("normal", force_per_length, "across it, to all sides").above(0).is_required()},
                    "of the soil at most, per length")
                    .is_required(),
                map("mobilisation_length",
                    {number("axial", length, "along the line")
                         .above(0)
                         .or_else_note("1 % of the contact diameter"),
                     number("normal", length, "across it")
                         .above(0)
                         .or_else_note("10 % of the contact diameter")},
                    "after which the soil resists with all of it")
                    .or_else("{}")},
               ""),
           "stretches in the soil, which holds them where they start until it yields: an anchor's end below "
           "the "
           "bed (a line that starts by itself goes straight from it to the bed), a pipe in a trench (`start` "
           "says where); the bed does not act on them, nor water but for its buoyancy")
          .or_else("[]");
  Key loads =
      list(
          "loads",
          map("",
              {vec3("per_length", force_per_length, "distributed dead load per unstretched length ..."),
               arc("from", "... from this arc length").or_else_note("`end_a`"),
               arc("to", "... to this one").or_else_note("`end_b`"),
               arc("at", "point load at this arc length"), vec3("force", force, "dead force of a point load"),
               vec3("moment", moment, "dead moment of a point load, axes fixed in space"),
               number("ramp", time, "starts smoothly over this time in dynamics; 0: acts in statics already")
                   .at_least(0)
                   .or_else("0")},
              "")
              .either({{{"per_length", "from", "to"}, {"per_length"}}, {{"at", "force", "moment"}, {"at"}}},
                      true),
          "loads besides weight")
          .or_else("[]");
  return names(
             "lines",
             map("<line>",
                 {std::move(sections), line_end("end_a", "how end A is held").is_required(),
                  line_end("end_b", "how end B is held").is_required(),
                  one_of(
                      "start",
                      {word("", {"auto", "catenary", "hanging", "straight"}),
                       map("",
                           {list("points", vec3("", length),
                                 "polyline from end A to end B that the line is laid "
                                 "along")
                                .items(2),
                            text("from",
                                 "results (.h5) of another run, beside the case: as it left the "
                                 "line, by share of the length, its ends where they are now ..."),
                            number("time", time, "... at this output").at_least(0).or_else_note("the last"),
                            text("line", "... what the line is called there").or_else_note("as here")},
                           "")
                           .either({{{"points"}, {"points"}}, {{"from", "time", "line"}, {"from"}}}, true)},
                      "shape from which statics starts; `auto`: catenary between two held ends, hanging "
                      "from one")
                      .or_else("auto"),
                  list("masses",
                       map("",
                           {arc("at", "arc length from end A").is_required(),
                            number("mass", mass, "point mass").above(0).is_required(),
                            number("volume", volume,
                                   "displaced by it: a buoy or a clump weight, taken for a ball")
                                .at_least(0)
                                .or_else("0"),
                            number("drag_area", area, "drag coefficient times area").at_least(0).or_else("0"),
                            number("Ca", none, "added mass over the mass of the displaced water")
                                .at_least(0)
                                .at_most(100)
                                .or_else("0")},
                           ""),
                       "point masses, clump weights and buoys")
                      .or_else("[]"),
                  list("bend_stiffeners",
                       map("",
                           {arc("at", "arc length from end A of its root").is_required(),
                            word("towards", {"end_a", "end_b"}, "where it goes to from its root")
                                .or_else_note("`end_b`; from `end_b` on: `end_a`"),
                            list("EI", list("", number("", none), "").items(2, 2),
                                 "bending stiffness it adds to that of the line, `[[m from the root, N m²], "
                                 "...]`, straight between the rows and nothing beyond")
                                .is_required()
                                .items(2)},
                           ""),
                       "bend stiffeners, and whatever else makes the bending stiffness vary along the line")
                      .or_else("[]"),
                  std::move(buried),
                  one_of("temperature_change",
                         {number("", temperature_change),
                          list("", list("", number("", none), "").items(2, 2), "").items(2)},
                         "what the line is warmer than when its sections had their `length`, or along it "
                         "`[[m from end A, K], "
                         "...]`, straight between the rows and constant beyond: types with "
                         "`thermal_expansion` get longer; acts from statics on")
                      .or_else("0"),
                  std::move(loads), target()},
                 ""),
             "Lines, by name. Arc lengths are unstretched and count from end A.")
      .or_else("{}");
}

Key all_or_names(std::string name, std::string to, std::string about) {
  return one_of(std::move(name), {word("", {"all"}), list("", reference("", std::move(to)), "")},
                std::move(about))
      .or_else("all");
}

}  // namespace

const Key& case_schema() {
  static const Key schema = map(
      "case",
      {integer("hawser", "version of the case format; must be 1").at_least(1).at_most(1).is_required(),
       text("title", "title, for pictures and reports").or_else(""), environment(), line_types(), bodies(),
       volumes(), supports(), joints(), lines(),
       map("contact",
           {all_or_names("lines", "lines", "lines that take part in contact"),
            all_or_names("volumes", "volumes", "volumes that take part in contact"),
            word("method", {"line", "nodes", "gap"},
                 "where a line touches: anywhere along its elements (`line`) or at its nodes alone; to "
                 "compare with, at the nodes: `gap` has a spring each, in the direction of the surface "
                 "nearest at the start")
                .or_else("line"),
            boolean("rolling",
                    "friction acts at the lines' surface: it turns them about their axes, and a line that "
                    "rolls does not slide (beams, method `line`)")
                .or_else("false"),
            number("penetration_warning", none,
                   "share of a line's radius above which a penetration is warned of")
                .above(0)
                .or_else("0.1"),
            between_lines()},
           "Contact of lines with volumes and with lines.")
           .or_else("{}"),
       one_of("statics",
              {boolean(""),
               map("",
                   {boolean("enabled", "find the equilibrium before dynamics").or_else("true"),
                    number("tolerance", none, "residual over the size of the internal forces")
                        .above(0)
                        .at_most(1e-2)
                        .or_else("1e-8"),
                    boolean("contact_friction",
                            "friction of volumes and between lines acts in statics too, against the "
                            "way of the lines from where their `start` puts them; else it acts from "
                            "the equilibrium without it on")
                        .or_else("false"),
                    integer("max_iterations", "Newton iterations of a stage")
                        .at_least(1)
                        .at_most(1e6)
                        .or_else("500"),
                    word("dynamic_relaxation", {"auto", "always", "never"},
                         "lets lines come to rest from the start shape by a damped motion, for "
                         "slack and floating lines, before Newton's iteration: where that alone "
                         "fails (`auto`), `always` or `never`")
                        .or_else("auto"),
                    integer("relaxation_steps", "steps of that motion at most")
                        .at_least(1)
                        .at_most(1e7)
                        .or_else("5000")},
                   "")},
              "Static equilibrium at t = 0; `false` starts dynamics from the start shape.")
           .or_else("true"),
       map("start",
           {text("from", "results (.h5) of another run, beside the case").is_required(),
            number("time", time, "of its output").at_least(0).or_else_note("the last")},
           "Lines without a `start` of their own begin as another run left those of the same name; statics "
           "goes on from there, whatever has changed."),
       map("dynamics",
           {number("duration", time, "simulated time").above(0).is_required(),
            one_of("step", {word("", {"auto"}), number("", time).above(0)}, "time step").or_else("auto"),
            number("max_step", time, "largest automatic step").above(0).or_else_note("chosen by the program"),
            number("min_step", time, "smallest step, below which the run stops")
                .above(0)
                .or_else_note("chosen by the program"),
            boolean("resolve_impacts",
                    "where something strikes, a step that is fixed is divided as an automatic one would be: "
                    "22 in a period of the contact, ending at the touch; `false`: it stays as it is")
                .or_else("true"),
            number("rho_infinity", none,
                   "spectral radius at high frequency of the generalized-alpha method; 1: no "
                   "numerical damping")
                .at_least(0)
                .at_most(1)
                .or_else("0.8"),
            number("tolerance", none, "residual over the size of the internal forces")
                .above(0)
                .at_most(1e-2)
                .or_else("1e-8"),
            number("error_tolerance", length, "local error of a step in automatic stepping")
                .above(0)
                .or_else_note("chosen by the program")},
           "Motion in time; without this key only statics is run."),
       output()},
      "");
  return schema;
}

}  // namespace hawser::model
