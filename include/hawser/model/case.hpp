// The case as plain, checked data, in SI units and rad; objects refer to each other by name. Built by
// io::read_case, checked by model::check; independent of PETSc, MPI and YAML.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "hawser/base/shared.hpp"
#include "hawser/geometry/primitive_shape.hpp"
#include "hawser/geometry/sign_test.hpp"
#include "hawser/kernels/contact_force_table.hpp"
#include "hawser/kernels/pipe_codes.hpp"
#include "hawser/kernels/plastic_bending.hpp"
#include "hawser/kernels/response_curve.hpp"
#include "hawser/math/types.hpp"
#include "hawser/model/bend_stiffener.hpp"
#include "hawser/model/contact_properties.hpp"
#include "hawser/model/entries.hpp"
#include "hawser/model/environment.hpp"
#include "hawser/model/event.hpp"
#include "hawser/model/feeder.hpp"
#include "hawser/model/flow_on_body.hpp"
#include "hawser/model/line_end.hpp"
#include "hawser/model/links.hpp"
#include "hawser/model/name_index.hpp"
#include "hawser/model/platform.hpp"
#include "hawser/model/prescribed_motion.hpp"
#include "hawser/model/supports.hpp"
#include "hawser/model/value.hpp"

namespace hawser::model {

enum class LineKind { beam, cable };

struct LineType {
  std::string name;
  LineKind kind = LineKind::beam;  // `bending: false` makes a cable: EA only, may go slack
  double outer_diameter = 0;       // m
  double contact_diameter = 0;     // m, default outer_diameter
  double wall_diameter = 0;    // m, outside of the steel wall under the coatings of a pipe; 0: outer_diameter
  double mass_per_length = 0;  // kg/m, in air, with contents and marine growth
  double EA = 0;               // N; with a table: its slope at zero strain
  double EI2 = 0, EI3 = 0;     // N m², about section axes 2 and 3; with a table: at zero curvature
  std::shared_ptr<const ResponseCurve> tension_table, moment_table;  // over strain, curvature; null: linear
  std::shared_ptr<const PlasticBending> plastic_bending;             // null: elastic
  double GJ = 0;                                                     // N m²
  double GA = 0;                       // N, shear stiffness; 0: rigid in shear (Euler-Bernoulli)
  Vec3 rotary_inertia = Vec3::Zero();  // kg m (per length), about axes 1 (along), 2, 3
  double stiffness_damping = 0;        // s, Rayleigh beta: damping = beta * material stiffness
  double breaking_load = 0;            // N; 0: unknown
  double minimum_bend_radius = 0;      // m, allowed minimum; 0: unknown
  double thermal_expansion = 0;        // 1/K
  std::optional<PipeSteel> steel;      // for pipes checked by codes
  PipeConditions conditions;           // loads and factors of those checks

  // In water. Axial drag acts on the surface area, pi times the drag diameter per length.
  double displaced_diameter = 0;  // m, of the displaced volume; 0: outer_diameter
  double drag_diameter = 0;       // m; 0: outer_diameter
  double Cd_normal = 1.2, Cd_axial = 0, Ca_normal = 1, Ca_axial = 0;
  double inner_diameter = 0;     // m, bore; 0: none
  double contents_density = 0;   // kg/m³
  double contents_pressure = 0;  // Pa above atmospheric, in the bore at the still water level

  double displaced() const { return displaced_diameter > 0 ? displaced_diameter : outer_diameter; }
  double dragged() const { return drag_diameter > 0 ? drag_diameter : outer_diameter; }
  // Time [s] in which an axial wave travels a length [m]: L / c, c = sqrt(EA / m).
  double wave_time(double length) const { return length * std::sqrt(mass_per_length / EA); }
  double smallest_bending_stiffness() const {  // N m², 0 for a cable
    return kind == LineKind::beam ? std::min(EI2, EI3) : 0.0;
  }
};

// Simple model of a body in water: Morison's equation along the body axes.
struct BodyInWater {
  double volume = 0, height = 0;    // m³ fully submerged; m, height over which it becomes submerged
  Vec3 centre = Vec3::Zero();       // m, centre of buoyancy, body frame
  Vec3 drag_centre = Vec3::Zero();  // m, body frame
  Vec3 drag_area = Vec3::Zero();    // m², drag coefficient times area, along the body axes
  Vec3 added_mass = Vec3::Zero();   // kg, along the body axes
};

// Volumes that displace water: closed surfaces that move with their body.
struct BodyHull {
  std::vector<std::string> volumes;
  bool wave_pressure = true;  // Froude-Krylov pressure on the wetted surface
  // Hydrostatic stiffness in heave, roll and pitch [N/m, N m/rad] about the centre of mass at the position in
  // the case; set after the volumes are read.
  Vec3 restoring = Vec3::Zero();
};

// Straight, slender circular member of a body. Morison's equation acts across it; axial forces act on the
// area of one end.
struct BodyMember {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // m, body frame
  double diameter = 0;                          // m
  double drag = 1, axial_drag = 0;              // Cd; axial: of rho/2 pi D²/4
  double added = 1, axial_added = 0;            // Ca; axial: of rho pi D³/12
};

// Full 6x6 mass matrix, for bodies that mass and moments of inertia do not describe.
struct MassMatrix {
  Mat6 rows = Mat6::Zero();   // kg, kg m, kg m², axes of the body
  Vec3 about = Vec3::Zero();  // m, body frame
};

// A body that moves by its own equations of motion.
struct BodyMass {
  double mass = 0;               // kg
  Vec3 inertia = Vec3::Zero();   // kg m², about the centre of mass, along the body's axes
  Vec3 products = Vec3::Zero();  // kg m², Ixy, Iyz, Ixz: off the diagonal
  Vec3 centre = Vec3::Zero();    // m, centre of mass, body frame
  bool centre_given = false;
  Shared<MassMatrix> matrix;    // replaces inertia and products, which are derived from it
  Mat6 coupled = Mat6::Zero();  // rest of `matrix` beyond mass and inertia, about the centre of mass
  // Gravity acts; else unmodelled forces balance the weight. Default true with `hydrodynamics` or `hull`.
  bool weight = false;
  Vec3 velocity = Vec3::Zero();                           // m/s, of the centre of mass at t = 0, space axes
  Vec3 angular_velocity = Vec3::Zero();                   // rad/s, at t = 0, body axes
  Vec3 stiffness = Vec3::Zero(), damping = Vec3::Zero();  // N/m, N s/m: towards the prescribed `motion`
  Vec3 turning_stiffness = Vec3::Zero(), turning_damping = Vec3::Zero();  // N m/rad, N m s/rad, body axes
  // In addition, about the body's origin in axes of the body at rest: N/m, N, N m/rad; N s/m, N s, N m s.
  Mat6 stiffness_matrix = Mat6::Zero();
  Mat6 damping_matrix = Mat6::Zero();
  Shared<BodyInWater> in_water;
  Shared<BodyHydrodynamics> hydrodynamics;
  Shared<BodyHull> hull;
  std::vector<BodyMember> members;
  Shared<FlowOnBody> wind, current;
  Shared<DynamicPositioning> positioning;
  std::vector<BodyLoad> loads;

  Mat3 tensor() const;  // kg m², from inertia and products
  // Of all springs, without the couplings of the matrix: N/m, N m/rad.
  Vec3 spring_stiffness() const { return stiffness + stiffness_matrix.diagonal().head<3>(); }
  Vec3 spring_turning_stiffness() const { return turning_stiffness + stiffness_matrix.diagonal().tail<3>(); }
};

// Attaches a body to a line node: its frame is that of the node, first axis along the line.
struct Ride {
  std::string line;
  double at = 0;  // m, arc length from end A
  // True if position and rotation are given in space at the start; the body is then fixed to the node in that
  // pose.
  bool placed_in_space = false;
};

struct Body {
  std::string name;
  Vec3 position = Vec3::Zero();  // m, of the body's origin at t = 0
  Vec3 rotation = Vec3::Zero();  // rad, rotation vector at t = 0
  Motion motion;
  double ramp = 0;  // s, smooth start of the motion (quintic), 0: none; default of responses: of the waves
  Shared<Drift> drift;
  Shared<BodyMass> mass;  // none: the motion is prescribed
  Shared<Ride> ride;      // none: not on a line; position and rotation are relative to the node
};

struct Box {
  Vec3 lower, upper;  // m, body frame
};

using hawser::SignTest;

struct Volume {
  std::string name;
  std::optional<Primitive> shape;         // exact shape, body frame; none: a mesh
  std::string mesh;                       // absolute path of an STL, OBJ or PLY file
  double scale = 1;                       // mesh units to m
  bool closed = false;                    // an open mesh is refused
  SignTest sign = SignTest::automatic;    // of a mesh
  bool smooth = true;                     // curved surfaces have curved facets
  double crease_angle = 40 * M_PI / 180;  // rad, edges sharper than this stay
  std::string body;                       // empty: fixed in space
  std::optional<Box> active_box;          // only triangles with all corners inside take part in contact
  std::string active_part;                // name of a mesh part (OBJ group, STL solid); empty: all
  StiffnessBasis basis = StiffnessBasis::automatic;
  double normal_stiffness = 0;  // N/m, N/m² or N/m³ by basis; with a table: its largest slope
  std::shared_ptr<const ContactForceTable> force_table;  // N, N/m or N/m² by basis; null: linear
  double allowed_penetration = 0;                        // m, for the automatic stiffness; 0: default
  std::optional<double> smoothing;  // m, half width of the C1 ramp; 0: linear law; none: default
  double relative_damping = 0;      // zeta of the contact spring
  Friction friction;
  bool roller = false;  // part of `supports`: touches lines only

  bool is_plane() const { return shape && std::holds_alternative<PlaneShape>(*shape); }
  // Largest depth of a line of this radius for which the contact law holds, m: the radius, or the last row of
  // a table; no limit for a plane with a given stiffness. automatic: the program chooses the stiffness.
  double depth_limit(double line_radius, bool automatic) const {
    if (!automatic && is_plane()) return std::numeric_limits<double>::infinity();
    return force_table ? std::max(line_radius, force_table->rows().back().first) : line_radius;
  }
};

struct Section {
  std::string type;
  double length = 0;  // m, unstretched
  int elements = 0;
  double grading = 1;  // length of the last element over that of the first
};

enum class EndKind { free, anchor, body, joint };

struct End {
  EndKind kind = EndKind::free;
  Vec3 at = Vec3::Zero();           // m; anchor: in space, body: in its frame
  std::string carrier;              // name of the body or joint that holds the end
  std::optional<Vec3> direction;    // unit tangent from A to B, same frame as `at`
  bool clamped = false;             // rotation tied as well
  double rotational_stiffness = 0;  // N m/rad, a spring towards `direction`
  // Length from this end [m] without contact with volumes; none: the part next to the end that is inside a
  // volume at the start has no contact with that volume.
  std::optional<double> no_contact_within;
  Shared<Feed> feed;  // pays out or hauls in the line at this end
};

// Free connection of line ends: pinned, or rigid for lines with bending stiffness.
struct Joint {
  std::string name;
  Vec3 start = Vec3::Zero();  // m, position at the start of statics
  bool rigid = false;         // lines with bending stiffness keep their initial angles
};

struct PointMass {
  double at = 0;    // m, arc length from end A
  double mass = 0;  // kg
  // In water: a spherical clump weight or buoy.
  double volume = 0;     // m³, displaced volume
  double drag_area = 0;  // m², drag coefficient times area
  double Ca = 0;         // added mass over displaced mass of water
};
struct DistributedLoad {
  Vec3 per_length = Vec3::Zero();  // N/m, dead load per unstretched length
  double from = 0, to = -1;        // m, arc length; to < 0: end B
  double ramp = 0;                 // s, smooth start in dynamics; 0: acts from statics on
  int order = 0;                   // place in the file's list of loads, for messages
};
struct PointLoad {
  double at = 0;               // m, arc length from end A
  Vec3 force = Vec3::Zero();   // N, dead
  Vec3 moment = Vec3::Zero();  // N m, dead (space axes)
  double ramp = 0;             // s
  int order = 0;               // place in the file's list of loads, for messages
};

// Stretch of a line buried in soil: an elastic-plastic spring along the line and one across it, attached
// where the line starts.
struct Buried {
  double from = 0, to = 0;                     // m, arc length
  double axial = 0, normal = 0;                // N/m, largest soil resistance
  double axial_length = 0, normal_length = 0;  // m, displacement at which it is reached
};

// other_run: the final shape of another run.
enum class Start { automatic, catenary, hanging, straight, points, other_run };

// Node positions of a line at the end of another run.
struct PreviousShape {
  std::string file;
  std::vector<double> arc;     // m from end A, increasing
  std::vector<Vec3> position;  // m
  std::vector<Quat> rotation;  // empty: unknown
};

// Condition on the static equilibrium of a line that the length of one section is adjusted to meet.
struct LengthTarget {
  enum class Kind { tension, declination, touchdown, laid_length };
  Kind kind = Kind::tension;
  double value = 0;                       // N; rad; m, arc length of the touchdown point; m
  LineEnd line_end = LineEnd::B;          // at which the value is, or from which it is measured
  int section = 0;                        // whose length is adjusted
  double min_length = 0, max_length = 0;  // m, bounds of its length
};

struct Line {
  std::string name;
  std::vector<Section> sections;
  End end_a, end_b;
  const End& end(LineEnd e) const { return e == LineEnd::B ? end_b : end_a; }
  const Section& end_section(LineEnd e) const { return e == LineEnd::B ? sections.back() : sections.front(); }
  std::vector<PointMass> masses;
  std::vector<BendStiffener> bend_stiffeners;
  std::vector<DistributedLoad> loads;
  std::vector<PointLoad> point_loads;
  std::vector<Buried> buried;  // in order of arc length, without overlap
  // Temperature rise [K] since the line was cut to length, over arc length from end A [m], increasing; linear
  // between rows, constant beyond; empty: none.
  std::vector<std::pair<double, double>> temperature_change;
  Start start = Start::automatic;
  // True if the start shape is computed from the ends and the length.
  bool starts_by_itself() const { return start == Start::automatic || start == Start::catenary; }
  std::vector<Vec3> points;  // for Start::points: polyline along which the line is laid
  std::shared_ptr<const PreviousShape> previous_shape;  // for Start::other_run
  Shared<LengthTarget> target;
  // For a part of a line that events cut (cut_lines.hpp): the line as given, which defines the start shape,
  // and the arc length from its end A at which this part begins [m].
  std::shared_ptr<const Line> given;
  double from = 0;
  const Line& as_given() const { return given ? *given : *this; }
};

// Means over the arc lengths [from, to] of a line, m: temperature change [K] and thermal strain.
double mean_temperature_change(const Line& line, double from, double to);
double thermal_strain(const LineType& type, const Line& line, double from, double to);

// gap: springs at the nodes along directions fixed at the start; for comparison.
enum class ContactMethod { nodes, line, gap };

// Law of contact between lines.
struct LinePairSettings {
  StiffnessBasis basis = StiffnessBasis::automatic;  // per length, per area or automatic
  double normal_stiffness = 0;                       // N/m² or N/m³ by basis
  std::optional<double> smoothing;                   // m, half width of the C1 ramp; none: default
  double relative_damping = 0;                       // zeta of the contact spring
  double friction = 0;                               // Coulomb coefficient, the same in all directions
  double mobilisation_length = 0;                    // m; 0: default of 1 % of the mean contact diameter
  double shear_stiffness = 0;  // same basis as the normal stiffness; 0: use mobilisation_length
};

struct BetweenLines {
  bool enabled = true, self = true;
  LinePairSettings general;
  struct Tuned {
    std::string first, second;
    LinePairSettings settings;
  };
  std::vector<Tuned> pairs;
  std::vector<std::pair<std::string, std::string>> exclude;
  std::vector<std::pair<std::string, std::string>>
      crossings;  // crossing lines: the first starts above the second
};

struct Contact {
  ContactMethod method = ContactMethod::line;
  bool rolling = false;             // friction acts at the lines' surface and turns them about their axes
  double warned_penetration = 0.1;  // warning limit of the penetration as a fraction of the radius
  bool all_lines = true, all_volumes = true;
  std::vector<std::string> lines, volumes;  // used if not all take part
  BetweenLines between_lines;

  bool has_friction(const std::vector<Volume>& volumes) const;  // anywhere
  bool takes_part(const Line& line) const;
  bool takes_part(const Volume& volume) const;
};

// When damped relaxation precedes Newton's method in statics: after a failure, always or never.
enum class Relaxation { automatic, always, never };

struct Statics {
  bool enabled = true;
  double tolerance = 1e-8;  // residual relative to the internal forces
  int max_iterations = 1000;
  Relaxation relaxation = Relaxation::automatic;
  int relaxation_steps = 5000;  // limit
  // Friction on volumes and between lines, from the start shape on; none: only if statics fails without it.
  std::optional<bool> contact_friction;
};

struct Dynamics {
  bool enabled = false;
  double duration = 0;                // s
  double step = 0;                    // s; 0: automatic
  double max_step = 0, min_step = 0;  // s; 0: defaults
  bool resolve_impacts = true;        // fixed steps are subdivided at impacts
  double rho_infinity = 0.8;
  double tolerance = 1e-8;     // of the residual, as in statics
  double error_tolerance = 0;  // m, local error per step in automatic stepping; 0: default
};

struct HistoryPoint {
  std::string line;  // or a body with mass, or the contact forces of a volume:
  std::string body, volume;
  double at = 0;     // m, arc length from end A
  std::string name;  // default "<line>@<at>"
};

// Definition of one clash in the clash report, and length of its table.
struct ClashOutput {
  bool enabled = true;
  double merge_gap = 0.1;   // s: a shorter separation does not end a clash
  double merge_length = 0;  // m: places closer along a line count as one; 0: 4 contact diameters
  int rows = 20;            // of the table printed at the end of the run
};

// Smallest distance between two surfaces, monitored at every step.
struct Clearance {
  std::string line, other_line, volume;  // from the line to the other line or the volume
  std::string name;                      // default "<line> to <other>"
};

struct Output {
  std::string file;             // absolute path of the .h5; default <case>.h5 beside the case
  double every = 0;             // s between fields; 0: 100 outputs per run
  double checkpoint_every = 0;  // s; 0: with field outputs, at most 2 % of the computing time, and at the end
  bool xdmf = true;
  bool single_precision = false;  // for fields
  std::vector<HistoryPoint> histories;
  double history_every = 0;    // s between rows of histories; 0: every step
  bool touchdowns = true;      // history of each line's touchdown points
  bool statistics = true;      // of node fields, over all steps
  double statistics_from = 0;  // s, start of the statistics
  ClashOutput clashes;
  std::vector<Clearance> clearances;
};

struct Farm;

// What a case is read from.
struct CaseDocument {
  std::string path, directory, text;      // text as read
  std::string file;                       // as given by the user
  std::vector<std::string> inputs;        // absolute paths of the case file and the files that it reads
  std::shared_ptr<const Value> tree;      // parsed keys, for the line numbers of refuse(); null: none
  std::shared_ptr<const Farm> farm;       // platforms read from other files (farm.hpp); null: none
  std::vector<std::string> changes;       // KEY=VALUE of the command line, applied to the file's text
  std::vector<std::string> change_notes;  // effects of `changes`, one sentence each
};

struct Case : CaseDocument {
  Case() = default;
  explicit Case(CaseDocument document) : CaseDocument(std::move(document)) {}

  std::string title;
  Environment environment;
  std::vector<LineType> line_types;
  Entries<Body> bodies;
  std::vector<Volume> volumes;
  std::vector<SupportBox> supports;  // in the order in which lines pass over them
  std::vector<Joint> joints;
  Entries<Line> lines;
  std::vector<Link> links;
  Contact contact;
  Statics statics;
  std::vector<std::string> stages;  // of statics, each from the equilibrium before; none: one without a name
  Dynamics dynamics;
  std::vector<Event> events;
  Output output;
  std::vector<std::string> notes;  // repairs and warnings of the reader, one sentence each

  const LineType& line_type(const std::string& name) const;  // throws std::out_of_range
  const Line& line(const std::string& name) const;           // throws std::out_of_range
  int body_index(const std::string& name) const;             // -1: none (fixed in space)
  int line_index(const std::string& name) const;             // throws std::out_of_range
  const Joint& joint(const std::string& name) const;         // throws std::out_of_range
  // True if lines do not touch this volume until an event switches the contact on.
  bool off_at_start(const Volume& volume) const;
  bool rides(int body) const { return body >= 0 && bodies[body].ride.has_value(); }
  // Throws InputError "file:line: key: why".
  [[noreturn]] void refuse(const std::string& key, const std::string& why) const;
  // Message of refuse(): file, line and key before `why`.
  std::string refusal(const std::string& key, const std::string& why) const;
  template <class First, class... More>
  [[noreturn]] void refuse(const std::string& key, fmt::format_string<First, More...> why, First&& first,
                           More&&... more) const {
    refuse(key, fmt::format(why, std::forward<First>(first), std::forward<More>(more)...));
  }
  bool floats(int body) const { return body >= 0 && bodies[body].mass.has_value(); }
  // True if both ends of the line are anchored or on bodies with prescribed motion, and neither is fed: its
  // tension depends on its length.
  bool holds_both_ends(const Line& line) const;
  // Frees the lines of which `kept` is false, except those that other objects of the case name, and bodies
  // with prescribed motion that neither the remaining lines nor other objects name; of all, their names and
  // lines in the file.
  void forget_lines_and_bodies(const std::vector<bool>& kept);

 private:
  NameIndex type_at_, line_at_, body_at_, joint_at_;
};

}  // namespace hawser::model
