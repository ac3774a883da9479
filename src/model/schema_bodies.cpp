// Keys of bodies: position, motion and mass.
#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

ConstantMotion& steady(Body& b) {
  if (!std::holds_alternative<ConstantMotion>(b.motion)) b.motion.emplace<ConstantMotion>();
  return std::get<ConstantMotion>(b.motion);
}

// Field that selects a kind of motion.
template <class M>
Field moves() {
  return by<Body>([](Body& b, const Value& v) { take(v, b.motion.emplace<M>()); });
}

Key harmonic(const Field& field, std::string about) {
  return map({"harmonic", field},
             {vec3({"amplitude", &HarmonicMotion::amplitude}, length,
                   "amplitudes of x, y, z: offset = amplitude sin(2 pi t / period + phase)", or_else(kZero)),
              vec3({"rotation_amplitude_deg", &HarmonicMotion::rotation_amplitude}, angle,
                   "amplitudes of the rotation vector, about axes of space", or_else(kZero)),
              number({"period", &HarmonicMotion::period}, time, "period", above(0), required),
              vec3({"phase_deg", &HarmonicMotion::phase}, angle, "phases of x, y, z", or_else(kZero)),
              vec3({"rotation_phase_deg", &HarmonicMotion::rotation_phase}, angle,
                   "phases of the rotation vector", or_else(kZero))},
             std::move(about));
}

Key table(const Field& field, std::string about) {
  return map({"table", field},
             {text("file",
                   "text file beside the case: columns t [s], x, y, z [m] and, if it turns, the rotation "
                   "vector [deg]; blanks or commas between, `#` starts a comment"),
              list("rows", list("", number("", none), items(4, 7)),
                   "the same, written here: `[[t, x, y, z], ...]`", items(2)),
              word({"interpolation", &TableMotion::between},
                   {{"spline", BetweenRows::spline},
                    {"monotone", BetweenRows::monotone},
                    {"linear", BetweenRows::linear}},
                   "between rows: a cubic spline; a cubic that stays between them; straight lines, whose "
                   "velocity jumps at the rows",
                   or_else("spline"))},
             std::move(about), either({"file", "rows"}));
}

// Drift in addition to `motion`.
Key drift() {
  return map({"drift", &Body::drift},
             {vec3({"offset", &Drift::offset}, length, "away from `position`", or_else(kZero)),
              vec3({"rotation_deg", &Drift::rotation}, angle, "rotation vector", or_else(kZero)),
              harmonic(&Drift::harmonic, "slow sinusoidal motion on top of it"),
              table(&Drift::table, "slow motion against time on top of it"),
              number({"ramp", &Drift::ramp}, time,
                     "the drift starts smoothly over this time; 0: it is there in statics", at_least(0),
                     or_else("0"))},
             "slow drift that carries the body with its other motion; with `rao` the vessel meets the waves "
             "where it has drifted to");
}

Key motion() {
  return map(
      "motion",
      {vec3({"velocity", by<Body>([](Body& b, const Value& v) { put(steady(b).velocity, v); })}, velocity,
            "constant velocity"),
       map({"rotation", by<Body>([](Body& b, const Value& v) { take(v, steady(b)); })},
           {vec3({"axis", unit(&ConstantMotion::axis)}, none,
                 "direction of the axis through the body's position, fixed in space; its length does not "
                 "matter",
                 required),
            number({"rate", &ConstantMotion::rate}, angular_velocity,
                   "turning rate, right-handed about the axis", required)},
           "constant turning"),
       harmonic(moves<HarmonicMotion>(), "sinusoidal motion about the position at rest"),
       table(moves<TableMotion>(), "offsets from `position` against time"),
       map("rao",
           {text("file",
                 "text file beside the case: columns period [s], direction [deg] the wave goes to as seen "
                 "from the bow (0: from astern), then surge, sway, heave [m/m], roll, pitch, yaw [deg/m], "
                 "each amplitude followed by its phase [deg]; every direction at the same periods"),
            list("rows", list("", number("", none), items(14, 14)), "the same, written here", items(1)),
            word("phase", {"lag", "lead"},
                 "what phases are: how far the motion comes after the crest at the body's origin, or before "
                 "it",
                 or_else("lag")),
            word("symmetry", {"none", "port_starboard"},
                 "of a table of one side (0 to 180 deg): `port_starboard` has the vessel answer waves from "
                 "the other side as in a mirror, with sway, roll and yaw the other way",
                 or_else("none"))},
           "moves in the waves by response amplitude operators, about `position`", either({"file", "rows"})),
       drift(),
       number({"ramp", &Body::ramp}, time,
              "the motion starts smoothly over this time (quintic); of `rao`: that of the waves", at_least(0),
              or_else("0"))},
      "prescribed motion; without it the body stands still",
      at_most_one({{{"velocity", "rotation"}, {}}, "harmonic", "table", "rao"}));
}

Key body_in_water() {
  return map(
      {"in_water", &BodyMass::in_water},
      {number({"volume", &BodyInWater::volume}, volume,
              "of the water that it displaces when it is wholly under water", above(0), required),
       number({"height", &BodyInWater::height}, length,
              "over which it gets wet, half of it above its `centre_of_buoyancy`", above(0), required),
       vec3({"centre_of_buoyancy", &BodyInWater::centre, &BodyInWater::drag_centre}, length,
            "in the body's frame; inertia of the water acts there as well", or_else(kZero)),
       vec3({"drag_area", &BodyInWater::drag_area}, area, "projected areas along the body's axes",
            at_least(0), or_else(kZero)),
       vec3({"Cd", by<BodyInWater>([](BodyInWater& w, const Value& v) {
               Vec3 Cd;
               put(Cd, v);
               w.drag_area = w.drag_area.cwiseProduct(Cd);
             })},
            none, "drag coefficients along the body's axes", in_range(0, 100), or_else("[1, 1, 1]")),
       vec3({"centre_of_drag", &BodyInWater::drag_centre}, length, "in the body's frame",
            or_else_note("`centre_of_buoyancy`")),
       vec3("Ca", none, "added mass over the mass of the water of `volume`, along the body's axes ...",
            in_range(0, 100)),
       vec3({"added_mass", &BodyInWater::added_mass}, mass, "... or the added mass itself", at_least(0))},
      "water acts on it by Morison's equation along its axes ([theory](../theory/bodies-in-water.md)); "
      "`weight: true` belongs to it",
      at_most_one({"Ca", "added_mass"}));
}

// A 6x6 matrix, row by row.
template <class Of>
Key six_by_six(const char* name, Mat6 Of::*matrix, std::string about, auto... parts) {
  const auto fill = [matrix](Of& of, const Value& v) {
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) (of.*matrix)(i, j) = v.items[i].items[j].number;
  };
  return list({name, by<Of>(fill)}, list("", number("", none), items(6, 6)), std::move(about), items(6, 6),
              parts...);
}

Key body_hydrodynamics() {
  using H = BodyHydrodynamics;
  const auto by_freedom = [](H& h, const Value& v) {
    for (int i = 0; i < 6; ++i) {
      const Value& row = v.items[i];
      if (row.items.empty()) h.quadratic_damping(i, i) = row.number;
      for (size_t j = 0; j < row.items.size(); ++j)
        h.quadratic_damping(i, static_cast<int>(j)) = row.items[j].number;
    }
  };
  return map(
      {"hydrodynamics", &BodyMass::hydrodynamics},
      {text({"wamit", &H::files},
            "path, from the case, of WAMIT's output files without their endings: `.1` and `.hst`, `.3` where "
            "there are waves; each may be packed by gzip"),
       text({"capytaine", &H::files, set(&H::format, H::Format::capytaine)},
            "instead: Capytaine's NetCDF file"),
       text({"bemio", &H::files, set(&H::format, H::Format::bemio)}, "instead: BEMIO's HDF5 file"),
       number({"length_scale", &H::length}, length, "ULEN of the files", above(0), or_else("1")),
       integer({"body", &H::body}, "which of the files' bodies it is", in_range(1, 20), or_else("1")),
       vec3({"origin_in_file", &H::in_file}, length,
            "where the files have the body's origin (XBODY), about which their moments are",
            or_else_note(
                "[0, 0, 0]; of `capytaine` its centre of rotation, of `bemio` its centre of gravity")),
       number({"displaced_volume", &H::volume}, volume,
              "of the body where the files have it, of water of the case", above(0),
              or_else_note("what carries its mass")),
       boolean({"gravity_in_stiffness", &H::gravity_in_stiffness},
               "whether the stiffness of the files has the part that the body's weight has in it (WAMIT's, "
               "where it was given mass and centre of gravity)",
               or_else_note("false; true of `capytaine`, whose stiffness has it")),
       vec3({"place", &H::place}, length,
            "of the body's origin where the files have it: motion is counted from there",
            or_else_note("x and y of `position`, z of `origin_in_file`")),
       number({"heading_deg", &H::heading}, angle, "of the body there",
              or_else_note("that of `rotation_deg`")),
       number({"follow_period", &H::follow}, time,
              "waves meet it, and its coefficients have the axes, where its motion slower than this period "
              "has it; 0: "
              "at `place` and `heading_deg`, wherever it is",
              at_least(0), or_else("100")),
       word({"symmetry", &H::mirrored}, {{"none", false}, {"port_starboard", true}},
            "of files with directions of one side (0 to 180 deg): `port_starboard` has waves from the other "
            "side "
            "act as in a mirror, with sway, roll and yaw the other way",
            or_else("none")),
       boolean({"excitation", &H::excitation}, "whether the waves of the case act on it", or_else("true")),
       word({"second_order", &H::second_order},
            {{"none", SecondOrder::none},
             {"mean", SecondOrder::mean},
             {"newman", SecondOrder::newman},
             {"full", SecondOrder::full}},
            "slow drift by the waves: its mean; by Newman's approximation from mean forces (`.12d`, `.8`, "
            "`.9` "
            "or `.7`); by all difference-frequency forces (`.12d`)",
            or_else("none")),
       six_by_six("stiffness", &H::stiffness,
                  "added to it about the body's origin, from `place`: six rows of six, N/m, N, N m/rad"),
       six_by_six("damping", &H::damping,
                  "linear damping added about the body's origin: six rows of six, N s/m, N s, N m s"),
       map("wave_drift_damping",
           {text("file",
                 "text file beside the case: columns period [s] and either Bxx, Byy, Bzz or the 9 numbers of "
                 "a matrix by rows, of surge, sway and yaw; `#` starts a comment"),
            list("rows", list("", number("", none), items(4, 10)),
                 "the same, written here: `[[period, Bxx, Byy, Bzz], ...]`", items(1))},
           "damping of its velocities by the waves of the case, over the square of their amplitude: N s/m³, "
           "between surge or sway and yaw N s/m², of yaw N m s/m²; straight between the frequencies",
           either({"file", "rows"})),
       list({"quadratic_damping", by<H>(by_freedom)},
            one_of("", {number("", none, at_least(0)), list("", number("", none), items(6, 6))}),
            "for each of the six velocities v of its origin the force is this times |v| v: N s²/m² and N m "
            "s²; "
            "or six rows of six, times all |v| v",
            items(6, 6))},
      "the sea acts on it by the coefficients of a diffraction program "
      "([theory](../theory/platforms.md)); its `weight` acts",
      either({"wamit", "capytaine", "bemio"}));
}

Key body_hull() {
  const Field names = by<BodyHull>([](BodyHull& h, const Value& v) {
    for (const Value& n : v.items) h.volumes.push_back(n.text);
  });
  return map({"hull", &BodyMass::hull},
             {list({"volumes", names}, reference("", "volumes"),
                   "volumes of this body that displace water: closed meshes or shapes that do not overlap",
                   items(1), required),
              boolean({"wave_pressure", &BodyHull::wave_pressure},
                      "the pressure of the waves (Froude-Krylov) acts on the wetted surface as well",
                      or_else_note("true; beside `hydrodynamics`, whose wave forces contain it, false"))},
             "the pressure of the water acts on its surface up to the water level of the moment "
             "([theory](../theory/hulls.md)), in place of the hydrostatic stiffness of `hydrodynamics`; its "
             "`weight` acts");
}

Key body_members() {
  return list(
      {"members", &BodyMass::members},
      map("", {vec3({"from", &BodyMember::from}, length, "middle of one end, in the body's frame", required),
               vec3({"to", &BodyMember::to}, length, "middle of the other", required),
               number({"diameter", &BodyMember::diameter}, length, "that drag and added mass count with",
                      above(0), required),
               number({"Cd", &BodyMember::drag}, none, "drag coefficient across it", in_range(0, 100),
                      or_else("1")),
               number({"Ca", &BodyMember::added}, none, "added mass coefficient across it", in_range(0, 100),
                      or_else_note("1; 0 beside `hydrodynamics`, which has the added mass")),
               number({"axial_Cd", &BodyMember::axial_drag}, none,
                      "drag coefficient along it, on the area of an end", in_range(0, 100), or_else("0")),
               number({"axial_Ca", &BodyMember::axial_added}, none,
                      "added mass along it over that of half a ball of its diameter", in_range(0, 100),
                      or_else("0"))}),
      "straight round members, which have drag and added mass by Morison's equation along their wet length "
      "([theory](../theory/bodies-in-water.md#members))");
}

// A table of flow coefficients, and the reference areas and lengths of its forces.
Key flow_on_body(const char* name, std::optional<FlowOnBody> BodyMass::*field, std::vector<Key> more,
                 const std::string& about) {
  std::vector<Key> keys = {
      text("file",
           "text file beside the case: columns angle [deg], Cx, Cy, Cn; blanks or commas between, "
           "`#` starts a comment"),
      list("rows", list("", number("", none), items(4, 4)), "the same, written here", items(2)),
      word({"angles", &FlowOnBody::by_origin}, {{"to", false}, {"from", true}},
           "what the angle is, anticlockwise from the body's x axis: where the flow goes to (0 pushes it "
           "ahead), or "
           "where it comes from",
           or_else("to")),
      number({"length", &FlowOnBody::length}, length, "L of the moment", above(0), required)};
  for (Key& k : more) keys.push_back(std::move(k));
  keys.push_back(vec3({"at", &FlowOnBody::at}, length,
                      "point in the body's frame where the forces act and velocities count: midships",
                      or_else(kZero)));
  return map({name, field}, std::move(keys),
             about +
                 "F = rho/2 U² (Cx frontal_area, Cy lateral_area), moment about "
                 "z rho/2 U² Cn lateral_area length, U and angle those of the relative flow "
                 "([theory](../theory/wind-and-current.md))",
             either({"file", "rows"}));
}

Key body_wind() {
  return flow_on_body(
      "wind", &BodyMass::wind,
      {number({"frontal_area", &FlowOnBody::frontal}, area, "seen from ahead", above(0), required),
       number({"lateral_area", &FlowOnBody::lateral}, area, "seen from the side", above(0), required),
       number({"height", &FlowOnBody::height}, length,
              "above the still water, of the wind that the table is for", above(0), or_else("10"))},
      "the wind acts on it by coefficients in the form of OCIMF: ");
}

Key body_current() {
  return flow_on_body(
      "current", &BodyMass::current,
      {number({"draught", &FlowOnBody::draught}, length,
              "both areas are `length` times this, as OCIMF has them", above(0)),
       number({"frontal_area", &FlowOnBody::frontal}, area, "instead of `draught`", above(0)),
       number({"lateral_area", &FlowOnBody::lateral}, area, "instead of `draught`", above(0))},
      "the current acts on it, and damps it where there is none: ");
}

Key body_loads() {
  return list(
      {"loads", &BodyMass::loads},
      map("",
          {vec3({"force", &BodyLoad::force}, force, "force", or_else(kZero)),
           vec3({"moment", &BodyLoad::moment}, moment, "moment", or_else(kZero)),
           map("table",
               {text("file",
                     "text file beside the case: columns t [s], Fx, Fy, Fz [N] and, if it has moments, "
                     "Mx, My, Mz [N m]; blanks or commas between, `#` starts a comment"),
                list("rows", list("", number("", none), items(4, 7)),
                     "the same, written here: `[[t, Fx, Fy, Fz], ...]`", items(2))},
               "force and moment by time, added to the others: straight lines between the rows, "
               "constant beyond them; in statics what they are at t = 0",
               either({"file", "rows"})),
           vec3({"at", &BodyLoad::at}, length, "where the force acts, in the body's frame", or_else(kZero)),
           word({"axes", &BodyLoad::body_fixed}, {{"space", false}, {"body", true}},
                "of force and moment: they stay, or turn with the body", or_else("space"))}),
      "forces on it, in statics too: thrust of a turbine or of thrusters");
}

Key mass_matrix() {
  return map(
      {"mass_matrix", &BodyMass::matrix},
      {six_by_six("rows", &MassMatrix::rows,
                  "six rows of six, kg, kg m, kg m²: surge, sway, heave, roll, pitch, yaw", required),
       vec3({"about", &MassMatrix::about}, length, "point that it is about, in the body's frame",
            or_else(kZero))},
      "instead of `inertia`: all of the body's inertia, which need not be that of a rigid body of `mass`; "
      "`mass` is what weighs ([theory](../theory/body-contact.md#a-floating-body))");
}

Key body_positioning() {
  using P = DynamicPositioning;
  const auto gains = [](const char* name, Vec3 P::*to, std::string about) {
    const auto fill = [to](P& p, const Value& v) {
      for (int i = 0; i < 3; ++i) (p.*to)[i] = v.items[i].number;
    };
    return list({name, by<P>(fill)}, number("", none, at_least(0)), std::move(about), items(3, 3));
  };
  const auto max_force = [](P& p, const Value& v) {
    if (v.items.empty())
      p.max_force.setConstant(v.number);
    else
      p.max_force << v.items[0].number, v.items[1].number;
  };
  return map(
      {"positioning", &BodyMass::positioning},
      {vec3({"place", &P::place}, length, "set point of its origin; z is not held",
            or_else_note("`position`")),
       number({"heading_deg", &P::heading}, angle, "set point of its heading, of its x axis against +x",
              or_else_note("that of `rotation_deg`")),
       gains("proportional", &P::proportional,
             "P in surge, sway and yaw, on the offset from the set point: N/m, N/m, N m/rad"),
       gains("derivative", &P::derivative, "D, on its velocity: N s/m, N s/m, N m s/rad"),
       gains(
           "integral", &P::integral,
           "I, on its integral over time: N/(m s), N/(m s), N m/(rad s); where I is above 0, statics has the "
           "body at its set point with the force that holds it there, up to the limits"),
       number({"filter_period", &P::filter}, time,
              "of the low-pass filter of place and heading, which keeps thrusters from following waves",
              above(0), or_else("60")),
       one_of({"max_force", by<P>(max_force)},
              {number("", force, above(0)), list("", number("", force, above(0)), items(2, 2))},
              "limit of the thrusters' force, in any direction; or two numbers, of surge and of sway alone, "
              "with an ellipse between them",
              or_else_note("no limit")),
       number({"max_moment", &P::max_moment}, moment, "limit of their moment of yaw", above(0),
              or_else_note("no limit"))},
      "thrusters hold its place and heading: a PID controller of its low-passed surge, sway and yaw "
      "([theory](../theory/positioning.md))");
}

Key floating() {
  return map({"floating", &Body::mass},
             {number({"mass", &BodyMass::mass}, mass, "mass", above(0), required),
              vec3({"inertia", &BodyMass::inertia}, inertia,
                   "moments of inertia about the centre of mass, along the body's axes", above(0)),
              vec3({"products_of_inertia", &BodyMass::products}, inertia,
                   "Ixy, Iyz, Ixz: off the diagonal of the inertia", or_else(kZero)),
              mass_matrix(),
              vec3({"centre_of_mass", &BodyMass::centre, set(&BodyMass::centre_given, true)}, length,
                   "in the body's frame", or_else_note("[0, 0, 0]; where `mass_matrix` has it")),
              boolean({"weight", &BodyMass::weight},
                      "gravity acts on it; `false`: buoyancy that is not modelled carries its weight",
                      or_else("false")),
              vec3({"velocity", &BodyMass::velocity}, velocity,
                   "of the centre of mass at t = 0, axes of space", or_else(kZero)),
              vec3({"angular_velocity", &BodyMass::angular_velocity}, angular_velocity,
                   "at t = 0, axes of the body", or_else(kZero)),
              vec3({"stiffness", &BodyMass::stiffness}, point_stiffness,
                   "springs in x, y, z at its centre of mass, to where `motion` (or `position`) has it",
                   at_least(0), or_else(kZero)),
              vec3({"damping", &BodyMass::damping}, point_damping, "dampers in x, y, z beside them",
                   at_least(0), or_else(kZero)),
              vec3({"turning_stiffness", &BodyMass::turning_stiffness}, turning_stiffness,
                   "springs against turning from there, axes of the body", at_least(0), or_else(kZero)),
              vec3({"turning_damping", &BodyMass::turning_damping}, turning_damping, "dampers beside them",
                   at_least(0), or_else(kZero)),
              body_in_water(),
              body_hydrodynamics(),
              body_hull(),
              body_members(),
              body_wind(),
              body_current(),
              body_positioning(),
              body_loads()},
             "it moves by its own mass, held by springs, and touches other bodies; without it its motion is "
             "prescribed",
             either({{{"inertia", "products_of_inertia"}, {"inertia"}}, "mass_matrix"}));
}

}  // namespace

Key bodies() {
  return names(
      {"bodies", &Case::bodies},
      map("<body>",
          {vec3({"position", &Body::position}, length, "of the body's origin at t = 0", or_else(kZero)),
           vec3({"rotation_deg", &Body::rotation}, angle, "rotation vector at t = 0", or_else(kZero)),
           motion(), floating(),
           map({"on", &Body::on},
               {reference({"line", &Ride::line}, "lines", "the line", required),
                arc({"at", &Ride::at},
                    "where on it: a node is put there, between elements that resist bending", required)},
               "it rides on a line and turns with it; `position` and `rotation_deg` are then seen from "
               "there, with x along the line")}),
      "Rigid bodies that carry volumes and line ends, by name.", or_else("{}"));
}

}  // namespace hawser::model::schema_build
