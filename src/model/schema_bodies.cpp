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
  return set_by<Body>([](Body& b, const Value& v) { take(v, b.motion.emplace<M>()); });
}

Key harmonic(const Field& field, std::string about) {
  return map({"harmonic", field},
             {vec3({"amplitude", &HarmonicMotion::amplitude}, length,
                   "amplitudes of x, y, z: offset = amplitude sin(2 pi t / period + phase)", or_else(kZero)),
              vec3({"rotation_amplitude_deg", &HarmonicMotion::rotation_amplitude}, angle,
                   "amplitudes of the rotation vector, axes fixed in space", or_else(kZero)),
              number({"period", &HarmonicMotion::period}, time, "period", above(0), required),
              vec3({"phase_deg", &HarmonicMotion::phase}, angle, "phases of x, y, z", or_else(kZero)),
              vec3({"rotation_phase_deg", &HarmonicMotion::rotation_phase}, angle,
                   "phases of the rotation vector", or_else(kZero))},
             std::move(about));
}

Key table(const Field& field, std::string about) {
  return map({"table", field},
             {text("file",
                   "text file beside the case: columns t [s], x, y, z [m] and, for rotations, the rotation "
                   "vector [deg]; blanks or commas between, `#` starts a comment"),
              list("rows", list("", number("", none), items(4, 7)),
                   "the same as a list in the case: `[[t, x, y, z], ...]`", items(2)),
              word({"interpolation", &TableMotion::between},
                   {{"spline", BetweenRows::spline},
                    {"monotone", BetweenRows::monotone},
                    {"linear", BetweenRows::linear}},
                   "interpolation between rows: `spline`, a cubic spline; `monotone`, a cubic that stays "
                   "between the values of its two rows; `linear`, with velocities that jump at the rows",
                   or_else("spline"))},
             std::move(about), either({"file", "rows"}));
}

// Drift in addition to `motion`.
Key drift() {
  return map({"drift", &Body::drift},
             {vec3({"offset", &Drift::offset}, length, "constant offset from `position`", or_else(kZero)),
              vec3({"rotation_deg", &Drift::rotation}, angle, "constant rotation vector", or_else(kZero)),
              harmonic(&Drift::harmonic, "slow sinusoidal motion, added to the offset"),
              table(&Drift::table, "slow motion against time, added to the offset"),
              number({"ramp", &Drift::ramp}, time,
                     "the drift starts smoothly over this time; 0: the whole drift acts in statics",
                     at_least(0), or_else("0"))},
             "slow drift, added to the other motion of the body; with `rao`, waves are evaluated at the "
             "drifted position of the vessel");
}

Key motion() {
  return map(
      "motion",
      {vec3({"velocity", set_by<Body>([](Body& b, const Value& v) { put(steady(b).velocity, v); })}, velocity,
            "constant velocity"),
       map({"rotation", set_by<Body>([](Body& b, const Value& v) { take(v, steady(b)); })},
           {vec3({"axis", unit(&ConstantMotion::axis)}, none,
                 "direction of the axis through the body's position, fixed in space, of any length",
                 required),
            number({"rate", &ConstantMotion::rate}, angular_velocity,
                   "angular velocity, right-handed about the axis", required)},
           "constant rotation"),
       harmonic(moves<HarmonicMotion>(), "sinusoidal motion about the position at rest"),
       table(moves<TableMotion>(), "offsets from `position` against time"),
       map("rao",
           {text("file",
                 "text file beside the case: columns period [s], direction [deg] in which the wave travels "
                 "relative to the bow (0: following sea), then surge, sway, heave [m/m], roll, pitch, yaw "
                 "[deg/m], each amplitude followed by its phase [deg]; the same periods for every direction"),
            list("rows", list("", number("", none), items(14, 14)), "the same as a list in the case",
                 items(1)),
            word("phase", {"lag", "lead"},
                 "sign of the phases: `lag`, the motion comes that much after the wave crest at the body's "
                 "origin; `lead`, before it",
                 or_else("lag")),
            word("symmetry", {"none", "port_starboard"},
                 "for a table of one side (0 to 180 deg): `port_starboard` takes the response to waves from "
                 "the other side by mirror symmetry, with sway, roll and yaw reversed",
                 or_else("none"))},
           "motion in waves by response amplitude operators (RAO), about `position`",
           either({"file", "rows"})),
       drift(),
       number({"ramp", &Body::ramp}, time,
              "the motion starts smoothly over this time (quintic); for `rao`, the motion by waves",
              at_least(0), or_else_note("0; for `rao` the `ramp` of the waves"))},
      "prescribed motion; without it the body does not move",
      at_most_one_of({{{"velocity", "rotation"}, {}}, "harmonic", "table", "rao"}));
}

Key body_in_water() {
  return map(
      {"in_water", &BodyMass::in_water},
      {number({"volume", &BodyInWater::volume}, volume, "displaced volume when fully submerged", above(0),
              required),
       number({"height", &BodyInWater::height}, length,
              "height over which the body submerges, half of it above `centre_of_buoyancy`", above(0),
              required),
       vec3({"centre_of_buoyancy", &BodyInWater::centre, &BodyInWater::drag_centre}, length,
            "in the body's frame; the fluid inertia force acts there as well", or_else(kZero)),
       vec3({"drag_area", &BodyInWater::drag_area}, area, "projected areas along the body's axes",
            at_least(0), or_else(kZero)),
       vec3({"Cd", set_by<BodyInWater>([](BodyInWater& w, const Value& v) {
               Vec3 Cd;
               put(Cd, v);
               w.drag_area = w.drag_area.cwiseProduct(Cd);
             })},
            none, "drag coefficients along the body's axes", in_range(0, 100), or_else("[1, 1, 1]")),
       vec3({"centre_of_drag", &BodyInWater::drag_centre}, length, "in the body's frame",
            or_else_note("same as `centre_of_buoyancy`")),
       vec3("Ca", none,
            "added mass coefficients along the body's axes, relative to the mass of water in `volume` ...",
            in_range(0, 100)),
       vec3({"added_mass", &BodyInWater::added_mass}, mass, "... or the added mass along these axes",
            at_least(0))},
      "forces of the water by Morison's equation along the body's axes "
      "([theory](../theory/bodies-in-water.md)); use it with `weight: true`",
      at_most_one_of({"Ca", "added_mass"}));
}

// A 6x6 matrix, row by row.
template <class Of>
Key six_by_six(const char* name, Mat6 Of::*matrix, std::string about, auto... parts) {
  const auto fill = [matrix](Of& target, const Value& v) {
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) (target.*matrix)(i, j) = v.items[i].items[j].number;
  };
  return list({name, set_by<Of>(fill)}, list("", number("", none), items(6, 6)), std::move(about),
              items(6, 6), parts...);
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
            "path, relative to the case, of WAMIT's output files without suffix: `.1` and `.hst`, and `.3` "
            "if there are waves; each may be compressed with gzip"),
       text({"capytaine", &H::files, set(&H::format, H::Format::capytaine)}, "NetCDF file of Capytaine"),
       text({"bemio", &H::files, set(&H::format, H::Format::bemio)}, "HDF5 file of BEMIO"),
       number({"length_scale", &H::length}, length, "ULEN of the WAMIT run", above(0), or_else("1"),
              fixed_in_restart),
       integer({"body", &H::body}, "number of the body in the files", in_range(1, 20), or_else("1"),
               fixed_in_restart),
       vec3(
           {"origin_in_file", &H::in_file}, length,
           "coordinates of the body's origin (XBODY) in the files; moments in the files are about this point",
           or_else_note(
               "[0, 0, 0]; for `capytaine` the centre of rotation, for `bemio` the centre of gravity"),
           fixed_in_restart),
       number({"displaced_volume", &H::volume}, volume,
              "displaced volume of the body at its position in the files", above(0),
              or_else_note("mass over the density of the water"), fixed_in_restart),
       boolean({"gravity_in_stiffness", &H::gravity_in_stiffness},
               "whether the stiffness in the files includes the contribution of the body's weight (WAMIT "
               "includes it if its input has mass and centre of gravity)",
               or_else_note("false; true for `capytaine`"), fixed_in_restart),
       vec3({"place", &H::place}, length,
            "position of the body's origin in the case that corresponds to its position in the files; "
            "displacements count from here",
            or_else_note("x and y of `position`, z of `origin_in_file`"), fixed_in_restart),
       number({"heading_deg", &H::heading}, angle, "heading of the body at `place`",
              or_else_note("heading of `rotation_deg`"), fixed_in_restart),
       number(
           {"follow_period", &H::follow_period}, time,
           "period of the low-pass filter of the body's position and heading: waves act at the filtered "
           "position, and forces have the axes of the filtered heading, moments those of the actual one; 0: "
           "position and heading are always `place` and `heading_deg`",
           at_least(0), or_else("100")),
       word({"symmetry", &H::mirrored}, {{"none", false}, {"port_starboard", true}},
            "for files with directions of one side (0 to 180 deg): `port_starboard` takes the forces of "
            "waves from the other side by mirror symmetry, with sway, roll and yaw reversed",
            or_else("none")),
       boolean({"excitation", &H::excitation},
               "whether the waves of the case exert first-order forces on the body", or_else("true")),
       word({"second_order", &H::second_order},
            {{"none", SecondOrder::none},
             {"mean", SecondOrder::mean},
             {"newman", SecondOrder::newman},
             {"full", SecondOrder::full}},
            "second-order wave forces by quadratic transfer functions (QTF): `mean`, the mean drift force; "
            "`newman`, slow drift by Newman's approximation from mean drift forces (`.8`, `.7`, `.9` or "
            "`.12d`); `full`, the difference-frequency QTF (`.12d`) of the direction nearest to that of the "
            "waves",
            or_else("none")),
       six_by_six("stiffness", &H::stiffness,
                  "additional linear stiffness about the body's origin, for displacements from `place`: six "
                  "rows of six, N/m, N, N m/rad"),
       six_by_six("damping", &H::damping,
                  "additional linear damping about the body's origin: six rows of six, N s/m, N s, N m s"),
       map("wave_drift_damping",
           {text("file",
                 "text file beside the case: columns period [s] and either Bxx, Byy, Bzz or the 9 elements "
                 "of a matrix by rows, for surge, sway and yaw; `#` starts a comment"),
            list("rows", list("", number("", none), items(4, 10)),
                 "the same as a list in the case: `[[period, Bxx, Byy, Bzz], ...]`", items(1))},
           "wave drift damping per square of the wave amplitude: N s/m³, between surge or sway and yaw N "
           "s/m², of yaw N m s/m²; linear between the frequencies",
           either({"file", "rows"})),
       list({"quadratic_damping", set_by<H>(by_freedom)},
            one_of("", {number("", none, at_least(0)), list("", number("", none), items(6, 6))}),
            "six coefficients of quadratic damping: with a velocity v of the body's origin the force is the "
            "coefficient times |v| v, in N s²/m² and N m s²; or a matrix, six rows of six, which multiplies "
            "all |v| v",
            items(6, 6))},
      "hydrodynamic forces by the coefficients of a diffraction program ([theory](../theory/platforms.md)); "
      "the body's `weight` acts",
      either({"wamit", "capytaine", "bemio"}));
}

Key body_hull() {
  const Field names = set_by<BodyHull>([](BodyHull& h, const Value& v) {
    for (const Value& n : v.items) h.volumes.push_back(n.text);
  });
  return map(
      {"hull", &BodyMass::hull},
      {list({"volumes", names}, reference("", "volumes"),
            "volumes of this body that displace water: closed meshes or shapes that do not overlap", items(1),
            required),
       boolean(
           {"wave_pressure", &BodyHull::wave_pressure},
           "whether the pressure of the undisturbed waves (Froude-Krylov) acts on the wetted surface as well",
           or_else_note("true; false beside `hydrodynamics`, whose wave forces include it"))},
      "pressure of the water on the surface of the body, up to the instantaneous water level "
      "([theory](../theory/hulls.md)); it replaces the hydrostatic stiffness of `hydrodynamics`; the body's "
      "`weight` acts");
}

Key body_members() {
  return list(
      {"members", &BodyMass::members},
      map("",
          {vec3({"from", &BodyMember::from}, length, "centre of one end, in the body's frame", required),
           vec3({"to", &BodyMember::to}, length, "centre of the other end", required),
           number({"diameter", &BodyMember::diameter}, length, "diameter for drag and added mass", above(0),
                  required),
           number({"Cd", &BodyMember::drag}, none, "transverse drag coefficient", in_range(0, 100),
                  or_else("1")),
           number({"Ca", &BodyMember::added}, none, "transverse added mass coefficient", in_range(0, 100),
                  or_else_note("1; 0 beside `hydrodynamics`, which includes the added mass")),
           number({"axial_Cd", &BodyMember::axial_drag}, none,
                  "axial drag coefficient, on the area of one end; a partly wet member has its wet fraction",
                  in_range(0, 100), or_else("0")),
           number({"axial_Ca", &BodyMember::axial_added}, none,
                  "axial added mass, relative to that of a hemisphere of its diameter; likewise",
                  in_range(0, 100), or_else("0"))}),
      "straight members of circular section, with drag and added mass by Morison's equation along their "
      "wetted length ([theory](../theory/bodies-in-water.md#members))");
}

// A table of flow coefficients, and the reference areas and lengths of its forces.
Key flow_on_body(const char* name, Shared<FlowOnBody> BodyMass::*field, std::vector<Key> more,
                 const std::string& about) {
  std::vector<Key> keys = {
      text("file",
           "text file beside the case: columns angle [deg], Cx, Cy, Cn; blanks or commas between, "
           "`#` starts a comment"),
      list("rows", list("", number("", none), items(4, 4)), "the same as a list in the case", items(2)),
      word({"angles", &FlowOnBody::by_origin}, {{"to", false}, {"from", true}},
           "direction that the angle means, anticlockwise from the body's x axis: `to`, where the flow goes "
           "(0 pushes the body ahead); `from`, where it comes from",
           or_else("to")),
      number({"length", &FlowOnBody::length}, length, "reference length of the moment", above(0), required)};
  for (Key& k : more) keys.push_back(std::move(k));
  keys.push_back(
      vec3({"at", &FlowOnBody::at}, length,
           "point in the body's frame where the forces act and the relative velocity is taken: midships",
           or_else(kZero)));
  return map(
      {name, field}, std::move(keys),
      about +
          "F = rho/2 U² (Cx frontal_area, Cy lateral_area), moment about z rho/2 U² Cn lateral_area length; "
          "U and the angle are those of the relative flow ([theory](../theory/wind-and-current.md))",
      either({"file", "rows"}));
}

Key body_wind() {
  return flow_on_body("wind", &BodyMass::wind,
                      {number({"frontal_area", &FlowOnBody::frontal}, area, "projected area, seen from ahead",
                              above(0), required),
                       number({"lateral_area", &FlowOnBody::lateral}, area,
                              "projected area, seen from the side", above(0), required),
                       number({"height", &FlowOnBody::height}, length,
                              "height above the still water of the wind speed that the coefficients refer to",
                              above(0), or_else("10"))},
                      "wind force by coefficients as of OCIMF: ");
}

Key body_current() {
  return flow_on_body(
      "current", &BodyMass::current,
      {number({"draught", &FlowOnBody::draught}, length,
              "makes both areas `length` times this, as OCIMF does", above(0)),
       number({"frontal_area", &FlowOnBody::frontal}, area, "frontal area, in place of `draught`", above(0)),
       number({"lateral_area", &FlowOnBody::lateral}, area, "lateral area, in place of `draught`", above(0))},
      "current force by coefficients, which is a damping where there is no current: ");
}

Key body_loads() {
  return list(
      {"loads", &BodyMass::loads},
      map("", {vec3({"force", &BodyLoad::force}, force, "force", or_else(kZero)),
               vec3({"moment", &BodyLoad::moment}, moment, "moment", or_else(kZero)),
               map("table",
                   {text("file",
                         "text file beside the case: columns t [s], Fx, Fy, Fz [N] and, for moments, Mx, My, "
                         "Mz [N m]; blanks or commas between, `#` starts a comment"),
                    list("rows", list("", number("", none), items(4, 7)),
                         "the same as a list in the case: `[[t, Fx, Fy, Fz], ...]`", items(2))},
                   "force and moment against time, added to the constant ones: linear between the rows, "
                   "constant outside them; statics takes the values at t = 0",
                   either({"file", "rows"})),
               vec3({"at", &BodyLoad::at}, length, "point in the body's frame where the force acts",
                    or_else(kZero)),
               word({"axes", &BodyLoad::body_fixed}, {{"space", false}, {"body", true}},
                    "axes of force and moment: fixed in space, or turning with the body", or_else("space"))}),
      "forces on the body, also in statics: for example thrust of a turbine or of thrusters");
}

Key mass_matrix() {
  return map({"mass_matrix", &BodyMass::matrix},
             {six_by_six("rows", &MassMatrix::rows,
                         "six rows of six, kg, kg m, kg m²: surge, sway, heave, roll, pitch, yaw", required),
              vec3({"about", &MassMatrix::about}, length,
                   "reference point of the matrix, in the body's frame", or_else(kZero))},
             "complete inertia of the body, in place of `inertia`; it need not be that of a rigid body of "
             "`mass`, and `mass` sets the weight only ([theory](../theory/body-contact.md#a-floating-body))",
             fixed_in_restart);
}

Key body_positioning() {
  using P = DynamicPositioning;
  const auto gains = [](const char* name, Vec3 P::*to, std::string about) {
    const auto fill = [to](P& p, const Value& v) {
      for (int i = 0; i < 3; ++i) (p.*to)[i] = v.items[i].number;
    };
    return list({name, set_by<P>(fill)}, number("", none, at_least(0)), std::move(about), items(3, 3));
  };
  const auto max_force = [](P& p, const Value& v) {
    if (v.items.empty())
      p.max_force.setConstant(v.number);
    else
      p.max_force << v.items[0].number, v.items[1].number;
  };
  return map(
      {"positioning", &BodyMass::positioning},
      {vec3({"place", &P::place}, length, "set point of the body's origin; z is not controlled",
            or_else_note("same as `position`")),
       number({"heading_deg", &P::heading}, angle, "set point of the heading, of the body's x axis from +x",
              or_else_note("heading of `rotation_deg`")),
       gains("proportional", &P::proportional,
             "gains P in surge, sway and yaw, on the offset from the set point: N/m, N/m, N m/rad"),
       gains("derivative", &P::derivative, "gains D, on the velocity: N s/m, N s/m, N m s/rad"),
       gains("integral", &P::integral,
             "gains I, on the integral of the offset over time: N/(m s), N/(m s), N m/(rad s); where I is "
             "above 0, statics keeps the body at its set point by a thruster force within the limits"),
       number({"filter_period", &P::filter}, time,
              "period of the low-pass filter of position and heading; it keeps thrusters from responding to "
              "waves",
              above(0), or_else("60")),
       one_of({"max_force", set_by<P>(max_force)},
              {number("", force, above(0)), list("", number("", force, above(0)), items(2, 2))},
              "limit of the thruster force: one number for all directions, or two for surge and for sway, "
              "with an elliptic limit between them",
              or_else_note("no limit")),
       number({"max_moment", &P::max_moment}, moment, "limit of the yaw moment", above(0),
              or_else_note("no limit"))},
      "dynamic positioning: a PID controller of low-pass filtered surge, sway and yaw "
      "([theory](../theory/positioning.md))");
}

Key floating() {
  return map(
      {"floating", &Body::mass},
      {number({"mass", &BodyMass::mass}, mass, "mass", above(0), required, fixed_in_restart),
       vec3({"inertia", &BodyMass::inertia}, inertia,
            "moments of inertia about the centre of mass, axes of the body", above(0), fixed_in_restart),
       vec3({"products_of_inertia", &BodyMass::products}, inertia,
            "Ixy, Iyz, Ixz: off-diagonal elements of the inertia matrix", or_else(kZero), fixed_in_restart),
       mass_matrix(),
       vec3({"centre_of_mass", &BodyMass::centre, set(&BodyMass::centre_given, true)}, length,
            "in the body's frame", or_else_note("[0, 0, 0]; with `mass_matrix` the centre that it implies"),
            fixed_in_restart),
       boolean({"weight", &BodyMass::weight},
               "whether the weight of the body acts; `false`: it is carried by buoyancy that is not modelled",
               or_else_note("true with `hydrodynamics` or `hull`, false without")),
       vec3({"velocity", &BodyMass::velocity}, velocity,
            "of the centre of mass at t = 0, axes fixed in space", or_else(kZero)),
       vec3({"angular_velocity", &BodyMass::angular_velocity}, angular_velocity, "at t = 0, axes of the body",
            or_else(kZero)),
       vec3(
           {"stiffness", &BodyMass::stiffness}, point_stiffness,
           "linear springs along x, y, z from its centre of mass to the position by `motion` (or `position`)",
           at_least(0), or_else(kZero)),
       vec3({"damping", &BodyMass::damping}, point_damping, "linear dampers parallel to these springs",
            at_least(0), or_else(kZero)),
       vec3({"turning_stiffness", &BodyMass::turning_stiffness}, turning_stiffness,
            "rotational springs to the orientation by `motion` (or `rotation_deg`), axes of the body",
            at_least(0), or_else(kZero)),
       vec3({"turning_damping", &BodyMass::turning_damping}, turning_damping,
            "rotational dampers parallel to these springs", at_least(0), or_else(kZero)),
       six_by_six("stiffness_matrix", &BodyMass::stiffness_matrix,
                  "linear springs with a full, symmetric matrix between the body's origin and its pose by "
                  "`motion` (or `position` and `rotation_deg`), in the body's axes in this pose, in addition "
                  "to the others: six rows of six, N/m, N, N m/rad"),
       six_by_six("damping_matrix", &BodyMass::damping_matrix,
                  "linear dampers parallel to these springs, with a full matrix: six rows of six, N s/m, N "
                  "s, N m s"),
       body_in_water(),
       body_hydrodynamics(),
       body_hull(),
       body_members(),
       body_wind(),
       body_current(),
       body_positioning(),
       body_loads()},
      "the body moves by its inertia and the forces on it, and touches other bodies; without this key its "
      "motion is prescribed",
      either({{{"inertia", "products_of_inertia"}, {"inertia"}}, "mass_matrix"}));
}

}  // namespace

Key bodies() {
  return map_by_name(
      "bodies",
      map("<body>",
          {vec3({"position", &Body::position}, length, "position of the body's origin at t = 0",
                or_else(kZero)),
           vec3({"rotation_deg", &Body::rotation}, angle, "rotation vector at t = 0", or_else(kZero)),
           motion(), floating(),
           map({"on", &Body::ride},
               {reference({"line", &Ride::line}, "lines", "the line", required),
                arc({"at", &Ride::at},
                    "arc length at which the body is fixed; the program puts a node there, between elements "
                    "that resist bending",
                    required)},
               "fixes the body to a line, with which it moves and turns; `position` and `rotation_deg` then "
               "refer to this point of the line, with x along the line")}),
      "Rigid bodies that carry volumes and ends of lines, by name.", or_else("{}"));
}

}  // namespace hawser::model::schema_build
