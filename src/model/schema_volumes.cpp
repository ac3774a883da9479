// Keys of volumes: shapes, contact laws, friction.
#include <cmath>

#include "schema_build.hpp"

namespace hawser::model::schema_build {
namespace {

void together(const Target&, const Value& v) {
  if (v.has("kinetic") != v.has("blend_speed"))
    refuse(v, v.has("kinetic") ? "'kinetic' requires 'blend_speed'" : "'blend_speed' requires 'kinetic'");
  if (v.has("shear_stiffness") && v["stick"].is("michalopoulos"))
    refuse(v, "'stick: michalopoulos' requires 'mobilisation_length' in place of 'shear_stiffness'");
}

}  // namespace

Key relative_damping() {
  return number({"relative_damping", &Volume::relative_damping}, none,
                "damping of the contact spring relative to its critical damping", in_range(0, 2),
                or_else("0"));
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
            one_of(
                "kinetic",
                {number({"", &Friction::axial_kinetic, &Friction::lateral_kinetic}, none, in_range(0, 10)),
                 map("", {number({"axial", &Friction::axial_kinetic, &Friction::lateral_kinetic}, none,
                                 "along the line", in_range(0, 10), required),
                          number({"lateral", &Friction::lateral_kinetic}, none, "across the line",
                                 in_range(0, 10), or_else_note("`axial`"))})},
                "coefficients at high sliding speed; those above then hold at rest; requires `blend_speed`",
                or_else_note("the coefficients at rest")),
            number(
                {"blend_speed", &Friction::blend_speed}, velocity,
                "speed v0 of the transition from rest to `kinetic`: the difference decays by exp(-(v/v0)²)",
                above(0)),
            one_of("mobilisation_length",
                   {number({"", &Friction::mobilisation_length, &Friction::lateral_mobilisation_length},
                           length, above(0)),
                    map("", {number({"axial", &Friction::mobilisation_length,
                                     &Friction::lateral_mobilisation_length},
                                    length, "along the line", above(0), required),
                             number({"lateral", &Friction::lateral_mobilisation_length}, length,
                                    "across the line", above(0), required)})},
                   "slip at which friction is fully mobilised under the largest normal force since the point "
                   "touched",
                   or_else_note("1 % of the contact diameter")),
            number({"shear_stiffness", &Friction::shear_stiffness}, none,
                   "stiffness of the friction spring before slip, in the unit of `normal_stiffness`",
                   above(0), or_else_note("by `mobilisation_length`")),
            word({"return", &Friction::return_rule},
                 {{"radial", FrictionReturn::radial}, {"associated", FrictionReturn::associated}},
                 "return to the slip ellipse: `radial`, along the slip; `associated`, to the nearest point "
                 "in the energy norm of the friction springs",
                 or_else("radial")),
            word({"stick", &Friction::spring},
                 {{"elliptic", FrictionSpring::elliptic}, {"michalopoulos", FrictionSpring::michalopoulos}},
                 "law before slip for given mobilisation lengths: `elliptic`, one spring in each direction, "
                 "with the stiffness of the largest normal force since the point touched, so that no path "
                 "generates "
                 "energy; `michalopoulos`, the law of OMAE2006-92155 (Michalopoulos 1986), whose stiffness "
                 "follows the normal force and whose closed paths may generate energy",
                 or_else("elliptic"))},
           at_most_one_of({"mobilisation_length", "shear_stiffness"}))},
      "Coulomb coefficient for all directions, or a set of keys", or_else("0"));
}

Key force_rows(const Field& field) {
  return rows({"table", field},
              "force against penetration, `[[penetration, force], ...]`: a monotone cubic from the origin "
              "through the rows, linear beyond the last",
              items(1));
}

namespace {

// Field that selects a shape.
template <class Shape>
Field exactly() {
  return set_by<Volume>(
      [](Volume& o, const Value& v) { take(v, std::get<Shape>(o.shape.emplace(Shape{}))); });
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
          {point({"point", &PlaneShape::point}, "any point of the plane"),
           vec3({"normal", unit(&PlaneShape::normal)}, none, "outward normal of the solid, of any length",
                required)},
          "half space below a plane"),
      map({"box", exactly<BoxShape>()},
          {point({"centre", &BoxShape::centre}, "centre"),
           vec3({"size", &BoxShape::size}, length, "lengths of the sides", above(0), required),
           vec3({"rotation_deg", &BoxShape::rotation}, angle, "rotation vector of the box", or_else(kZero))},
          "box with sides along the axes of the body, unless rotated"),
      map({"sphere", exactly<SphereShape>()},
          {point({"centre", &SphereShape::centre}, "centre"), radius(&SphereShape::radius, "radius")},
          "sphere"),
      map({"cylinder", exactly<CylinderShape>()},
          {point({"from", &CylinderShape::from}, "centre of one end"),
           point({"to", &CylinderShape::to}, "centre of the other end"),
           radius(&CylinderShape::radius, "radius")},
          "cylinder with flat ends"),
      map({"capsule", exactly<CapsuleShape>()},
          {point({"from", &CapsuleShape::from}, "one end of the axis"),
           point({"to", &CapsuleShape::to}, "other end of the axis"),
           radius(&CapsuleShape::radius, "radius of the cylinder and of its ends")},
          "cylinder with hemispherical ends"),
      map({"torus", exactly<TorusShape>()},
          {point({"centre", &TorusShape::centre}, "centre"),
           vec3({"axis", unit(&TorusShape::axis)}, none, "direction of the axis", required),
           radius(&TorusShape::radius, "radius of the centre line of the tube"),
           number({"tube_radius", &TorusShape::tube_radius}, length, "radius of the tube, below `radius`",
                  above(0), required)},
          "ring"),
      map({"tube", exactly<TubeShape>()},
          {list({"path", &TubeShape::path}, vec3("", length),
                "points of the axis, from one open end to the other; the corners are rounded off by bends",
                items(2), required),
           one_of(
               {"bend_radius", set_by<TubeShape>(bend_radii)},
               {bend_radius(), list("", bend_radius(), items(1))},
               "radius of the axis in its bends, for all corners or for each between the first and the last "
               "point; above the outer radius. Needed where the path has corners"),
           number({"inner_radius", &TubeShape::inner_radius}, length, "radius of the bore", above(0),
                  at_most(kFarthest), required),
           number({"wall_thickness", &TubeShape::wall_thickness}, length,
                  "thickness of the wall, whose rims are round", above(0), at_most(kFarthest), required)},
          "wall of a pipe that is open at both ends: J-tube, I-tube, bore of a bend restrictor, arch")};
  std::vector<Group> groups;
  for (const Key& k : kinds) groups.push_back({{k.name}, {k.name}});
  return map("shape", std::move(kinds), "exact smooth shape in place of a mesh, in the body's frame",
             either(std::move(groups)), fixed_in_restart);
}

Key stiffness() {
  return one_of(
      "normal_stiffness",
      {word("", {"auto"}),
       map("",
           {number({"per_point", &Volume::normal_stiffness, set(&Volume::basis, StiffnessBasis::per_point)},
                   point_stiffness, "per node in contact", above(0)),
            number({"per_length", &Volume::normal_stiffness, set(&Volume::basis, StiffnessBasis::per_length)},
                   line_stiffness, "per length of line in contact", above(0)),
            number(
                {"per_area", &Volume::normal_stiffness, set(&Volume::basis, StiffnessBasis::per_area)},
                area_stiffness,
                "per area: of a line its length times its contact diameter, of a body all its faces inside "
                "the other body, also those along the motion",
                above(0)),
            number(
                {"allowed_penetration", &Volume::allowed_penetration}, length,
                "makes the stiffness automatic, for this largest penetration in statics, and twice this "
                "in motion except in impacts and in short steps; without it 0.5 % of the line's radius for "
                "the initial stiffness, which is raised where the penetration exceeds 0.4 %",
                above(0)),
            force_rows(set_by<Volume>(force_table<Volume>)),
            word({"per", &Volume::basis},
                 {{"point", StiffnessBasis::per_point},
                  {"length", StiffnessBasis::per_length},
                  {"area", StiffnessBasis::per_area}},
                 "unit of the forces in the table: N per node, N/m of line, N/m² of the area of `per_area`")},
           either({"per_point",
                   "per_length",
                   "per_area",
                   "allowed_penetration",
                   {{"table", "per"}, {"table", "per"}}}))},
      "penalty stiffness; with `auto` the program raises it during the run as tensions and speeds require",
      or_else("auto"), fixed_in_restart);
}

Key active() {
  return one_of("active",
                {text({"", &Volume::active_part}),
                 map("", {list({"box", set_by<Volume>(active_box)}, vec3("", length),
                               "`[[x, y, z], [x, y, z]]`: lower and upper corner, in the body's frame",
                               items(2, 2), required)})},
                "part of the mesh that takes part in contact: its name (OBJ group, STL solid), or a box that "
                "contains all corners of its triangles",
                or_else_note("all"), fixed_in_restart);
}

}  // namespace

Key volumes() {
  return map_by_name(
      {"volumes", &Case::volumes},
      map("<volume>",
          {text({"mesh", &Volume::mesh},
                "triangle mesh (STL, OBJ or PLY), relative to the case file; either this or `shape` is "
                "needed"),
           shape(),
           number({"scale", &Volume::scale}, none, "metres per unit of the mesh: 0.001 for a mesh in mm",
                  above(0), or_else("1"), fixed_in_restart),
           word({"closed", &Volume::closed}, {{"required", true}, {"repair", false}},
                "treatment of an open or inconsistent mesh: `required`, an input error; `repair`, the "
                "program repairs what it can, and points with a winding number above 1/2 are inside",
                or_else("repair")),
           word({"sign", &Volume::sign},
                {{"automatic", SignTest::automatic},
                 {"pseudonormal", SignTest::pseudonormal},
                 {"winding", SignTest::winding},
                 {"tetrahedron", SignTest::tetrahedra},
                 {"ray", SignTest::ray},
                 {"solid_angle", SignTest::solid_angle}},
                "method that distinguishes inside from outside: `automatic` takes pseudonormals, and winding "
                "numbers for a mesh with defects; `tetrahedron`, `ray` and `solid_angle` are the methods of "
                "OMAE2006-92155, which test every triangle each time; with these three and `winding` the "
                "facets stay flat",
                or_else("automatic"), fixed_in_restart),
           boolean(
               {"smooth", &Volume::smooth},
               "curve the facets of a mesh where they represent a curved surface; `false`: they stay flat",
               or_else("true"), fixed_in_restart),
           number({"crease_angle_deg", &Volume::crease_angle}, angle,
                  "edges between facets that differ by more than this angle stay sharp", above(0),
                  at_most(M_PI), or_else("40"), fixed_in_restart),
           reference({"body", &Volume::body}, "bodies",
                     "body to which the volume is fixed; mesh and shape are in its frame",
                     or_else_note("none: fixed in space"), fixed_in_restart),
           active(), stiffness(),
           number({"smoothing", &Volume::smoothing}, length,
                  "half width of the smooth onset of the contact force; 0: linear from the first touch",
                  at_least(0),
                  or_else_note("0.1 % of the contact diameter; 0.001 % with an automatic stiffness without "
                               "damping; between "
                               "bodies 0.1 % of the size of the body, at most 10 mm"),
                  fixed_in_restart),
           relative_damping(), friction(&Volume::friction)},
          either({{{"mesh", "scale", "closed", "sign", "smooth", "crease_angle_deg", "active"}, {"mesh"}},
                  "shape"})),
      "Volumes that lines must not penetrate, by name.", or_else("{}"));
}

}  // namespace hawser::model::schema_build
