// The case as plain, checked data. SI units; angles in rad; names refer to names.
// Built by io::read_case, checked by model::check; nothing here knows PETSc, MPI or YAML.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "hawser/geometry/primitive_shape.hpp"
#include "hawser/geometry/sign_test.hpp"
#include "hawser/kernels/contact_force_table.hpp"
#include "hawser/kernels/motion.hpp"
#include "hawser/kernels/pipe_codes.hpp"
#include "hawser/kernels/plastic_bending.hpp"
#include "hawser/kernels/response_curve.hpp"
#include "hawser/math/types.hpp"
#include "hawser/model/bend_stiffener.hpp"
#include "hawser/model/contact_properties.hpp"
#include "hawser/model/environment.hpp"
#include "hawser/model/event.hpp"
#include "hawser/model/feeder.hpp"
#include "hawser/model/flow_on_body.hpp"
#include "hawser/model/links.hpp"
#include "hawser/model/name_index.hpp"
#include "hawser/model/platform.hpp"
#include "hawser/model/supports.hpp"
#include "hawser/model/value.hpp"

namespace hawser::model {

enum class LineKind { beam, cable };

struct LineType {
  std::string name;
  LineKind kind = LineKind::beam;  // `bending: false` makes a cable: EA only, may go slack
  double outer_diameter = 0;       // m
  double contact_diameter = 0;     // m, default outer_diameter
  double wall_diameter = 0;        // m, outside of the wall under the coatings of a pipe; 0: outer_diameter
  double mass_per_length = 0;      // kg/m, in air, with contents and marine growth
  double EA = 0;                   // N; of a table its slope at no strain
  double EI2 = 0, EI3 = 0;         // N m², about the section's axes 2 and 3; of a table: at no curvature
  std::shared_ptr<const ResponseCurve> tension_table, moment_table;  // over strain, curvature; null: linear
  std::shared_ptr<const PlasticBending> plastic_bending;             // null: elastic
  double GJ = 0;                                                     // N m²
  double GA = 0;                       // N, shear stiffness; 0: rigid in shear (Euler-Bernoulli)
  Vec3 rotary_inertia = Vec3::Zero();  // kg m (per length), about axes 1 (along), 2, 3
  double stiffness_damping = 0;        // s, Rayleigh beta: damping = beta * material stiffness
  double breaking_load = 0;            // N; 0: not known
  double minimum_bend_radius = 0;      // m, that the type allows; 0: not known
  double thermal_expansion = 0;        // 1/K
  std::optional<PipeSteel> steel;      // of a pipe that is judged by codes
  PipeConditions conditions;           // likewise

  // In water. The axial drag acts on the skin, pi times the drag diameter.
  double displaced_diameter = 0;  // m, of the volume that water is driven out of; 0: outer_diameter
  double drag_diameter = 0;       // m; 0: outer_diameter
  double Cd_normal = 1.2, Cd_axial = 0, Ca_normal = 1, Ca_axial = 0;
  double inner_diameter = 0;     // m, of the bore; 0: none
  double contents_density = 0;   // kg/m³
  double contents_pressure = 0;  // Pa above the atmosphere, in the bore at the still water level

  double displaced() const { return displaced_diameter > 0 ? displaced_diameter : outer_diameter; }
  double dragged() const { return drag_diameter > 0 ? drag_diameter : outer_diameter; }
  // s, in which an axial wave passes a length [m] of it: L / c, with c = sqrt(EA / m).
  double wave_time(double length) const { return length * std::sqrt(mass_per_length / EA); }
};

// u(t) for t >= 0, with u and its first two derivatives continuous.
struct ConstantMotion {
  Vec3 velocity = Vec3::Zero();  // m/s
  Vec3 axis = Vec3::UnitZ();     // unit, space-fixed, through the body's position
  double rate = 0;               // rad/s
};
struct HarmonicMotion {           // offset(t) = amplitude * sin(2 pi t / period + phase), componentwise
  Vec3 amplitude = Vec3::Zero();  // m
  Vec3 rotation_amplitude = Vec3::Zero();  // rad, rotation vector
  double period = 1;                       // s
  Vec3 phase = Vec3::Zero();               // rad
  Vec3 rotation_phase = Vec3::Zero();
};
struct TableMotion {
  std::vector<double> time;    // s, increasing
  std::vector<Vec3> offset;    // m
  std::vector<Vec3> rotation;  // rad, rotation vector (may be empty)
  BetweenRows between = BetweenRows::spline;
  bool of_waves = false;  // the rows are responses to the waves of the case
};
using Motion = std::variant<std::monostate, ConstantMotion, HarmonicMotion, TableMotion>;

// A slow motion that carries the body with its `motion`: the sum of three.
struct Drift {
  Vec3 offset = Vec3::Zero(), rotation = Vec3::Zero();  // m; rad, rotation vector
  HarmonicMotion harmonic;
  TableMotion table;
  double ramp = 0;  // s, smooth start; 0: there from statics on
};

// A rigid body in water in the simple form: Morison's equation along its axes.
struct BodyInWater {
  double volume = 0, height = 0;    // m³ wholly under water; m, over which it gets wet
  Vec3 centre = Vec3::Zero();       // m, of buoyancy, body frame
  Vec3 drag_centre = Vec3::Zero();  // m, body frame
  Vec3 drag_area = Vec3::Zero();    // m², drag coefficients times areas, along the body's axes
  Vec3 added_mass = Vec3::Zero();   // kg, likewise
};

// A body that moves by its own equations.
// Volumes that displace water: closed surfaces that move with their body.
struct BodyHull {
  std::vector<std::string> volumes;
  bool wave_pressure = true;  // of Froude and Krylov, on the wetted surface
  // N/m, N m/rad: against heave, roll and pitch about the centre of mass where the case puts the body, once
  // the volumes are read.
  Vec3 restoring = Vec3::Zero();
};

// A straight round part of a body that is slender beside the waves, on which water acts across it by
// Morison's equation, and along it on the area of an end.
struct BodyMember {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // m, body frame
  double diameter = 0;                          // m
  double drag = 1, axial_drag = 0;              // Cd; of rho/2 pi D²/4
  double added = 1, axial_added = 0;            // Ca; of rho pi D³/12
};

// What a body resists acceleration with, where that is more than mass and moments of inertia.
struct MassMatrix {
  Mat6 rows = Mat6::Zero();   // kg, kg m, kg m², axes of the body
  Vec3 about = Vec3::Zero();  // m, body frame
};

struct BodyMass {
  double mass = 0;               // kg
  Vec3 inertia = Vec3::Zero();   // kg m², about the centre of mass, along the body's axes
  Vec3 products = Vec3::Zero();  // kg m², Ixy, Iyz, Ixz: off the diagonal
  Vec3 centre = Vec3::Zero();    // m, centre of mass, body frame
  bool centre_given = false;
  std::optional<MassMatrix> matrix;      // in the place of inertia and products, which are made of it
  Mat6 coupled = Mat6::Zero();           // what it has beyond them and the mass, about the centre of mass
  bool weight = false;                   // gravity acts; else something not modelled carries it
  Vec3 velocity = Vec3::Zero();          // m/s, of the centre of mass at t = 0, space axes
  Vec3 angular_velocity = Vec3::Zero();  // rad/s, at t = 0, body axes
  Vec3 stiffness = Vec3::Zero(), damping = Vec3::Zero();  // N/m, N s/m: towards where `motion` wants it
  Vec3 turning_stiffness = Vec3::Zero(), turning_damping = Vec3::Zero();  // N m/rad, N m s/rad, body axes
  std::optional<BodyInWater> in_water;
  std::optional<BodyHydrodynamics> hydrodynamics;
  std::optional<BodyHull> hull;
  std::vector<BodyMember> members;
  std::optional<FlowOnBody> wind, current;
  std::optional<DynamicPositioning> positioning;
  std::vector<BodyLoad> loads;

  Mat3 tensor() const;  // kg m², of inertia and products
};

// A body that rides on a line: its frame is that of the line's node there, first axis along the line.
struct Ride {
  std::string line;
  double at = 0;  // m, arc length from end A
  // The body's position and rotation are those in space at the start, from which on it is fixed to the node.
  bool drawn = false;
};

struct Body {
  std::string name;
  Vec3 position = Vec3::Zero();  // m, of the body's origin at t = 0
  Vec3 rotation = Vec3::Zero();  // rad, rotation vector at t = 0
  Motion motion;
  double ramp = 0;  // s, smooth start of the motion (quintic), 0: none
  std::optional<Drift> drift;
  std::optional<BodyMass> mass;  // without it the motion is prescribed
  std::optional<Ride> on;        // or that of a line; position and rotation are then seen from there
};

struct Box {
  Vec3 lower, upper;  // m, body frame
};

using hawser::SignTest;

struct Volume {
  std::string name;
  std::optional<Primitive> shape;         // exact shape, body frame; or else a mesh:
  std::string mesh;                       // absolute path of an STL, OBJ or PLY file
  double scale = 1;                       // mesh units to m
  bool closed = false;                    // an open mesh is refused
  SignTest sign = SignTest::automatic;    // of a mesh
  bool smooth = true;                     // facets of curved surfaces are curved
  double crease_angle = 40 * M_PI / 180;  // rad, edges sharper than this stay
  std::string body;                       // empty: fixed in space
  std::optional<Box> active_box;          // only triangles with all corners inside take part
  std::string active_part;                // name of a mesh part (OBJ group, STL solid); empty: all
  StiffnessBasis basis = StiffnessBasis::automatic;
  double normal_stiffness = 0;  // N/m, N/m² or N/m³ by basis; of a table its largest slope
  std::shared_ptr<const ContactForceTable> force_table;  // N, N/m or N/m² by basis; null: by stiffness
  double allowed_penetration = 0;                        // m, of an automatic stiffness; 0: default
  std::optional<double> smoothing;  // m, half width of the C1 ramp; 0: linear law; none: default
  double relative_damping = 0;      // zeta of the contact spring
  Friction friction;
  bool roller = false;  // of `supports`: touches lines only
};

struct Section {
  std::string type;
  double length = 0;  // m, unstretched
  int elements = 0;
  double grading = 1;  // length of the last element over the first
};

enum class EndKind { free, anchor, body, joint };

struct End {
  EndKind kind = EndKind::free;
  Vec3 at = Vec3::Zero();           // m: in space (anchor) or in the body's frame (body)
  std::string body;                 // or the joint
  std::optional<Vec3> direction;    // unit tangent from A to B, same frame as `at`
  bool clamped = false;             // rotation tied as well
  double rotational_stiffness = 0;  // N m/rad, a spring towards `direction`
  // m of line from this end on without contact with volumes; none: what is inside one at the start has none
  // with that.
  std::optional<double> no_contact_within;
  std::optional<Feed> feed;  // pays the line out here or hauls it in
};

// Where ends of lines are joined to each other, free to move: pinned, or what bends rigidly.
struct Joint {
  std::string name;
  Vec3 start = Vec3::Zero();  // m, where statics starts from
  bool rigid = false;         // lines that resist bending keep the angles that they start with
};

struct PointMass {
  double at = 0;    // m, arc length from end A
  double mass = 0;  // kg
  // In water: a clump weight or a buoy, round.
  double volume = 0;     // m³, displaced
  double drag_area = 0;  // m², drag coefficient times area
  double Ca = 0;         // added mass over displaced mass
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

// A stretch of a line in the soil. It stays where it starts, until the soil yields: a spring along the line
// and one across it, either way, up to a resistance.
struct Buried {
  double from = 0, to = 0;                     // m, arc length
  double axial = 0, normal = 0;                // N/m, that the soil resists with at most
  double axial_length = 0, normal_length = 0;  // m, after which it does
};

// other_run: as another run left it.
enum class Start { automatic, catenary, hanging, straight, points, other_run };

// Nodes of a line in another run.
struct PreviousShape {
  std::string file;
  std::vector<double> arc;     // m from end A, growing
  std::vector<Vec3> position;  // m
  std::vector<Quat> rotation;  // empty: not known
};

// What the static equilibrium of a line has to meet, by the length of one of its sections.
struct LengthTarget {
  enum class Kind { tension, declination, touchdown, laid_length };
  Kind kind = Kind::tension;
  double value = 0;            // N; rad; m, arc length of the touchdown point; m
  bool at_a = false;           // at end A, or seen from there; else end B
  int section = 0;             // of which the length is sought
  double least = 0, most = 0;  // m, lengths of it between which it is sought
};

struct Line {
  std::string name;
  std::vector<Section> sections;
  End end_a, end_b;
  const End& end(bool b) const { return b ? end_b : end_a; }
  std::vector<PointMass> masses;
  std::vector<BendStiffener> bend_stiffeners;
  std::vector<DistributedLoad> loads;
  std::vector<PointLoad> point_loads;
  std::vector<Buried> buried;  // in order of arc length, apart from each other
  // K, warmer than when cut to length, over arc length from end A [m], growing; straight between the rows,
  // constant beyond; empty: none.
  std::vector<std::pair<double, double>> temperature_change;
  Start start = Start::automatic;
  // Its start shape follows from its ends and its length.
  bool starts_by_itself() const { return start == Start::automatic || start == Start::catenary; }
  std::vector<Vec3> points;                             // for Start::points: polyline the line is laid along
  std::shared_ptr<const PreviousShape> previous_shape;  // for Start::other_run
  std::optional<LengthTarget> target;
  // Of a part of a line that events cut (cut_lines.hpp): the line as given, whose start shape it begins with,
  // and where this part begins [m from its end A].
  std::shared_ptr<const Line> whole;
  double from = 0;
};

// Mean over the arc [from, to] of a line, m: of its temperature change, K, and of what that lengthens it by.
double mean_temperature_change(const Line& line, double from, double to);
double thermal_strain(const LineType& type, const Line& line, double from, double to);

// gap is there to be compared with: at the nodes, a spring along a direction that is chosen at the start.
enum class ContactMethod { nodes, line, gap };

// How lines touch lines.
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
      over;  // where they cross, the first starts over the second
};

struct Contact {
  ContactMethod method = ContactMethod::line;
  bool rolling = false;             // friction acts at the lines' surface and turns them about their axes
  double warned_penetration = 0.1;  // share of the radius
  bool all_lines = true, all_volumes = true;
  std::vector<std::string> lines, volumes;  // when not all
  BetweenLines between_lines;

  bool has_friction(const std::vector<Volume>& volumes) const;  // somewhere
  bool takes_part(const Line& line) const;
  bool takes_part(const Volume& volume) const;
};

// When lines come to rest by damped motion before Newton's iteration: where that alone fails, always, never.
enum class Relaxation { automatic, always, never };

struct Statics {
  bool enabled = true;
  double tolerance = 1e-8;  // residual over the size of the internal forces
  int max_iterations = 500;
  Relaxation relaxation = Relaxation::automatic;
  int relaxation_steps = 5000;    // at most
  bool contact_friction = false;  // of volumes and between lines, from the start shape on
};

struct Dynamics {
  bool enabled = false;
  double duration = 0;                // s
  double step = 0;                    // s; 0: automatic
  double max_step = 0, min_step = 0;  // s; 0: defaults
  bool resolve_impacts = true;        // fixed steps are divided at impacts
  double rho_infinity = 0.8;
  double tolerance = 1e-8;     // of the residual, as in statics
  double error_tolerance = 0;  // m, local error a step in automatic stepping; 0: default
};

struct HistoryPoint {
  std::string line;  // or a body with mass, or what a volume exerts on lines:
  std::string body, volume;
  double at = 0;     // m, arc length from end A
  std::string name;  // default "<line>@<at>"
};

// What the clash report takes for one clash, and how much of it is printed.
struct ClashOutput {
  bool enabled = true;
  double merge_gap = 0.1;   // s: a pair that parts for less is still in the same clash
  double merge_length = 0;  // m: places nearer along a line are one; 0: 4 contact diameters
  int rows = 20;            // of the table at the end of the run
};

// The smallest distance between two surfaces, kept at every step.
struct Clearance {
  std::string line, other_line, volume;  // of the line to the other line or the volume
  std::string name;                      // default "<line> to <other>"
};

struct Output {
  std::string file;             // absolute path of the .h5; default <case>.h5 beside the case
  double every = 0;             // s between fields; 0: 100 outputs a run
  double checkpoint_every = 0;  // s; 0: with every field output
  bool xdmf = true;
  bool single_precision = false;  // of fields
  std::vector<HistoryPoint> histories;
  double history_every = 0;    // s between rows of histories; 0: every step
  bool touchdowns = true;      // a history of each line's touchdown points
  bool statistics = true;      // of node fields, over every step
  double statistics_from = 0;  // s, from which they count
  ClashOutput clashes;
  std::vector<Clearance> clearances;
};

struct Farm;

struct Case {
  std::string path, directory, text;  // as read
  std::string file;                   // as the user named it
  std::vector<std::string> inputs;    // absolute paths of the case file and the files that it reads
  std::shared_ptr<const Value> tree;  // its keys, for the lines of refuse(); null: none
  std::shared_ptr<const Farm> farm;   // platforms that it has by other files (farm.hpp); null: none
  std::string title;
  Environment environment;
  std::vector<LineType> line_types;
  std::vector<Body> bodies;
  std::vector<Volume> volumes;
  std::vector<SupportBox> supports;  // in the order in which lines pass over them
  std::vector<Joint> joints;
  std::vector<Line> lines;
  std::vector<Link> links;
  Contact contact;
  Statics statics;
  std::vector<std::string>
      stages;  // of statics, each from the rest of the one before; none: one without a name
  Dynamics dynamics;
  std::vector<Event> events;
  Output output;
  std::vector<std::string> notes;         // repairs and warnings of the reader, a sentence each
  std::vector<std::string> changes;       // KEY=VALUE of the command line, applied to the file's text
  std::vector<std::string> change_notes;  // what each of them has changed, a sentence each

  const LineType& line_type(const std::string& name) const;  // throws std::out_of_range
  const Line& line(const std::string& name) const;           // likewise
  int body_index(const std::string& name) const;             // -1: none (fixed in space)
  int line_index(const std::string& name) const;             // throws std::out_of_range
  const Joint& joint(const std::string& name) const;         // throws std::out_of_range
  // Whether lines do not touch this volume until an event switches that on.
  bool off_at_start(const Volume& volume) const;
  bool rides(int body) const { return body >= 0 && bodies[body].on.has_value(); }
  // Throws InputError "file:line: key: why".
  [[noreturn]] void refuse(const std::string& key, const std::string& why) const;
  // The sentence of refuse(): file, line and key before `why`.
  std::string refusal(const std::string& key, const std::string& why) const;
  template <class First, class... More>
  [[noreturn]] void refuse(const std::string& key, fmt::format_string<First, More...> why, First&& first,
                           More&&... more) const {
    refuse(key, fmt::format(why, std::forward<First>(first), std::forward<More>(more)...));
  }
  bool floats(int body) const { return body >= 0 && bodies[body].mass.has_value(); }

 private:
  NameIndex type_at_, line_at_, body_at_, joint_at_;
};

}  // namespace hawser::model
