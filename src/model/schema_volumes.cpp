// Keys of volumes: shapes, contact laws, friction.
#include <cmath>

#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

void together(const Target&, const Value& v) {
  if (v.has("kinetic") != v.has("blend_speed"))
    refuse(v, v.has("kinetic") ? "'kinetic' needs 'blend_speed' beside it"
                               : "'blend_speed' needs 'kinetic' beside it");
  if (v.has("shear_stiffness") && v["stick"].is("michalopoulos"))
    refuse(v, "'stick: michalopoulos' goes by 'mobilisation_length', not 'shear_stiffness'");
}

}  // namespace

Key relative_damping() {
  return number({"relative_damping", &Volume::relative_damping}, none,
                "damping of the contact spring over its critical damping", in_range(0, 2), or_else("0"));
}

Key friction(const Field& field) {
  return one_of(
      {"friction", field, Field(Put(together))},
      {number({"", &Friction::axial, &Friction::lateral}, none, in_range(0, 10)),
       map("",
           {number({"axial", &Friction::axial, &Friction::lateral}, none,
                   "Coulomb coefficient along the line", in_range(0, 10), required),
            number({"lateral", &Friction::lateral}, none, "Coulomb coefficient across the line",
                   in_range(0, 10), or_else_note("`axial`")),
            one_of("kinetic",
                   {number({"", &Friction::axial_kinetic, &Friction::lateral_kinetic}, none, in_range(0, 10)),
                    map("", {number({"axial", &Friction::axial_kinetic, &Friction::lateral_kinetic}, none,
                                    "along the line", in_range(0, 10), required),
                             number({"lateral", &Friction::lateral_kinetic}, none, "across the line",
                                    in_range(0, 10), or_else_note("`axial`"))})},
                   "coefficients of fast sliding, those above being of rest; needs `blend_speed`",
                   or_else_note("as at rest")),
            number({"blend_speed", &Friction::blend_speed}, velocity,
                   "speed v0 at which 1/e of the difference between rest and `kinetic` is left; it goes with "
                   "exp(-(v/v0)²)",
                   above(0)),
            one_of("mobilisation_length",
                   {number({"", &Friction::mobilisation_length, &Friction::lateral_mobilisation_length},
                           length, above(0)),
                    map("", {number({"axial", &Friction::mobilisation_length,
                                     &Friction::lateral_mobilisation_length},
                                    length, "along the line", above(0), required),
                             number({"lateral", &Friction::lateral_mobilisation_length}, length,
                                    "across the line", above(0), required)})},
                   "slip at which friction is fully there", or_else_note("1 % of the contact diameter")),
            number({"shear_stiffness", &Friction::shear_stiffness}, none,
                   "stiffness of the stick spring, in the unit of `normal_stiffness`", above(0),
                   or_else_note("from `mobilisation_length`")),
            word({"return", &Friction::back},
                 {{"radial", FrictionReturn::radial}, {"associated", FrictionReturn::associated}},
                 "where a slip beyond the slip ellipse comes back to: in its own direction, or to the "
                 "nearest point in the energy of the stick springs",
                 or_else("radial")),
            word({"stick", &Friction::spring},
                 {{"elliptic", FrictionSpring::elliptic}, {"michalopoulos", FrictionSpring::michalopoulos}},
                 "with mobilisation lengths: a spring each way, whose closed paths take no work, or the law "
                 "of OMAE2006-92155 (Michalopoulos 1986), which is that only for equal lengths",
                 or_else("elliptic"))},
           at_most_one({"mobilisation_length", "shear_stiffness"}))},
      "one coefficient for all directions, or more", or_else("0"));
}

Key force_rows(const Field& field) {
  return rows({"table", field},
              "force against penetration, `[[penetration, force], ...]`: a monotone cubic from no force at "
              "no penetration through the rows, straight beyond the last",
              items(1));
}

namespace {

// Field that selects a shape.
template <class Shape>
Field exactly() {
  return by<Volume>([](Volume& o, const Value& v) { take(v, std::get<Shape>(o.shape.emplace(Shape{}))); });
}

void active_box(Volume& o, const Value& v) {
  Box& box = o.active_box.emplace();
  put(box.lower, v.items[0]);
  put(box.upper, v.items[1]);
}

void bend_radii(TubeShape& s, const Value& v) {
  if (v.kind == Value::Kind::list)
    put(s.bend_radius, v);
  else
    s.bend_radius = {v.number};
}

Key shape() {
  constexpr double kFarthest = 1e8;  // m, also the limit for mesh vertices
  const auto radius = [](const Field& field, std::string about) {
    return number({"radius", field}, length, std::move(about), above(0), at_most(kFarthest), required);
  };
  const auto point = [](Head head, std::string about) {
    return vec3(std::move(head), length, std::move(about), required);
  };
  const auto bend_radius = [] { return number("", length, above(0), at_most(kFarthest)); };
  std::vector<Key> kinds = {
      map({"plane", exactly<PlaneShape>()},
          {point({"point", &PlaneShape::point}, "any point of it"),
           vec3({"normal", unit(&PlaneShape::normal)}, none, "out of the solid; its length does not matter",
                required)},
          "everything below a plane"),
      map({"box", exactly<BoxShape>()},
          {point({"centre", &BoxShape::centre}, "centre"),
           vec3({"size", &BoxShape::size}, length, "whole sides", above(0), required),
           vec3({"rotation_deg", &BoxShape::rotation}, angle, "rotation vector of its sides",
                or_else(kZero))},
          "sides along the axes of the body, unless turned"),
      map({"sphere", exactly<SphereShape>()},
          {point({"centre", &SphereShape::centre}, "centre"), radius(&SphereShape::radius, "radius")},
          "sphere"),
      map({"cylinder", exactly<CylinderShape>()},
          {point({"from", &CylinderShape::from}, "centre of one end"),
           point({"to", &CylinderShape::to}, "centre of the other"),
           radius(&CylinderShape::radius, "radius")},
          "closed by flat ends"),
      map({"capsule", exactly<CapsuleShape>()},
          {point({"from", &CapsuleShape::from}, "one end of the axis"),
           point({"to", &CapsuleShape::to}, "the other"),
           radius(&CapsuleShape::radius, "radius, of the ends too")},
          "cylinder with round ends"),
      map({"torus", exactly<TorusShape>()},
          {point({"centre", &TorusShape::centre}, "centre"),
           vec3({"axis", unit(&TorusShape::axis)}, none, "direction of the axis", required),
           radius(&TorusShape::radius, "of the circle in the middle of the tube"),
           number({"tube_radius", &TorusShape::tube_radius}, length, "of the tube, below `radius`", above(0),
                  required)},
          "ring"),
      map({"tube", exactly<TubeShape>()},
          {list({"path", &TubeShape::path}, vec3("", length),
                "points of the axis, from one open end to the other; the corners are rounded off by bends",
                items(2), required),
           one_of({"bend_radius", by<TubeShape>(bend_radii)},
                  {bend_radius(), list("", bend_radius(), items(1))},
                  "of the axis, for all corners or for each between the first and the last point; above the "
                  "outer radius. Needed where the path has corners"),
           number({"inner_radius", &TubeShape::inner_radius}, length, "of the bore", above(0),
                  at_most(kFarthest), required),
           number({"wall_thickness", &TubeShape::wall_thickness}, length, "of the wall, whose rims are round",
                  above(0), at_most(kFarthest), required)},
          "wall of a pipe that is open at both ends: J-tube, I-tube, bore of a bend restrictor, arch")};
  std::vector<Group> groups;
  for (const Key& k : kinds) groups.push_back({{k.name}, {k.name}});
  return map("shape", std::move(kinds), "instead of a mesh: an exact smooth shape, in the body's frame",
             either(std::move(groups)), fixed_in_restart);
}

Key stiffness() {
  return one_of(
      "normal_stiffness",
      {word("", {"auto"}),
       map("",
           {number({"per_point", &Volume::normal_stiffness, set(&Volume::basis, StiffnessBasis::per_point)},
                   point_stiffness, "of each node in contact", above(0)),
            number({"per_length", &Volume::normal_stiffness, set(&Volume::basis, StiffnessBasis::per_length)},
                   line_stiffness, "per length of line in contact", above(0)),
            number({"per_area", &Volume::normal_stiffness, set(&Volume::basis, StiffnessBasis::per_area)},
                   area_stiffness, "per projected area (length times contact diameter)", above(0)),
            number({"allowed_penetration", &Volume::allowed_penetration}, length,
                   "as `auto`, for this penetration: the largest in statics, twice that in motion except in "
                   "impacts; default 0.4 % of the line's radius",
                   above(0)),
            force_rows(by<Volume>(force_table<Volume>)),
            word({"per", &Volume::basis},
                 {{"point", StiffnessBasis::per_point},
                  {"length", StiffnessBasis::per_length},
                  {"area", StiffnessBasis::per_area}},
                 "what the forces of the table are of: N of a node, N/m of line, N/m² of projected area")},
           either({"per_point",
                   "per_length",
                   "per_area",
                   "allowed_penetration",
                   {{"table", "per"}, {"table", "per"}}}))},
      "penalty against penetration; `auto` is raised in the run as far as tensions and speeds need it",
      or_else("auto"), fixed_in_restart);
}

Key active() {
  return one_of("active",
                {text({"", &Volume::active_part}),
                 map("", {list({"box", by<Volume>(active_box)}, vec3("", length),
                               "`[[x, y, z], [x, y, z]]`: lower and upper corner, in the body's frame",
                               items(2, 2), required)})},
                "the part of the mesh that takes part in contact: name of a part (OBJ group, STL solid), or "
                "the triangles with all corners in a box",
                or_else_note("all"), fixed_in_restart);
}

}  // namespace

Key volumes() {
  return names(
      {"volumes", &Case::volumes},
      map("<volume>",
          {text({"mesh", &Volume::mesh},
                "triangle mesh (STL, OBJ or PLY), relative to the case file; this or `shape` is needed"),
           shape(),
           number({"scale", &Volume::scale}, none, "mesh units to m: 0.001 for a mesh in mm", above(0),
                  or_else("1"), fixed_in_restart),
           word({"closed", &Volume::closed}, {{"required", true}, {"repair", false}},
                "what to do with a mesh that is open or inconsistent: refuse it, or repair what can be and "
                "take for inside where the winding number is above 1/2",
                or_else("repair")),
           word({"sign", &Volume::sign},
                {{"automatic", SignTest::automatic},
                 {"pseudonormal", SignTest::pseudonormal},
                 {"winding", SignTest::winding},
                 {"tetrahedron", SignTest::tetrahedra},
                 {"ray", SignTest::ray},
                 {"solid_angle", SignTest::solid_angle}},
                "how inside is distinguished from outside: `automatic` by pseudonormals, and by winding "
                "numbers where "
                "the mesh is not in order; the last three are those of OMAE2006-92155, look at every "
                "triangle each time and, as `winding`, leave the facets flat",
                or_else("automatic"), fixed_in_restart),
           boolean(
               {"smooth", &Volume::smooth},
               "curve the facets of a mesh where they stand for a curved surface; with `false` they are flat",
               or_else("true"), fixed_in_restart),
           number({"crease_angle_deg", &Volume::crease_angle}, angle,
                  "edges whose facets meet at more than this stay sharp", above(0), at_most(M_PI),
                  or_else("40"), fixed_in_restart),
           reference({"body", &Volume::body}, "bodies",
                     "body it is fixed to; mesh and shape are in the body's frame",
                     or_else_note("none: fixed in space"), fixed_in_restart),
           active(), stiffness(),
           number({"smoothing", &Volume::smoothing}, length,
                  "half width of the smooth start of the contact force; 0: linear from the touch on",
                  at_least(0),
                  or_else_note(
                      "0.1 % of the contact diameter; 0.001 % on an automatic stiffness without damping"),
                  fixed_in_restart),
           relative_damping(), friction(&Volume::friction)},
          either({{{"mesh", "scale", "closed", "sign", "smooth", "crease_angle_deg", "active"}, {"mesh"}},
                  "shape"})),
      "Volumes that lines must not enter, by name.", or_else("{}"));
}

}  // namespace hawser::model::schema_build
